// SPDX-License-Identifier: MIT
//
// A coarse pixel: kSize x kSize pixels from base_px on. Which of them show a triangle is a mask:
// bit i is pixelOf(base_px, i).
#ifndef REPRISE_LAB_COARSE_PIXEL_GLSL
#define REPRISE_LAB_COARSE_PIXEL_GLSL

// Pixels a side of a coarse pixel. Known to the compiler: CPU drivers divide lane by lane, and run
// a loop of unknown length once more than it has turns.
layout(constant_id = 7) const int kSize = 2;
const int kPixels = kSize * kSize;

// A plane that is seen edge-on runs through infinity within a few pixels: beyond this ratio of view
// depths to the covered pixel a triangle is shaded where it is covered.
const float kFarthestExtrapolation = 4.0;

ivec2 pixelOf(ivec2 base_px, int i) {
  return base_px + ivec2(i % kSize, i / kSize);
}

bool withinFrame(ivec2 px) {
  return all(greaterThanEqual(px, ivec2(0))) && all(lessThan(px, ivec2(frame.extent_px)));
}

// Proportional to 1 / view depth of the triangle's plane at a position.
float inverseDepth(VisibleTriangle seen, vec2 sample_px) {
  vec2 ndc = sample_px / frame.extent_px * 2.0 - 1.0;
  return perspectiveSum(clipFromWorld(positionU(seen.triangle.x).xyz, 0u),
                        clipFromWorld(positionU(seen.triangle.y).xyz, 0u),
                        clipFromWorld(positionU(seen.triangle.z).xyz, 0u), ndc);
}

bool isShownIn(uint shown_in, int i) {
  return (shown_in >> i & 1u) != 0u;
}

// Whose light tile a triangle is shaded in: the last pixel that shows it. Where the grid begins
// beside the tiles by a pixel, the first of a row would be in another tile than the rest of its
// subgroup, whose lanes then wait for each other's lamps.
ivec2 tilePixelOf(ivec2 base_px, uint shown_in) {
  return pixelOf(base_px, findMSB(shown_in));
}

vec2 middleOf(ivec2 base_px, uint shown_in) {
  vec2 sum_px = vec2(0.0);
  float count = 0.0;
  for (int i = 0; i < kPixels; ++i) {
    if (!isShownIn(shown_in, i)) continue;
    sum_px += vec2(pixelOf(base_px, i)) + 0.5;
    count += 1.0;
  }
  return sum_px / count;
}

// Where a triangle is shaded: amid the pixels that show it, or at the coarse centre.
vec2 coarsePosition(VisibleTriangle seen, ivec2 base_px, uint shown_in, vec2 jitter_px,
                    bool amid_covered) {
  vec2 sample_px = vec2(base_px) + 0.5 * float(kSize) - jitter_px;
  if (amid_covered) sample_px = middleOf(base_px, shown_in) - jitter_px;
  vec2 own_px = vec2(pixelOf(base_px, findLSB(shown_in))) + 0.5 - jitter_px;
  float ratio = inverseDepth(seen, own_px) / inverseDepth(seen, sample_px);
  bool reachable = ratio > 1.0 / kFarthestExtrapolation && ratio < kFarthestExtrapolation;
  return reachable ? sample_px : own_px;
}

#endif
