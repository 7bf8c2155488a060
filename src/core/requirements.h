// SPDX-License-Identifier: MIT
#pragma once

#include "reprise/reprise.h"

namespace reprise {

// Fills everything but `size`.
void describeRequirements(RepriseRequirements& requirements);
// Throws Error (REPRISE_ERROR_UNSUPPORTED) naming what the device lacks.
void checkDevice(VkInstance instance, VkPhysicalDevice physical_device,
                 PFN_vkGetInstanceProcAddr get_instance_proc_addr,
                 const RepriseRequirements& requirements);

}  // namespace reprise
