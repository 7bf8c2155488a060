// SPDX-License-Identifier: MIT
//
// Many-sample references of a scene's frames, kept on disk under a hash of everything that
// determines them, and extended when more samples are asked for.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lab/float_image.h"
#include "lab/render/renderer.h"

namespace reprise::lab {

enum class ReferenceFilter {
  kBox,      // 1 px
  kGaussian  // standard deviation 0.4737 px (Yang et al. 2009), not truncated
};

enum class ReferenceCoverage {
  kPixel,  // each sample sees what lies under it
  kCentre  // visibility at the pixel centre, shading at the sample: RenderSwitches::shading_only
};

struct ReferenceOptions {
  uint32_t samples = 256;  // a pixel, even, [2, 2^16]
  ReferenceFilter filter = ReferenceFilter::kBox;
  // Frames that the shutter is open, about the frame's instant; 0: all samples at that instant.
  double shutter = 0.0;
  ReferenceCoverage coverage = ReferenceCoverage::kPixel;
  std::filesystem::path cache;  // "": ReferenceStore::defaultCache(); "none": no cache
};

class ReferenceStore {
 public:
  ReferenceStore(Device& device, Renderer& renderer, const ReferenceOptions& options);

  // Linear RGB of frame `index`. Samples are Owen-scrambled Sobol points in two halves of their own
  // scrambling, their instants spread over the shutter. From the cache where it has enough samples.
  FloatImage reference(uint32_t index);

  // PSNR in dB of one half of the samples against the other, in display space, of the last
  // reference: the noise floor is 6 dB above it (each half has twice the variance of the whole,
  // their difference four times).
  double halfAgainstHalfDb() const { return half_against_half_db_; }
  // Of the same, a pixel each: the squared difference of the halves, mean over channels.
  const std::vector<float>& halfDifference() const { return half_difference_; }
  uint64_t samplesRendered() const { return samples_rendered_; }
  uint32_t samples() const { return options_.samples; }
  ReferenceFilter filter() const { return options_.filter; }
  // Called with a line for each cached file that is damaged and rendered anew.
  void setWarning(std::function<void(const std::string&)> warn) { warn_ = std::move(warn); }

  // $REPRISE_CACHE, else $XDG_CACHE_HOME/reprise, else ~/.cache/reprise.
  static std::filesystem::path defaultCache();

 private:
  Device& device_;
  Renderer& renderer_;
  ReferenceOptions options_;
  double half_against_half_db_ = 0.0;
  std::vector<float> half_difference_;
  uint64_t samples_rendered_ = 0;
  std::function<void(const std::string&)> warn_;
};

}  // namespace reprise::lab
