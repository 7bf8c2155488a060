// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "equations/language.h"

namespace reprise::eq {

// Longest blue-noise cycle.
inline constexpr uint32_t kMaxBlueNoise = 256;

// kMaxBlueNoise sample offsets in (-0.5, 0.5] px whose every prefix is well spread on
// the torus: each point fills the largest void that the ones before left (the filling phase of
// Ulichney 1993, void and cluster), on a grid of 32 x 32 cells. The first is at the centre of a cell
// near the pixel's. Deterministic; computed once and kept.
const std::vector<vec2>& blueNoiseSequence();

}  // namespace reprise::eq
