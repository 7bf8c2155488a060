// SPDX-License-Identifier: MIT
#pragma once

#include "lab/vk/device.h"

namespace reprise::lab {

// Bytes read plus bytes written a second by vkCmdCopyBuffer between two device buffers that no
// cache holds; best of several.
double measureCopyBandwidth(Device& device);

}  // namespace reprise::lab
