// SPDX-License-Identifier: MIT
//
// What must hold for every technique, whatever it does inside. A new line in technique_list.cpp is
// tested here without a change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "formula_source.h"
#include "test_device.h"

namespace reprise::lab {
namespace {

// Half-precision history: 11 bits, and one more for rounding up or down at random.
constexpr float kHalfStep = 1.0f / 1024.0f;

// Stripes and a disc with sharp edges at no particular angle; HDR up to 3.
Rgb edges(float x_px, float y_px) {
  const bool stripe = std::fmod(std::abs(0.31f * x_px + 0.17f * y_px) + 100.0f, 2.0f) < 1.0f;
  const bool disc = std::hypot(x_px - 20.3f, y_px - 14.7f) < 9.2f;
  const float v = disc ? 3.0f : stripe ? 0.8f : 0.1f;
  return {v, 0.5f * v + 0.1f, stripe ? 0.2f : 0.6f};
}

// White noise by position: every pixel another.
Rgb noise(float x_px, float y_px) {
  const auto cell = static_cast<uint32_t>(static_cast<int>(std::floor(x_px)) * 7919 +
                                          static_cast<int>(std::floor(y_px)) * 104729);
  const uint32_t h = (cell ^ (cell >> 13)) * 2654435761u;
  return {static_cast<float>(h & 255u) / 255.0f, static_cast<float>(h >> 8 & 255u) / 255.0f,
          static_cast<float>(h >> 16 & 255u) / 255.0f};
}

double squaredError(const FloatImage& reference, const FloatImage& rgba) {
  double sum = 0.0;
  for (size_t i = 0; i < reference.texelCount(); ++i) {
    for (size_t c = 0; c < 3; ++c) {
      const double d = reference.texels[3 * i + c] - rgba.texels[4 * i + c];
      sum += d * d;
    }
  }
  return sum / static_cast<double>(reference.texels.size());
}

bool sameBytes(const FloatImage& a, const FloatImage& b) {
  return a.texels.size() == b.texels.size() &&
         std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(float)) == 0;
}

class EveryTechnique : public testing::TestWithParam<std::string> {
 protected:
  Resolver resolver(const FormulaSource& source) {
    return Resolver(testDevice(), parseTechnique(GetParam()), source.info());
  }
  bool usesHistory() const {
    return (parseTechnique(GetParam()).library->flags & REPRISE_TECHNIQUE_USES_HISTORY) != 0;
  }
  void TearDown() override { expectNoValidationMessages(); }
};

TEST_P(EveryTechnique, AConstantImageStaysConstant) {
  for (const VkExtent2D extent : {VkExtent2D{257, 89}, VkExtent2D{1, 1}, VkExtent2D{8, 3}}) {
    for (const float speed : {0.0f, 0.37f}) {
      Formula formula;
      formula.color = [](float, float) { return Rgb{0.3f, 1.7f, 0.02f}; };
      formula.velocity_px[0] = speed;
      formula.velocity_px[1] = -2.0f * speed;
      FormulaSource source(testDevice(), extent, formula);
      Resolver r = resolver(source);
      const FloatImage image = resolveFrames(r, source, 12);
      for (size_t i = 0; i < image.texelCount(); ++i) {
        ASSERT_NEAR(image.texels[4 * i], 0.3f, 0.3f * kHalfStep * 2.0f) << i;
        ASSERT_NEAR(image.texels[4 * i + 1], 1.7f, 1.7f * kHalfStep * 2.0f) << i;
        ASSERT_NEAR(image.texels[4 * i + 2], 0.02f, 0.02f * kHalfStep * 4.0f) << i;
        ASSERT_EQ(image.texels[4 * i + 3], 1.0f) << i;
      }
    }
  }
}

TEST_P(EveryTechnique, AStillSceneGoesToTheSupersampledReference) {
  if (!usesHistory()) GTEST_SKIP() << GetParam() << " keeps no history: nothing converges";
  if (GetParam() == "cps") GTEST_SKIP() << "shades once for four pixels: stays coarse";
  Formula formula;
  formula.color = edges;
  // Its still kernel: the samples' variance, the tent's and the buffers' places (README.md).
  if (GetParam().starts_with("amortized")) formula.reference_sigma_px = 0.504f;
  // The shading filter's over the four pixels of a coarse one (README.md).
  if (GetParam().starts_with("cpst")) formula.reference_sigma_px = 0.502f;
  // Its input filter's, by design (README.md).
  if (GetParam().starts_with("ue4-taa")) formula.reference_sigma_px = 0.467f;
  FormulaSource source(testDevice(), {48, 32}, formula);
  const FloatImage reference = *source.reference(0);
  Resolver r = resolver(source);
  const double first = squaredError(reference, resolveFrames(r, source, 1));
  const double later = squaredError(reference, resolveFrames(r, source, 63, 1));
  // A mean of n independent samples would have a tenth of the error at n = 10. The tight bound of
  // ue4-taa applies at rest too and ends convergence, and its first frame is filtered already.
  const double share = GetParam().starts_with("ue4-taa") ? 0.5 : 0.1;
  EXPECT_LT(later, share * first) << "first " << first << " later " << later;
}

TEST_P(EveryTechnique, ResetGivesTheCurrentFrameAlone) {
  Formula before;
  before.color = edges;
  Formula after;
  after.color = noise;
  const VkExtent2D extent{37, 21};
  FormulaSource old_source(testDevice(), extent, before);
  FormulaSource new_source(testDevice(), extent, after);
  constexpr uint32_t kCut = 7;
  const auto cut = [](FrameInputs& inputs) { inputs.reset = true; };

  Resolver fresh = resolver(new_source);
  const FloatImage expected = resolveFrames(fresh, new_source, 1, kCut, cut);

  Resolver by_frame = resolver(old_source);
  resolveFrames(by_frame, old_source, kCut);
  EXPECT_TRUE(sameBytes(resolveFrames(by_frame, new_source, 1, kCut, cut), expected));

  Resolver by_call = resolver(old_source);
  resolveFrames(by_call, old_source, kCut);
  by_call.context().reset();
  EXPECT_TRUE(sameBytes(resolveFrames(by_call, new_source, 1, kCut,
                                      [](FrameInputs& inputs) { inputs.reset = false; }),
                        expected));

  Resolver by_resize = resolver(old_source);
  resolveFrames(by_resize, old_source, kCut);
  by_resize.context().resize({11, 5});
  by_resize.context().prepare();
  by_resize.context().resize(extent);
  by_resize.context().prepare();
  EXPECT_TRUE(sameBytes(resolveFrames(by_resize, new_source, 1, kCut, cut), expected));
}

TEST_P(EveryTechnique, TwoRunsGiveTheSameBytes) {
  Formula formula;
  formula.color = noise;
  formula.velocity_px[0] = 0.7f;
  FormulaSource source(testDevice(), {65, 33}, formula);
  Resolver one = resolver(source);
  Resolver two = resolver(source);
  EXPECT_TRUE(sameBytes(resolveFrames(one, source, 9), resolveFrames(two, source, 9)));
}

TEST_P(EveryTechnique, OutputStaysWithinSightOfItsInputs) {
  Formula formula;
  formula.color = noise;
  formula.velocity_px[0] = 1.3f;
  formula.velocity_px[1] = 0.4f;
  FormulaSource source(testDevice(), {64, 48}, formula);
  Resolver r = resolver(source);
  const FloatImage image = resolveFrames(r, source, 24);
  for (const float value : image.texels) {
    ASSERT_TRUE(std::isfinite(value));
    ASSERT_GE(value, 0.0f);
    // A bicubic tap overshoots noise of [0, 1] by at most a quarter of its range.
    ASSERT_LE(value, 1.3f);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryTechnique, testing::ValuesIn(everyTechnique()),
                         [](const auto& test) {
                           std::string name = test.param;
                           for (char& c : name) {
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           }
                           return name;
                         });

TEST(Bounds, ClampedTaaStaysWithinItsNeighbourhood) {
  Formula formula;
  formula.color = noise;
  formula.velocity_px[0] = 2.6f;
  const VkExtent2D extent{64, 48};
  FormulaSource source(testDevice(), extent, formula);
  // Bounded a channel in RGB, no filter that reaches beyond 3x3.
  Resolver r(testDevice(),
             parseTechnique("taa:clip=minmax,clip_toward=clamp,clip_space=rgb,weighting=none,"
                            "jitter=none,input_filter=none,rejected_blur=false,spatial_frames=0"),
             source.info());
  constexpr uint32_t kFrames = 20;
  constexpr float kSlack = 2.1f / 1024.0f;  // kBoundSlack of neighbourhood.glsl, and rounding
  const FloatImage image = resolveFrames(r, source, kFrames);
  const float moved = static_cast<float>(kFrames - 1) * formula.velocity_px[0];
  for (int y = 0; y < static_cast<int>(extent.height); ++y) {
    for (int x = 0; x < static_cast<int>(extent.width); ++x) {
      Rgb low{2, 2, 2};
      Rgb high{-1, -1, -1};
      for (int k = 0; k < 9; ++k) {
        const int nx = std::clamp(x + k % 3 - 1, 0, static_cast<int>(extent.width) - 1);
        const int ny = std::clamp(y + k / 3 - 1, 0, static_cast<int>(extent.height) - 1);
        const Rgb rgb = noise(static_cast<float>(nx) + 0.5f - moved, static_cast<float>(ny) + 0.5f);
        for (size_t c = 0; c < 3; ++c) {
          low[c] = std::min(low[c], rgb[c]);
          high[c] = std::max(high[c], rgb[c]);
        }
      }
      for (size_t c = 0; c < 3; ++c) {
        const float value = image.at(static_cast<uint32_t>(x), static_cast<uint32_t>(y))[c];
        ASSERT_GE(value, low[c] - kSlack) << x << ", " << y;
        ASSERT_LE(value, high[c] + kSlack) << x << ", " << y;
      }
    }
  }
  expectNoValidationMessages();
}

}  // namespace
}  // namespace reprise::lab
