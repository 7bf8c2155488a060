// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "reprise/reprise.h"

namespace reprise {

// Thrown inside the library, turned into a result code and one message at the C boundary (api.cpp).
struct Error {
  RepriseResult result;
  std::string text;
};

[[noreturn]] inline void fail(RepriseResult result, std::string text) {
  throw Error{result, std::move(text)};
}

// `what` is the call or the object in words: "history image 'history color'".
inline void check(VkResult result, const std::string& what) {
  if (result == VK_SUCCESS) return;
  const bool memory =
      result == VK_ERROR_OUT_OF_HOST_MEMORY || result == VK_ERROR_OUT_OF_DEVICE_MEMORY;
  fail(memory ? REPRISE_ERROR_OUT_OF_MEMORY : REPRISE_ERROR_DEVICE,
       what + " failed with VkResult " + std::to_string(static_cast<int>(result)));
}

}  // namespace reprise
