// SPDX-License-Identifier: MIT
// C++ only: every sequence of jitter.h and blue noise behind one call, for sample plans.
#pragma once

#include "equations/jitter.h"

namespace reprise::eq {

// Frames after which the sequence repeats when `length` are asked for.
uint32_t sequencePeriod(uint32_t sequence, uint32_t length);
// Offset from the pixel centre in px of frame `index` % period.
vec2 sequenceOffset(uint32_t sequence, uint64_t index, uint32_t length);
// Mean offset of one period. Subtracted, it leaves the converged image unshifted.
vec2 sequenceMean(uint32_t sequence, uint32_t length);

}  // namespace reprise::eq
