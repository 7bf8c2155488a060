// SPDX-License-Identifier: MIT
//
// Algorithm 1 with models in float images: the paper's 28 numbers, or the 22 distinct ones in
// single or half precision.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/half_rounding.glsl"
#include "core/history_filters.glsl"
#include "core/workgroup.h"
#include "techniques/phlm/pixel.glsl"
#include "techniques/phlm/filter.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2D motion_image;
layout(binding = 3) uniform sampler2D made_feature_image;  // this frame's, of the feature pass
layout(binding = 4) uniform sampler2D feature_image;       // the frame's before; rgb, a: view depth
layout(binding = 5) uniform sampler2D model_0;
layout(binding = 6) uniform sampler2D model_1;
layout(binding = 7) uniform sampler2D model_2;
layout(binding = 8) uniform sampler2D model_3;
layout(binding = 9) uniform sampler2D model_4;
layout(binding = 10) uniform sampler2D model_5;
layout(binding = 11) uniform sampler2D model_6;
layout(binding = 12) writeonly uniform image2D next_feature_image;
layout(binding = 13) writeonly uniform image2D next_model_0;
layout(binding = 14) writeonly uniform image2D next_model_1;
layout(binding = 15) writeonly uniform image2D next_model_2;
layout(binding = 16) writeonly uniform image2D next_model_3;
layout(binding = 17) writeonly uniform image2D next_model_4;
layout(binding = 18) writeonly uniform image2D next_model_5;
layout(binding = 19) writeonly uniform image2D next_model_6;
layout(binding = 20) writeonly uniform image2D output_image;
layout(binding = 21, std140) uniform Constants {
  PhlmConstants k;
};

vec4 between(sampler2D image, vec2 px, vec2 last_center_px) {
  if (kHardwareBilinear != 0u) {
    return bilinearHistory(image, px, k.frame.history_texel_uv, last_center_px);
  }
  return validHistory(image, px, last_center_px, vec4(1.0));
}

// Intercepts and level, which the colour is made of, at one texel.
vec4 colorTexel(ivec2 px) {
  if (kStorage != kStoragePaper) return texelFetch(model_0, px, 0);
  return vec4(texelFetch(model_0, px, 0).x, texelFetch(model_1, px, 0).x,
              texelFetch(model_2, px, 0).x, texelFetch(model_3, px, 0).x);
}

vec4 sampledCubic(sampler2D image, vec2 px, vec2 last_center_px) {
  return cubicHistory(image, px, k.frame.history_texel_uv, last_center_px, 0.5, false);
}

#include "techniques/phlm/cubic_color.glsl"

// An intercept about 0 may be negative, and is one with its slopes.
bool colorIsCubic() {
  return kHistoryFilter == kFilterCatmullRom && kAboutZero == 0u;
}

// The paper's: one image a colour with its four coefficients, one a row of P.
LinearModel loadPaperModel(vec2 px, vec2 last_center_px) {
  vec4 r = between(model_0, px, last_center_px);
  vec4 g = between(model_1, px, last_center_px);
  vec4 b = between(model_2, px, last_center_px);
  vec4 p0 = between(model_3, px, last_center_px);
  vec4 p1 = between(model_4, px, last_center_px);
  vec4 p2 = between(model_5, px, last_center_px);
  vec4 p3 = between(model_6, px, last_center_px);
  vec4 color = vec4(r.x, g.x, b.x, p0.x);
  if (colorIsCubic()) {
    color = kHardwareBilinear == 0u ? cubicColor(px, last_center_px)
                                    : vec4(sampledCubic(model_0, px, last_center_px).x,
                                           sampledCubic(model_1, px, last_center_px).x,
                                           sampledCubic(model_2, px, last_center_px).x,
                                           sampledCubic(model_3, px, last_center_px).x);
  }
  LinearModel m;
  m.intercept = color.rgb;
  m.level = color.a;
  m.slope_r = r.yzw;
  m.slope_g = g.yzw;
  m.slope_b = b.yzw;
  m.cross = p0.yzw;
  m.spread = vec3(p1.y, p2.z, p3.w);
  m.spread_cross = vec3(p1.z, p1.w, p2.w);
  return m;
}

void storePaperModel(ivec2 px, LinearModel m) {
  imageStore(next_model_0, px, vec4(m.intercept.x, m.slope_r));
  imageStore(next_model_1, px, vec4(m.intercept.y, m.slope_g));
  imageStore(next_model_2, px, vec4(m.intercept.z, m.slope_b));
  imageStore(next_model_3, px, vec4(m.level, m.cross));
  imageStore(next_model_4, px, vec4(m.cross.x, m.spread.x, m.spread_cross.xy));
  imageStore(next_model_5, px, vec4(m.cross.y, m.spread_cross.x, m.spread.y, m.spread_cross.z));
  imageStore(next_model_6, px, vec4(m.cross.z, m.spread_cross.yz, m.spread.z));
}

// Ours: the intercepts, which are colours, with the level; a colour's slopes with one covariance
// each; the rest of P.
LinearModel loadModel(vec2 px, vec2 last_center_px) {
  if (kStorage == kStoragePaper) return loadPaperModel(px, last_center_px);
  vec4 level;
  if (!colorIsCubic()) {
    level = between(model_0, px, last_center_px);
  } else if (kHardwareBilinear != 0u) {
    level = sampledCubic(model_0, px, last_center_px);
  } else {
    level = cubicColor(px, last_center_px);
  }
  vec4 r = between(model_1, px, last_center_px);
  vec4 g = between(model_2, px, last_center_px);
  vec4 b = between(model_3, px, last_center_px);
  vec4 spread = between(model_4, px, last_center_px);
  vec4 spread_cross = between(model_5, px, last_center_px);
  LinearModel m;
  m.intercept = level.rgb;
  m.level = level.a;
  m.slope_r = r.xyz;
  m.slope_g = g.xyz;
  m.slope_b = b.xyz;
  m.cross = vec3(r.w, g.w, b.w);
  m.spread = spread.xyz;
  m.spread_cross = vec3(spread.w, spread_cross.xy);
  return m;
}

// Nearest half of a signed number, by hand: whether a store truncates is the device's choice.
vec4 nearestHalf(vec4 v) {
  return vec4(sign(v.xyz) * roundedToHalfAt(abs(v.xyz), vec3(0.5)),
              sign(v.w) * roundedToHalfAt(vec3(abs(v.w)), vec3(0.5)).x);
}

void storeModel(ivec2 px, LinearModel m) {
  if (kStorage == kStoragePaper) {
    storePaperModel(px, m);
    return;
  }
  vec4 level = vec4(m.intercept, m.level);
  vec4 r = vec4(m.slope_r, m.cross.x);
  vec4 g = vec4(m.slope_g, m.cross.y);
  vec4 b = vec4(m.slope_b, m.cross.z);
  vec4 spread = vec4(m.spread, m.spread_cross.x);
  vec4 spread_cross = vec4(m.spread_cross.yz, 0.0, 0.0);
  if (kStorage == kStorageHalf) {
    // A long mean's steps are smaller than half's last bit: a threshold that varies lets them pass.
    level.rgb = evenlyRoundedToHalf(max(m.intercept, vec3(0.0)), px, k.frame.frame_number);
    level.a = nearestHalf(level).a;
    r = nearestHalf(r);
    g = nearestHalf(g);
    b = nearestHalf(b);
    spread = nearestHalf(spread);
    spread_cross = nearestHalf(spread_cross);
  }
  imageStore(next_model_0, px, level);
  imageStore(next_model_1, px, r);
  imageStore(next_model_2, px, g);
  imageStore(next_model_3, px, b);
  imageStore(next_model_4, px, spread);
  imageStore(next_model_5, px, spread_cross);
}

#include "techniques/phlm/filter_main.glsl"
