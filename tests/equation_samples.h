// SPDX-License-Identifier: MIT
// Every equation on arguments made from a seed, as GLSL and as C++: what gpu_equals_cpu compares.
// Arguments keep clear of discontinuities, where the last bit decides.
#ifndef REPRISE_TESTS_EQUATION_SAMPLES_H
#define REPRISE_TESTS_EQUATION_SAMPLES_H

#include "equations/accumulation.h"
#include "equations/amortized.h"
#include "equations/clipping.h"
#include "equations/color_space.h"
#include "equations/even_pyramid.h"
#include "equations/evidence.h"
#include "equations/exposure.h"
#include "equations/filters.h"
#include "equations/fxaa.h"
#include "equations/hash.h"
#include "equations/jitter.h"
#include "equations/least_squares.h"
#include "equations/reprojection.h"
#include "equations/shading_offset.h"
#include "equations/sharpen.h"

EQ_BEGIN

EQ_CONST uint kEquationCount = 84u;

EQ_FN vec4 wide2(vec2 v) {
  return vec4(v.x, v.y, 0.0f, 0.0f);
}
EQ_FN vec4 wide3(vec3 v) {
  return vec4(v.x, v.y, v.z, 0.0f);
}
EQ_FN vec4 wide1(float v) {
  return vec4(v, 0.0f, 0.0f, 0.0f);
}
// 24 bits in each of two numbers: exact as floats.
EQ_FN vec4 wideBits(uint v) {
  return vec4(float(v & 0xffffu), float(v >> 16u), 0.0f, 0.0f);
}

EQ_FN float drawn(uint seed, uint k) {
  return unitFloat(hashPixel(seed, k, 977u));
}
EQ_FN vec3 drawn3(uint seed, uint k) {
  return vec3(drawn(seed, k), drawn(seed, k + 1u), drawn(seed, k + 2u));
}

EQ_FN vec4 filterSample(uint which, uint s) {
  float x = 4.0f * drawn(s, 1u) - 2.0f;
  if (which == 0u) return wide1(tentFilter(x, 1.5f));
  if (which == 1u) return wide1(mitchellFilter(x));
  if (which == 2u) return wide1(blackmanHarrisFilter(x));
  if (which == 3u) return wide1(blackmanHarrisWindow(x, 3.3f));
  if (which == 4u) return wide1(gaussianFilter(x, 0.3f + drawn(s, 2u)));
  if (which == 5u) return wide1(lanczosFilter(x, 2.0f));
  if (which == 6u) return cubicWeights(drawn(s, 2u), drawn(s, 3u));
  if (which == 7u) return wide3(mergedCubicWeights(cubicWeights(drawn(s, 2u), 0.5f)));
  if (which == 8u) return wide1(mergedCubicOffset(cubicWeights(drawn(s, 2u), 0.5f)));
  return wide1(fiveTapWeight(mergedCubicWeights(cubicWeights(drawn(s, 2u), 0.5f)),
                             mergedCubicWeights(cubicWeights(drawn(s, 3u), 0.5f))));
}

EQ_FN vec4 colorSample(uint which, uint s) {
  vec3 c = drawn3(s, 1u) * 4.0f;
  if (which == 0u) return wide1(luma709(c));
  if (which == 1u) return wide1(luma601(c));
  if (which == 2u) return wide3(yCoCgFromRgb(c));
  if (which == 3u) return wide3(rgbFromYCoCg(c - vec3(2.0f)));
  if (which == 4u) return wide3(compressByLuma(c));
  if (which == 5u) return wide3(expandByLuma(drawn3(s, 1u) * 0.9f));
  if (which == 6u) return wide3(compressByMax(c));
  if (which == 7u) return wide3(expandByMax(drawn3(s, 1u) * 0.9f));
  if (which == 8u) return wide3(logFromLinear(c));
  if (which == 9u) return wide3(linearFromLog(logFromLinear(c)));
  if (which == 10u) return wide3(displayFromLinear(c));
  return wide1(perceptualLuma(c));
}

EQ_FN vec4 accumulationSample(uint which, uint s) {
  float a = 0.01f + 0.9f * drawn(s, 1u);
  float b = 0.01f + 2.0f * drawn(s, 2u);
  if (which == 0u) return wide1(effectiveSamples(a, 1.0f + 8.0f * b));
  if (which == 1u) return wide1(steadyEffectiveSamples(a));
  if (which == 2u) return wide1(nextEffectiveSamples(1.0f + 8.0f * b, a));
  if (which == 3u) return wide1(runningMeanAlpha(8.0f * b, 0.05f));
  if (which == 4u) return wide1(nextConfidence(a));
  if (which == 5u) return wide1(contrastFeedback(a, b));
  if (which == 6u) return wide1(boundsFeedback(a, 0.0f, a + b));
  if (which == 7u) return wide1(changeFeedback(a, b));
  if (which == 8u) return wide1(speedFactor(8.0f * b, 20.0f));
  return wide1(frameRateAlpha(0.02f * b, 0.1f));
}

EQ_FN vec4 clipSample(uint which, uint s) {
  vec3 low = drawn3(s, 1u) * 0.4f;
  vec3 high = low + vec3(0.1f) + drawn3(s, 4u) * 0.5f;
  vec3 history = drawn3(s, 7u) * 3.0f - vec3(1.0f);
  vec3 inside = (low + high) * 0.5f;
  if (which == 0u) return wide3(clampToBox(low, high, history));
  if (which == 1u) return wide3(deviationFromMoments(low, low * low + high));
  if (which == 2u) return wide3(roundedBound(low, high));
  if (which == 3u) return wide3(clipTowardBoxCentre(low, high, history));
  if (which == 4u) return wide1(slabExit(inside.x, history.x - inside.x, low.x, high.x));
  if (which == 5u) return wide3(clipTowardSample(low, high, inside, history));
  return wide3(kdopAxis(s & 15u));
}

EQ_FN vec4 jitterSample(uint which, uint s) {
  if (which == 0u) return wide2(haltonOffset(s & 255u));
  if (which == 1u) return wide2(r2Offset(s & 255u));
  if (which == 2u) return wide2(sobolOffset(s & 63u, 16u));
  if (which == 3u) return wide2(nRooksOffset(s & 63u, 13u));
  if (which == 4u) return wide2(rotatedGridOffset(s & 7u));
  if (which == 5u) return wide2(msaa8Offset(s & 15u));
  if (which == 6u) return wide2(helixOffset(s & 7u));
  if (which == 7u) return wide2(owenSobol(s & 1023u, 5u));
  if (which == 8u) return wideBits(hashPcg(s));
  if (which == 9u) return wideBits(hashPixel(s, s * 3u, 7u));
  if (which == 10u) return wide2(shadingOffset(s & 255u, s >> 8u, 3u, 0.4737f, s & 3u));
  return wide2(gaussianPair(hashPcg(s), hashPcg(s + 1u)));
}

EQ_FN vec4 reprojectionSample(uint which, uint s) {
  vec2 px = vec2(100.0f * drawn(s, 1u), 50.0f * drawn(s, 2u));
  vec2 extent_px = vec2(128.0f, 64.0f);
  if (which == 0u) return wide1(viewDepthFromDepth(vec4(0.0f, 0.1f, 1.0f, 0.01f), drawn(s, 3u)));
  if (which == 1u) return wide1(expectedPreviousDepth(vec4(0.001f, 0.002f, 1.0f, 0.3f), px, 3.0f));
  if (which == 2u) return wide2(ndcFromUv(uvFromPx(px, extent_px)));
  if (which == 3u) return wide2(pxFromUv(uvFromNdc(px), extent_px));
  if (which == 4u) return wide2(ndcFromJitter(px, extent_px));
  if (which == 5u) {
    return validTapWeights(drawn(s, 3u), drawn(s, 4u),
                           vec4(1.0f, float(s & 1u), float((s >> 1u) & 1u), 1.0f));
  }
  if (which == 6u) return wide1(motionDifferenceRamp(px, px + vec2(3.0f * drawn(s, 3u)), 0.5f));
  if (which == 7u)
    return wide3(sharpened(drawn3(s, 1u), drawn3(s, 4u), drawn3(s, 7u), drawn3(s, 10u),
                           drawn3(s, 13u), drawn(s, 16u)));
  return wide1(sharpenLobe(0.1f + 0.3f * drawn(s, 1u), 0.5f + 0.4f * drawn(s, 2u)));
}

EQ_FN vec4 amortizedSample(uint which, uint s) {
  float fx = drawn(s, 1u);
  float fy = drawn(s, 2u);
  if (which == 0u) return wide1(bilinearBlurVariance(0.0663f, 0.05f + 0.9f * fx, fy, drawn(s, 3u)));
  if (which == 1u) return tentWeights(fx, fy, 0.5f + drawn(s, 3u));
  if (which == 2u) return wide2(bilinearFraction(tentWeights(fx, fy, 1.1f)));
  if (which == 3u) return wide1(tentGrowth(vec2(2.0f * fx, fy), vec2(fy, drawn(s, 3u))));
  if (which == 4u) return wide1(varianceReduction(1.0f + 30.0f * fx, fy));
  return wide1(residualBound(fx - 0.5f, 0.1f));
}

EQ_FN vec4 fxaaSample(uint which, uint s) {
  float a = drawn(s, 1u);
  float b = 0.05f + drawn(s, 2u);
  if (which == 0u) return wide1(fxaaBend(drawn3(s, 1u), drawn3(s, 4u), drawn3(s, 7u)));
  if (which == 1u) return wide1(fxaaSubpixelShift(4.0f * a, 4.0f * drawn(s, 3u), a, b, 0.75f));
  if (which == 2u) return wide1(fxaaSpanShift(8.0f * a, 8.0f * b));
  return wide3(linearFromDisplay(drawn3(s, 1u) * 0.95f));
}

// Every number of a model counts.
EQ_FN vec4 modelDigest(LinearModel m) {
  return vec4(m.intercept.x + 2.0f * m.intercept.y + 3.0f * m.intercept.z + m.level,
              dot(m.slope_r, vec3(1.0f, 2.0f, 3.0f)) + dot(m.slope_g, vec3(4.0f, 5.0f, 6.0f)) +
                  dot(m.slope_b, vec3(7.0f, 8.0f, 9.0f)),
              dot(m.cross, vec3(1.0f, 2.0f, 3.0f)) + dot(m.spread, vec3(4.0f, 5.0f, 6.0f)),
              dot(m.spread_cross, vec3(1.0f, 2.0f, 3.0f)));
}

EQ_FN vec4 leastSquaresSample(uint which, uint s) {
  vec3 z = drawn3(s, 4u) - vec3(0.5f);
  LinearModel m = constantModel(drawn3(s, 1u), 1.0f + drawn(s, 7u), 2.0f);
  m = updatedModel(m, drawn3(s, 8u), drawn3(s, 11u) - vec3(0.5f), 0.998f);
  if (which == 0u) return modelDigest(m);
  if (which == 1u) return modelDigest(shiftedModel(m, z));
  if (which == 2u) return modelDigest(updatedModel(m, z, drawn3(s, 14u), 0.9f));
  if (which == 3u) return modelDigest(boundedModel(m, 0.5f, 1.0f));
  if (which == 4u) return modelDigest(exposedModel(m, 0.5f + drawn(s, 17u)));
  if (which == 5u) return wide3(predictedColor(m, z));
  if (which == 6u) return wide1(predictionVariance(m, z));
  return wide1(featureAlpha(drawn(s, 1u), drawn(s, 2u), 8.0f * drawn(s, 3u), 0.125f, 0.25f));
}

EQ_FN vec4 evidenceSample(uint which, uint s) {
  if (which == 0u) return wide1(exponentialMeanVariance(drawn(s, 1u)));
  return wide1(believedShare(0.1f + drawn(s, 1u), drawn(s, 2u), 3.0f * drawn(s, 3u)));
}

EQ_FN vec4 exposureSample(uint which, uint s) {
  if (which == 0u) return wide1(logLuminance(drawn3(s, 1u)));
  if (which == 1u) {
    return wide1(adaptedLuminance(drawn(s, 1u), drawn(s, 2u), 0.1f * drawn(s, 3u), 0.4f));
  }
  if (which == 2u) return wide1(exposureFor(0.01f + drawn(s, 1u)));
  return wide2(vec2(evenPyramidWeight(int(s & 3u)), float(evenPyramidFarTexel(int(s)))));
}

// Equation `which` in [0, kEquationCount) on arguments of `seed`.
EQ_FN vec4 equationSample(uint which, uint seed) {
  if (which < 10u) return filterSample(which, seed);
  if (which < 22u) return colorSample(which - 10u, seed);
  if (which < 32u) return accumulationSample(which - 22u, seed);
  if (which < 39u) return clipSample(which - 32u, seed);
  if (which < 51u) return jitterSample(which - 39u, seed);
  if (which < 60u) return reprojectionSample(which - 51u, seed);
  if (which < 66u) return amortizedSample(which - 60u, seed);
  if (which < 70u) return fxaaSample(which - 66u, seed);
  if (which < 78u) return leastSquaresSample(which - 70u, seed);
  if (which < 80u) return evidenceSample(which - 78u, seed);
  return exposureSample(which - 80u, seed);
}

EQ_END
#endif
