// SPDX-License-Identifier: MIT
#pragma once

#include "lab/vk/device.h"

namespace reprise::lab {

// One device for a test executable, under validation where the layer is installed.
Device& testDevice();
// Fails the running test for each message of the validation layer since the last call.
void expectNoValidationMessages();

}  // namespace reprise::lab
