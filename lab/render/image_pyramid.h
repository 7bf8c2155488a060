// SPDX-License-Identifier: MIT
//
// Mip levels of a scene's images, made on the CPU: the same bytes on every device.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/scene/scene.h"

namespace reprise::lab {

// Levels of a width x height image down to 1 x 1.
uint32_t levelCount(uint32_t width, uint32_t height);

// RGBA8 of every level of `image`, resized to width x height at level 0. Colours are averaged as
// light (sRGB is decoded) and by coverage, so that what lies in holes does not bleed; normals are
// made unit again; with an alpha_cutoff each level keeps level 0's share of texels above it
// (Castano 2010, "Computing alpha mipmaps"), else leaves would thin out with distance.
std::vector<std::vector<uint8_t>> imagePyramid(const SceneImage& image, uint32_t width,
                                               uint32_t height);

// Share of texels whose alpha is at least `cutoff`.
float coverage(const std::vector<uint8_t>& rgba, float cutoff);

}  // namespace reprise::lab
