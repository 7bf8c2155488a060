// SPDX-License-Identifier: MIT
// Debian ships volk as source; this is the one file that holds its definitions.
#define VOLK_IMPLEMENTATION
#include <volk.h>
