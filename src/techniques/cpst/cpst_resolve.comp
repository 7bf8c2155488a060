// SPDX-License-Identifier: MIT
//
// Coarse pixel shading with temporal supersampling. Equation numbers refer to README.md of this
// folder.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/half_rounding.glsl"
#include "core/history_filters.glsl"
#include "core/neighbourhood.glsl"
#include "core/workgroup.h"
#include "equations/coarse.h"
#include "equations/color_space.h"
#include "techniques/cpst/cpst_shared.h"

// What few pixels need is in loops that others leave after one turn: CPU drivers run both sides of
// a branch for every pixel, and a loop's body at least once.
layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(constant_id = 0) const uint kVariance = 0u;
layout(constant_id = 1) const uint kAbout = 0u;
layout(constant_id = 2) const uint kDisocclusion = 0u;
layout(constant_id = 3) const uint kShadingFilter = 0u;
layout(constant_id = 4) const uint kReconstruct = 0u;
layout(constant_id = 5) const uint kHistoryClamp = 0u;
layout(constant_id = 6) const uint kChange = 0u;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2D motion_image;
// Of 4 x 4 pixels: cpst_moments.comp; with kChange the last word is cpst_change.comp's.
layout(binding = 3) uniform usampler2D moments_image;
layout(binding = 4) uniform usampler2D silhouette_image;    // cpst_silhouettes.comp
layout(binding = 5) uniform sampler2D history_image;        // rgb linear, a: summed weight
layout(binding = 6) uniform sampler2D history_depth_image;  // r: view depth
layout(binding = 7) writeonly uniform image2D next_history_image;
layout(binding = 8) writeonly uniform image2D next_depth_image;
layout(binding = 9) writeonly uniform image2D output_image;
layout(binding = 10, std140) uniform Constants {
  CpstConstants k;
};

// Motion below this is none (px): what half-precision motion images leave of a still camera.
const float kStillMotion_px = 0.01;
// How far from where a depth was sampled a history tap may have been: one texel, and two jitters of
// half a pixel.
const float kPlaneReach_px = 2.0;
// Relative difference of depths up to which neighbours are one surface, for reconstruction.
const float kSameSurface = 0.05;

// Where pixel `px` was shaded (eq. 1).
vec2 shadingSample(ivec2 px) {
  int size = int(k.coarse_size);
  return vec2(coarseCentre(px.x, size, int(k.coarse_origin_px.x)),
              coarseCentre(px.y, size, int(k.coarse_origin_px.y))) -
         k.frame.jitter_px;
}

float depthAt(ivec2 px, ivec2 last_px) {
  return texelFetch(depth_image, clamp(px, ivec2(0), last_px), 0).x;
}

// What a pixel and its four neighbours tell.
struct Cross {
  ivec2 front_px;  // the nearest (section 3.2 of the paper)
  float front;     // its depth
  float own;       // the pixel's own
  float slope;     // change of depth over a pixel, both axes together
};

Cross crossOf(ivec2 px, ivec2 last_px) {
  Cross c;
  float order = k.frame.depth_order;
  c.front_px = px;
  c.own = depthAt(px, last_px);
  c.slope = 0.0;
  float best = c.own * order;
  float before = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 step = i < 2 ? ivec2(2 * i - 1, 0) : ivec2(0, 2 * i - 5);
    ivec2 at = clamp(px + step, ivec2(0), last_px);
    float depth = depthAt(at, last_px);
    // Of each axis the smaller of both sides, since a silhouette is on one.
    float change = abs(depth - c.own);
    if ((i & 1) == 1) c.slope += min(before, change);
    before = change;
    if (depth * order < best) {
      best = depth * order;
      c.front_px = at;
    }
  }
  c.front = best * order;
  return c;
}

vec2 motionAt(ivec2 px) {
  return motionPx(k.frame, texelFetch(motion_image, px, 0).xy);
}

uint toldOf(ivec2 px) {
  uvec2 told = texelFetch(silhouette_image, toldTexel(px), 0).xy;
  uint row = (px.y & 2) == 0 ? told.x : told.y;
  return (px.x & 2) == 0 ? row & 0xffffu : row >> 16;
}

// Whether what was nearer in history, at `then`, is still there two pixels around and moves with
// the surface. Then nothing was uncovered: a jitter drew their outline elsewhere, and history's
// colours are a mean over such outlines.
bool outlineJitters(uint told, vec2 sample_px, float then) {
  float expected =
      expectedPreviousDepth(k.frame.previous_depth_coefficients, sample_px, toldDepth(told));
  return wasVisible(min(expected, kMaxViewDepth), then, k.depth_tolerance) && toldTogether(told);
}

struct Coarse {
  Moments moments;
  vec2 change;  // gain of history, certainty
};

// Moments at LoD 2 and change between texels: a mixture's variance is that of its parts and of
// their means.
Coarse coarseOf(vec2 center_px) {
  vec2 at = center_px / float(kMomentSize) - 0.5;
  ivec2 base = ivec2(floor(at));
  vec2 f = at - vec2(base);
  ivec2 last = (ivec2(k.frame.extent_px) - 1) / int(kMomentSize);
  vec3 mean = vec3(0.0);
  vec3 square = vec3(0.0);
  vec2 change = vec2(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i % 2, i / 2);
    vec2 w = mix(1.0 - f, f, vec2(corner));
    ivec2 texel = clamp(base + corner, ivec2(0), last);
    uvec4 packed = texelFetch(moments_image, texel, 0);
    vec2 between = unpackHalf2x16(packed.y);
    vec3 m = vec3(unpackHalf2x16(packed.x), between.x);
    mean += w.x * w.y * m;
    square += w.x * w.y * (vec3(between.y, unpackHalf2x16(packed.z)) + m * m);
    if (kChange != 0u) change += w.x * w.y * unpackHalf2x16(packed.w);
  }
  return Coarse(Moments(mean, deviationFromMoments(mean, square)), change);
}

struct Around {
  vec3 own;      // the pixel's sample
  float weight;  // and what it weighs by its distance (eq. 2)
  Moments fine;  // of 3 x 3 pixels
  vec3 mixed;    // samples of the same surface among them, by how close they were shaded (eq. 7)
};

// Offsets plus one of 3 x 3 pixels, two bits each: the middle first, then row by row.
const uint kStepsX = 0x24891u;
const uint kStepsY = 0x2a501u;

// The pixel's own sample and, where one of both is `wanted`, those around: few pixels need either,
// mostly the same ones. Of samples that are fetched here: kept from before they would be live
// through all that comes between, and CPU drivers have no registers for them.
Around aroundOf(float own, ivec2 px, ivec2 last_px, vec2 center_px, bool wanted) {
  float own_depth = viewDepth(k.frame, own);
  Around around;
  around.own = vec3(0.0);
  around.weight = 0.0;
  vec3 sum = vec3(0.0);
  vec3 sum_of_squares = vec3(0.0);
  vec3 mixed = vec3(0.0);
  float weights = 0.0;
  int count = wanted ? 9 : 1;
  int i = 0;
  do {
    ivec2 at = px + ivec2(int(kStepsX >> 2 * i & 3u), int(kStepsY >> 2 * i & 3u)) - 1;
    at = clamp(at, ivec2(0), last_px);
    vec3 c = yCoCgFromRgb(fetchColor(color_image, at, last_px));
    sum += c;
    sum_of_squares += c * c;
    vec2 from_px = shadingSample(at) - center_px;
    float w = gaussianOfSquare(dot(from_px, from_px), k.sigma_px);
    around.own = i == 0 ? c : around.own;
    around.weight = i == 0 ? w : around.weight;
    if (kReconstruct != kReconstructNone) {
      float depth = viewDepth(k.frame, depthAt(at, last_px));
      if (!depthsAgree(own_depth, depth, kSameSurface)) w = 0.0;
      if (i == 0) w = max(w, 1.0e-4);
      mixed += w * c;
      weights += w;
    }
    ++i;
  } while (i < count);
  if (kShadingFilter == 0u) around.weight = 1.0;
  vec3 mean = sum * (1.0 / 9.0);
  around.fine = Moments(mean, deviationFromMoments(mean, sum_of_squares * (1.0 / 9.0)));
  around.mixed = mixed / weights;
  return around;
}

// Of the taps with these depths, in which this surface was seen.
vec4 visibleTaps(float expected, vec4 then, float slope) {
  vec4 valid;
  for (int i = 0; i < 4; ++i) {
    valid[i] = wasVisibleOnPlane(expected, then[i], k.depth_tolerance, slope) ? 1.0 : 0.0;
  }
  return valid;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  vec2 center_px = vec2(px) + 0.5;
  uint told = 0u;
  if (kVariance == kVarianceDynamic || kDisocclusion == kDisocclusionTaps) told = toldOf(px);
  Cross near = crossOf(px, last_px);
  vec2 motion_px = motionAt(near.front_px);
  float view_depth = viewDepth(k.frame, near.front);
  vec2 previous_extent_px = k.frame.previous_extent_px;
  vec2 previous_px = (center_px + motion_px) * (previous_extent_px / k.frame.extent_px);
  vec2 inside_px = clamp(previous_px, vec2(0.5), previous_extent_px - 0.5);
  vec2 last_center_px = previous_extent_px - 0.5;
  bool hit = k.frame.has_history > 0.5 && isOnScreen(previous_px, previous_extent_px);

  // Disocclusion (eq. 5): the order (0,0) (1,0) (0,1) (1,1).
  vec4 then = textureGather(history_depth_image, inside_px * k.frame.history_texel_uv, 0).wzxy;
  vec4 valid = vec4(1.0);
  bool disoccluded = false;
  if (kDisocclusion == kDisocclusionScale) {
    float nearest = kMaxViewDepth;
    for (int i = 0; i < 9; ++i) {
      nearest =
          min(nearest, viewDepth(k.frame, depthAt(px + ivec2(i % 3 - 1, i / 3 - 1), last_px)));
    }
    float expected = expectedPreviousDepth(k.frame.previous_depth_coefficients,
                                           center_px - k.frame.jitter_px, nearest);
    float farthest = max(max(then.x, then.y), max(then.z, then.w));
    disoccluded = min(expected, kMaxViewDepth) > farthest * (1.0 + k.depth_tolerance);
  }
  if (kDisocclusion == kDisocclusionTaps) {
    float expected = expectedPreviousDepth(k.frame.previous_depth_coefficients,
                                           center_px - k.frame.jitter_px, view_depth);
    expected = min(expected, kMaxViewDepth);
    float slope = near.slope * inverseDepthSlope(k.frame.view_depth_coefficients, near.own);
    // A depth that is no number has no plane.
    slope = slope < 3.0e38 ? slope : 0.0;
    valid = visibleTaps(expected, then, kPlaneReach_px * slope);
    disoccluded = dot(valid, vec4(1.0)) < 3.5;
    float nearest_then = min(min(then.x, then.y), min(then.z, then.w));
    if (disoccluded && outlineJitters(told, center_px - k.frame.jitter_px, nearest_then)) {
      valid = vec4(1.0);
      disoccluded = false;
    }
    hit = hit && dot(valid, vec4(1.0)) > 0.5;
  }

  vec4 inner[4] = innerTexels(history_image, inside_px, last_center_px);
  vec4 history = cubicAroundInner(inner, history_image, inside_px, k.frame.history_texel_uv,
                                  last_center_px, k.history_sharpness);
  if (kHistoryClamp != 0u) history = withinInner(history, inner);
  if (disoccluded && hit && kDisocclusion == kDisocclusionTaps) {
    history = validOfInner(inner, inside_px, valid);
  }
  bool still = length(motion_px) < kStillMotion_px;
  float held = hit ? min(history.a, still ? k.held_limit_still : k.held_limit) : 0.0;

  vec3 previous = yCoCgFromRgb(sanitizedColor(history.rgb * k.frame.exposure_ratio));
  Coarse coarse;
  if (kChange != 0u || kVariance >= kVarianceCoarse) coarse = coarseOf(center_px);
  if (kChange != 0u) {
    previous *= coarse.change.x;
    held *= 1.0 - coarse.change.y;
  }
  bool fine = kVariance == kVarianceFine || disoccluded;
  if (kVariance == kVarianceNone || kVariance == kVarianceCoarse) fine = false;
  if (kVariance == kVarianceDynamic) fine = fine || toldSilhouette(told);
  bool mixes = kReconstruct == kReconstructAlways ||
               (kReconstruct == kReconstructFresh && held < k.mean_weight);
  Around around = aroundOf(near.own, px, last_px, center_px, fine || mixes);
  vec3 current = around.own;

  vec3 bounded = previous;
  if (kVariance != kVarianceNone) {
    Moments m = around.fine;
    if (kVariance >= kVarianceCoarse && !fine) m = coarse.moments;
    float gamma = still ? k.gamma_still : k.gamma;
    vec3 middle = kAbout == kAboutOwn ? current : m.mean;
    vec3 reach = gamma * m.deviation + boundSlack(previous, current);
    bounded = clipTowardBoxCentre(middle - reach, middle + reach, previous);
  }

  if (mixes) current = around.mixed;
  float alpha = weightedMeanAlpha(around.weight, held);
  vec3 result = clamp(rgbFromYCoCg(mix(bounded, current, alpha)), vec3(0.0), vec3(kMaxColor));
  vec3 stored = roundedToHalf(result, px, k.frame.frame_number, true);
  // Half precision loses small weights beside large sums: no more than 2048 of the smallest.
  imageStore(next_history_image, px, vec4(stored, min(held + around.weight, 2048.0)));
  imageStore(next_depth_image, px, vec4(view_depth, 0.0, 0.0, 0.0));
  imageStore(output_image, px, vec4(result, 1.0));
}
