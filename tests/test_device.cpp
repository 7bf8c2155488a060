// SPDX-License-Identifier: MIT
#include "test_device.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

namespace reprise::lab {

Device& testDevice() {
  static const std::unique_ptr<Device> device = [] {
    const bool validation = Device::validationAvailable();
    if (!validation) std::puts("note: no validation layer installed; running without");
    return std::make_unique<Device>(DeviceOptions{.validation = validation});
  }();
  return *device;
}

void expectNoValidationMessages() {
  static size_t seen = 0;
  const auto& messages = testDevice().validationMessages();
  for (; seen < messages.size(); ++seen) ADD_FAILURE() << messages[seen];
}

}  // namespace reprise::lab
