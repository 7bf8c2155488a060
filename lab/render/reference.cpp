// SPDX-License-Identifier: MIT
#include "lab/render/reference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "equations/color_space.h"
#include "equations/jitter.h"
#include "lab/render/reference_file.h"

namespace reprise::lab {
namespace {

// Samples of one submission: enough to hide its cost, short enough to answer an interrupt. Sums are
// made of whole submissions, so that an extended reference adds in the order of a fresh one.
constexpr uint32_t kSamplesASubmission = 8;

constexpr double kGaussianSigma_px = 0.4737;  // Yang et al. 2009, section 5.1

// Seeds of the two halves; any two different ones will do.
constexpr uint32_t kHalfSeeds[2] = {1u, 2u};

// Quantile of the standard normal distribution by bisection of erfc: exact to a double's needs, and
// called once a sample.
double normalQuantile(double p) {
  double low = -9.0;
  double high = 9.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Sample offsets drawn from the filter itself: all weights are 1. Returned as jitters.
eq::vec2 referenceJitter(uint32_t index, uint32_t half, ReferenceFilter filter) {
  const eq::vec2 u = eq::owenSobol(index, kHalfSeeds[half]);
  if (filter == ReferenceFilter::kBox) return eq::vec2(0.5f - u.x, 0.5f - u.y);
  // Points lie on multiples of 2^-24: half a step keeps 0 from minus infinity.
  constexpr double kHalfStep = 0.5 / 16777216.0;
  return eq::vec2(static_cast<float>(-kGaussianSigma_px * normalQuantile(u.x + kHalfStep)),
                  static_cast<float>(-kGaussianSigma_px * normalQuantile(u.y + kHalfStep)));
}

// Frames from the frame's instant, within half a shutter: an additive recurrence by the golden
// ratio, whose points are spread whatever their number; the halves are half a period apart.
double referenceInstant(uint32_t index, uint32_t half, double shutter) {
  constexpr double kGoldenRatio = 0.61803398874989485;
  const double at = (index + 0.5) * kGoldenRatio + 0.5 * half;
  return (at - std::floor(at) - 0.5) * shutter;
}

// A pixel each: squared difference in display values, mean over channels.
std::vector<float> displayDifference(const FloatImage& a, const FloatImage& b, float scale) {
  std::vector<float> difference(a.texelCount());
  for (size_t i = 0; i < difference.size(); ++i) {
    float sum = 0.0f;
    for (size_t c = 0; c < 3; ++c) {
      const float d = eq::displayFromLinear(a.texels[3 * i + c] * scale) -
                      eq::displayFromLinear(b.texels[3 * i + c] * scale);
      sum += d * d;
    }
    difference[i] = sum / 3.0f;
  }
  return difference;
}

double psnrOf(const std::vector<float>& squared_errors) {
  const double sum = std::accumulate(squared_errors.begin(), squared_errors.end(), 0.0);
  const double mse = sum / static_cast<double>(squared_errors.size());
  return mse > 0.0 ? -10.0 * std::log10(mse) : 200.0;
}

}  // namespace

std::filesystem::path ReferenceStore::defaultCache() {
  if (const char* own = std::getenv("REPRISE_CACHE"); own != nullptr && *own != '\0') return own;
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && *xdg != '\0') {
    return std::filesystem::path(xdg) / "reprise";
  }
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home != nullptr ? home : "/tmp") / ".cache" / "reprise";
}

ReferenceStore::ReferenceStore(Device& device, Renderer& renderer, const ReferenceOptions& options)
    : device_(device), renderer_(renderer), options_(options) {
  if (options_.samples < 2 || options_.samples > 65536 || options_.samples % 2 != 0) {
    throw std::invalid_argument("reference samples must be even and in [2, 65536]");
  }
  if (options_.cache.empty()) options_.cache = defaultCache();
}

FloatImage ReferenceStore::reference(uint32_t index) {
  renderer_.setFrame(index, 0.0f);
  const VkExtent2D extent = renderer_.extent();
  const std::vector<uint8_t> content = renderer_.contentBytes();
  uint64_t key = hashBytes(content.data(), content.size());
  key = hashBytes(&options_.filter, sizeof(options_.filter), key);
  if (options_.shutter > 0.0) key = hashBytes(&options_.shutter, sizeof(options_.shutter), key);
  if (options_.coverage != ReferenceCoverage::kPixel) {
    key = hashBytes(&options_.coverage, sizeof(options_.coverage), key);
  }
  const std::string identity = device_.name() + device_.driver();
  key = hashBytes(identity.data(), identity.size(), key);
  char name[32];
  std::snprintf(name, sizeof(name), "%016llx.ref", static_cast<unsigned long long>(key));
  const bool cached = options_.cache != "none";
  const std::filesystem::path path = options_.cache / "references" / name;

  ReferenceSums sums;
  const uint32_t wanted = options_.samples / 2;
  // A submission sees one instant.
  const uint32_t submission = options_.shutter > 0.0 ? 1 : kSamplesASubmission;
  ReferenceFileState state = ReferenceFileState::kAbsent;
  if (cached) state = readReferenceFile(path, extent.width, extent.height, sums);
  if (state == ReferenceFileState::kDamaged && warn_) {
    warn_("reference cache: '" + path.string() + "' is damaged; rendering it anew");
  }
  // A file with more samples than asked for has another sum than a fresh run would: equal requests
  // must give equal bytes, so it is not used but left for those who want it.
  const uint32_t held = sums.samples_a_half;
  const bool use = state == ReferenceFileState::kWhole &&
                   (held == wanted || (held < wanted && held % submission == 0));
  if (!use) {
    sums = ReferenceSums{};
    for (FloatImage& half : sums.halves) half = FloatImage(extent.width, extent.height, 3);
  }
  const bool keep_larger = state == ReferenceFileState::kWhole && held > wanted;

  bool extended = false;
  for (uint32_t half = 0; half < 2; ++half) {
    uint32_t done = sums.samples_a_half;
    while (done < wanted) {
      const uint32_t end = std::min(wanted, (done / submission + 1) * submission);
      std::vector<eq::vec2> jitters_px;
      for (uint32_t i = done; i < end; ++i) {
        jitters_px.push_back(referenceJitter(i, half, options_.filter));
      }
      if (options_.shutter > 0.0) {
        renderer_.setFrame(index + referenceInstant(done, half, options_.shutter), 0.0f);
      }
      device_.submitAndWait([&](VkCommandBuffer commands) {
        renderer_.recordTransform(commands, 0);
        renderer_.recordShadows(commands);
        renderer_.recordClearSum(commands);
        renderer_.recordAccumulate(commands, jitters_px, {.light_layers = kAllLightLayers},
                                   options_.coverage == ReferenceCoverage::kCentre, nullptr);
      });
      const FloatImage part = download(device_, renderer_.sum());
      FloatImage& sum = sums.halves[half];
      for (size_t i = 0; i < sum.texelCount(); ++i) {
        for (size_t c = 0; c < 3; ++c) sum.texels[3 * i + c] += part.texels[4 * i + c];
      }
      samples_rendered_ += end - done;
      done = end;
      extended = true;
    }
  }
  renderer_.takeEvaluations();
  sums.samples_a_half = wanted;
  if (cached && extended && !keep_larger) writeReferenceFile(path, sums);

  const float half_scale = 1.0f / static_cast<float>(wanted);
  half_difference_ = displayDifference(sums.halves[0], sums.halves[1], half_scale);
  half_against_half_db_ = psnrOf(half_difference_);
  FloatImage reference(extent.width, extent.height, 3);
  for (size_t i = 0; i < reference.texels.size(); ++i) {
    reference.texels[i] =
        (sums.halves[0].texels[i] + sums.halves[1].texels[i]) * (0.5f * half_scale);
  }
  return reference;
}

}  // namespace reprise::lab
