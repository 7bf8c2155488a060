// SPDX-License-Identifier: MIT
//
// The technique's passes: shaders, bindings, specialization. Each folder's shader names its
// bindings in the order in which they are declared here.
#pragma once

#include "core/technique.h"

namespace reprise::amortized {

// What is compiled into the shaders.
struct Variant {
  uint32_t slots = 4;
  bool exact_motion = false;
  bool silhouettes = false;  // the projection is jittered
  bool residuals = false;
  bool coverage = false;
  bool shutter = false;
};

struct RequestPasses {
  PassHandle gather = 0;     // the history, which quadrants of which pixels failed, how many a rank
  PassHandle threshold = 0;  // the rank at which the budget ends
  PassHandle list = 0;       // the pixels that are within it
  PassHandle blend = 0;      // in the place of the resolve: the rest of it
};

struct ResidualPasses {
  PassHandle rows = 0;
  PassHandle columns = 0;
};

RequestPasses declareRequestPasses(Declaration& declaration, const Variant& variant);
PassHandle declareResolvePass(Declaration& declaration, const Variant& variant);
PassHandle declareCoveragePass(Declaration& declaration);
ResidualPasses declareResidualPasses(Declaration& declaration);

}  // namespace reprise::amortized
