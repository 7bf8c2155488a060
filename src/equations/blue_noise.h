// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "equations/language.h"

namespace reprise::eq {

// Longest blue-noise cycle.
inline constexpr uint32_t kMaxBlueNoise = 256;

// kMaxBlueNoise sample offsets in (-0.5, 0.5] px whose every prefix is well spread on the torus,
// without the rows and columns of a lattice: void and cluster (Ulichney 1993) on 64 x 64 cells, in
// the order of rank. The first is at the pixel's centre, up to half a cell. The same on every
// compiler; computed once (some ten milliseconds) and kept.
const std::vector<vec2>& blueNoiseSequence();

}  // namespace reprise::eq
