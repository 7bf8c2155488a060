// SPDX-License-Identifier: MIT
//
// All that a frame takes from its history; it needs depth and motion and no colour, so that a
// request gathers before the frame is shaded, and the resolve need not gather again.
#ifndef REPRISE_AMORTIZED_GATHER_GLSL
#define REPRISE_AMORTIZED_GATHER_GLSL

#include "techniques/amortized/reproject.glsl"

// What a footprint of a buffer holds.
struct Texels {
  vec3 colors[4];
  vec4 depths;
};

Texels texelsOf(uint b, Footprint f) {
  Texels texels;
  for (int i = 0; i < 4; ++i) {
    vec4 texel = texelIn(b, texelOf(ivec2(f.base), i));
    texels.colors[i] = texel.rgb;
    texels.depths[i] = texel.a;
  }
  return texels;
}

vec3 weighted(Texels texels, vec4 w) {
  return w.x * texels.colors[0] + w.y * texels.colors[1] + w.z * texels.colors[2] +
         w.w * texels.colors[3];
}

// What passes the pixel while the shutter is open, about the instant of the frame: sum and weight.
vec4 throughShutter(Surface s, Way ways[4], int taps) {
  vec4 sum = vec4(0.0);
  for (int tap = 0; tap < taps; ++tap) {
    float instant = (float(tap) + 0.5) / float(taps) - 0.5;
    vec2 offset_px = instant * k.shutter * s.motion_px;
    for (uint b = 0u; b < kSlots; ++b) {
      SlotState state = k.slots[b];
      Footprint f = footprintIn(state, state.place_age.xy, s, ways[b].motion_px, offset_px);
      if (!f.readable) continue;
      Texels texels = texelsOf(b, f);
      vec4 w = tentWeights(f.point.x, f.point.y, kPixelTentRadius_px * f.growth) *
               validTexels(texels.depths, f, state, s, ways[b]);
      sum += vec4(state.exposure_ratio * weighted(texels, w), sumOf(w));
    }
  }
  return sum;
}

// `previous` lies in `counts`, N of the previous frame.
Gathered gatherHistory(Surface s, Way ways[4], Previous previous, sampler2D counts) {
  // (16) for the buffer to be written and (20) for the pixel, of the same texels: a buffer's tent
  // reaches half a pixel from a quadrant, and so no farther than the pixel's own.
  vec4 target = vec4(0.0);  // sum, weight
  vec4 pixel = vec4(0.0);
  uint quadrants = 0u;
  for (uint b = 0u; b < kSlots; ++b) {
    SlotState state = k.slots[b];
    Footprint f = footprintIn(state, state.place_age.xy, s, ways[b].motion_px, vec2(0.0));
    vec4 whole = tentWeights(f.point.x, f.point.y, kPixelTentRadius_px * f.growth);
    float seen = 0.0;
    if (f.readable) {
      Texels texels = texelsOf(b, f);
      vec4 valid = validTexels(texels.depths, f, state, s, ways[b]);
      vec2 place = f.point + f.column_x * k.target_px.x + f.column_y * k.target_px.y;
      vec4 w = tentWeights(place.x, place.y, k.target_px.z * f.growth) * valid;
      target += vec4(state.exposure_ratio * weighted(texels, w), sumOf(w));
      w = whole * valid;
      seen = sumOf(w);
      pixel += vec4(state.exposure_ratio * weighted(texels, w), seen);
    }
    if (reprojectionFailed(seen, sumOf(whole))) quadrants |= state.quadrants;
  }
  if (kShutter != 0u) {
    int taps = shutterTaps(s.motion_px);
    if (taps > 1) pixel = throughShutter(s, ways, taps);
  }
  Gathered g;
  g.begins = target.a <= kLeastWeight;
  g.target = g.begins ? vec3(0.0) : target.rgb / target.a;
  g.pixel = pixel.rgb / max(pixel.a, kLeastWeight);
  g.pixel_weight = pixel.a;
  g.count = pixel.a > kLeastWeight ? samplesBefore(counts, previous) : 0.0;
  g.quadrants = quadrants;
  return g;
}

struct Change {
  vec4 residuals;  // of the last four updates, where the surface was
  float bound;     // (27)
};

Change changeBefore(Previous previous, sampler2D residuals, sampler2D smoothed) {
  Change change = Change(vec4(0.0), 0.0);
  float mean = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 texel = texelOf(previous.base, i);
    change.residuals += previous.shares[i] * unpackedResiduals(texelFetch(residuals, texel, 0));
    mean += previous.shares[i] * texelFetch(smoothed, texel, 0).x;
  }
  change.bound = residualBound(mean, k.residual_tolerance);
  return change;
}

#endif
