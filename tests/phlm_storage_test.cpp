// SPDX-License-Identifier: MIT
//
// What the forms of storage of `phlm` must not change: 28 floats and the 22 distinct ones are the
// same models, half precision and 256 bits lose next to nothing, and models about 0 are those about
// the feature where no two are mixed.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lab/metrics/display_space.h"
#include "lab/metrics/psnr.h"
#include "lab/render/scene_source.h"
#include "lab/run/sequence_run.h"
#include "lab/run/technique_choice.h"
#include "tests/test_device.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kFrames = 20;
constexpr uint32_t kFirstCounted = 4;

SceneSourceOptions options() {
  SceneSourceOptions options;
  options.extent = {97, 61};
  options.frames = kFrames;
  options.reference.samples = 32;
  options.reference.cache = "none";
  return options;
}

class PhlmStorage : public testing::Test {
 protected:
  explicit PhlmStorage(const char* scene = "brick/rotate")
      : source_(testDevice(), parseSceneRun(scene), options()) {}
  void TearDown() override { expectNoValidationMessages(); }

  std::vector<FloatImage> filtered(const std::string& settings) {
    Resolver resolver(testDevice(), parseTechnique("phlm:" + settings), source_.info());
    std::vector<FloatImage> images =
        runSequence(testDevice(), source_, resolver, kFrames, true, nullptr).images;
    for (FloatImage& image : images) image = displayImage(image);
    return images;
  }
  double psnr(const std::vector<FloatImage>& images) {
    if (truth_.empty()) {
      for (uint32_t i = 0; i < kFrames; ++i) truth_.push_back(displayImage(*source_.reference(i)));
    }
    double sum = 0.0;
    for (uint32_t i = kFirstCounted; i < kFrames; ++i) {
      sum += psnrDb(meanSquaredError(truth_[i], images[i]));
    }
    return sum / (kFrames - kFirstCounted);
  }

  SceneSource source_;
  std::vector<FloatImage> truth_;
};

float largestDifference(const std::vector<FloatImage>& a, const std::vector<FloatImage>& b) {
  float largest = 0.0f;
  for (size_t i = 0; i < a.size(); ++i) {
    for (size_t k = 0; k < a[i].texels.size(); ++k) {
      largest = std::max(largest, std::abs(a[i].texels[k] - b[i].texels[k]));
    }
  }
  return largest;
}

TEST_F(PhlmStorage, TheDistinctNumbersAreTheWholeModel) {
  // The defaults, models about 0, and the published method, whose models are of light.
  for (const char* rest : {"", ",origin=zero", ",history_filter=bilinear,space=linear"}) {
    const std::vector<FloatImage> paper = filtered(std::string("storage=paper") + rest);
    const std::vector<FloatImage> symmetric = filtered(std::string("storage=symmetric") + rest);
    EXPECT_LE(largestDifference(paper, symmetric), 1e-5f) << rest;
  }
  const std::vector<FloatImage> paper = filtered("preset=paper");
  EXPECT_LE(largestDifference(paper, filtered("preset=paper,storage=symmetric")), 1e-5f);
  // The comparison can fail.
  EXPECT_GT(largestDifference(paper, filtered("preset=paper,lambda=0.9")), 1e-3f);
}

TEST_F(PhlmStorage, TightFormsLoseLessThanATenthOfADecibel) {
  const double paper_db = psnr(filtered("storage=paper"));
  for (const char* form : {"half", "packed"}) {
    EXPECT_GT(psnr(filtered(std::string("storage=") + form)), paper_db - 0.1) << form;
  }
}

// A device whose sampler filters no floats takes the other path.
TEST_F(PhlmStorage, TexelsByHandAreTheSamplersMixture) {
  const std::string rest = ",bilinear=shader";
  for (const std::string form : {"paper", "symmetric", "half"}) {
    const std::string storage = "storage=" + form;
    const std::vector<FloatImage> sampled = filtered(storage);
    // What lies on a half's threshold falls either way: 2^-11 of the value, in several frames.
    const float bound = form == "half" ? 4e-3f : 1e-3f;
    EXPECT_LE(largestDifference(sampled, filtered(storage + rest)), bound) << form;
    // The colour's own filter is in both.
    EXPECT_GT(largestDifference(sampled, filtered(storage + rest + ",history_filter=bilinear")),
              1e-2f)
        << form;
  }
}

// Whole pixels a frame: bilinear reads one model, and what remains is the prior, which is about
// the origin, and rounding (0.08 dB). Variances bounded about 0 would cost 0.5 dB. A prior that
// weighs as much as a sample is another one about each origin, hence 1000.
class PhlmOrigin : public PhlmStorage {
 protected:
  PhlmOrigin() : PhlmStorage("chart/pan:vx=1,vy=0") {}
};

TEST_F(PhlmOrigin, WhereNoModelsMixTheOriginDoesNotMatter) {
  const std::string rest =
      ",initial_variance=1000,storage=symmetric,history_filter=bilinear,jitter=always";
  const double zero_db = psnr(filtered("origin=zero" + rest));
  const double feature_db = psnr(filtered("origin=feature" + rest));
  EXPECT_NEAR(zero_db, feature_db, 0.1);
}

}  // namespace
}  // namespace reprise::lab
