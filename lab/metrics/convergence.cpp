// SPDX-License-Identifier: MIT
#include "lab/metrics/convergence.h"

#include <algorithm>
#include <numeric>

namespace reprise::lab {

std::optional<Convergence> convergence(std::span<const double> psnr_db) {
  if (psnr_db.size() < kLeastConvergenceFrames) return std::nullopt;
  const std::span<const double> last = psnr_db.last(psnr_db.size() / 4);
  Convergence result;
  result.asymptote_db =
      std::accumulate(last.begin(), last.end(), 0.0) / static_cast<double>(last.size());
  // At least one of the last quarter is at or above its mean.
  const auto reached = std::find_if(psnr_db.begin(), psnr_db.end(), [&](double psnr) {
    return psnr >= result.asymptote_db - kConvergedWithin_db;
  });
  result.frames = static_cast<uint32_t>(reached - psnr_db.begin()) + 1;
  return result;
}

}  // namespace reprise::lab
