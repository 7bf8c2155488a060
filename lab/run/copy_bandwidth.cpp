// SPDX-License-Identifier: MIT
#include "lab/run/copy_bandwidth.h"

#include <algorithm>

#include "lab/vk/buffer.h"
#include "lab/vk/timestamps.h"

namespace reprise::lab {
namespace {

constexpr uint64_t kBytes = uint64_t{128} << 20;  // larger than last-level caches
constexpr int kTrials = 6;

}  // namespace

double measureCopyBandwidth(Device& device) {
  const Buffer from(device, kBytes, BufferKind::kDevice);
  const Buffer to(device, kBytes, BufferKind::kDevice);
  Timestamps timestamps(device, 1);
  double best_ms = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    device.submitAndWait([&](VkCommandBuffer commands) {
      timestamps.begin(commands);
      // Memory that was never written may be mapped to one page of zeros.
      if (trial == 0) vkCmdFillBuffer(commands, from.handle(), 0, kBytes, 0x3c003c00u);
      fullBarrier(commands);
      timestamps.start(commands, "copy");
      const VkBufferCopy region{0, 0, kBytes};
      vkCmdCopyBuffer(commands, from.handle(), to.handle(), 1, &region);
      timestamps.stop(commands);
    });
    const double ms = timestamps.milliseconds().front().second;
    if (trial > 0 && ms > 0.0) best_ms = best_ms == 0.0 ? ms : std::min(best_ms, ms);
  }
  return best_ms > 0.0 ? 2.0 * static_cast<double>(kBytes) / (0.001 * best_ms) : 0.0;
}

}  // namespace reprise::lab
