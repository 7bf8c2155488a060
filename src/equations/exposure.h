// SPDX-License-Identifier: MIT
// How bright a picture is, what an eye that looks at it is adapted to, and how it is exposed then.
#ifndef REPRISE_EQUATIONS_EXPOSURE_H
#define REPRISE_EQUATIONS_EXPOSURE_H

#include "equations/color_space.h"
#include "equations/language.h"
EQ_BEGIN

// Keeps the logarithm of black finite, and with it the exposure of a black picture.
EQ_CONST float kLeastLuminance = 1.0e-4f;
// Reinhard et al. 2002, section 3: the key that an average picture is exposed to.
EQ_CONST float kMiddleGrey = 0.18f;

// Reinhard et al. 2002 (1): the luminance of a picture is exp of the mean of this over its pixels.
EQ_FN float logLuminance(vec3 c) {
  return log(kLeastLuminance + luma709(c));
}

// Krawczyk, Myszkowski, Seidel 2005 (5): what the eye is adapted to follows the picture's luminance
// exponentially, with the time constant `constant_s`.
EQ_FN float adaptedLuminance(float before, float now, float frame_time_s, float constant_s) {
  return before + (now - before) * (1.0f - exp(-frame_time_s / constant_s));
}

// Reinhard et al. 2002 (2): scene colour times this is what the tone curve takes.
EQ_FN float exposureFor(float adapted_luminance) {
  return kMiddleGrey / adapted_luminance;
}

EQ_END
#endif
