// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lab/vk/device.h"

namespace reprise::lab {

// Named spans of GPU time within one submission.
class Timestamps {
 public:
  explicit Timestamps(Device& device, uint32_t max_spans = 64);
  ~Timestamps();
  Timestamps(const Timestamps&) = delete;
  Timestamps& operator=(const Timestamps&) = delete;

  // Before anything else in the command buffer.
  void begin(VkCommandBuffer commands);
  // What is recorded between start and stop is the span `name`.
  void start(VkCommandBuffer commands, const std::string& name);
  void stop(VkCommandBuffer commands);
  // For a library that writes its own: two queries for each name, from the index returned.
  uint32_t reserve(const std::vector<std::string>& names);
  VkQueryPool pool() const { return pool_; }

  // (name, ms) in the order recorded; after the submission has finished.
  std::vector<std::pair<std::string, double>> milliseconds() const;

 private:
  Device& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  uint32_t max_spans_;
  std::vector<std::string> names_;
};

}  // namespace reprise::lab
