// SPDX-License-Identifier: MIT
#include "lab/vk/timestamps.h"

namespace reprise::lab {

Timestamps::Timestamps(Device& device, uint32_t max_spans)
    : device_(device), max_spans_(max_spans) {
  VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = 2 * max_spans;
  check(vkCreateQueryPool(device.handle(), &info, nullptr, &pool_), "vkCreateQueryPool");
}

Timestamps::~Timestamps() {
  vkDestroyQueryPool(device_.handle(), pool_, nullptr);
}

void Timestamps::begin(VkCommandBuffer commands) {
  names_.clear();
  vkCmdResetQueryPool(commands, pool_, 0, 2 * max_spans_);
}

uint32_t Timestamps::reserve(const std::vector<std::string>& names) {
  const auto first = static_cast<uint32_t>(2 * names_.size());
  if (names_.size() + names.size() > max_spans_) throw DeviceError("too many time spans");
  names_.insert(names_.end(), names.begin(), names.end());
  return first;
}

void Timestamps::start(VkCommandBuffer commands, const std::string& name) {
  vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_, reserve({name}));
  // lavapipe takes a timestamp with its next flush, which may come after what is to be timed. A
  // barrier flushes.
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT,
                       VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0, nullptr, 0, nullptr);
}

void Timestamps::stop(VkCommandBuffer commands) {
  vkCmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, pool_,
                      static_cast<uint32_t>(2 * names_.size() - 1));
}

std::vector<std::pair<std::string, double>> Timestamps::milliseconds() const {
  std::vector<std::pair<std::string, double>> spans;
  std::vector<uint64_t> ticks(2 * names_.size());
  if (ticks.empty()) return spans;
  check(vkGetQueryPoolResults(device_.handle(), pool_, 0, static_cast<uint32_t>(ticks.size()),
                              ticks.size() * sizeof(uint64_t), ticks.data(), sizeof(uint64_t),
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "vkGetQueryPoolResults");
  const double ms_a_tick = static_cast<double>(device_.limits().timestampPeriod) * 1.0e-6;
  for (size_t i = 0; i < names_.size(); ++i) {
    spans.emplace_back(names_[i], static_cast<double>(ticks[2 * i + 1] - ticks[2 * i]) * ms_a_tick);
  }
  return spans;
}

}  // namespace reprise::lab
