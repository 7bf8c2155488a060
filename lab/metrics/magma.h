// SPDX-License-Identifier: MIT
#pragma once

#include "lab/float_image.h"

namespace reprise::lab {

// An error map in [0, 1], one channel, as RGB display values: matplotlib's magma by polynomials of
// degree six a channel, fitted to its table (largest difference 0.024).
FloatImage magmaImage(const FloatImage& error);

}  // namespace reprise::lab
