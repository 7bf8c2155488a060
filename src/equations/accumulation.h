// SPDX-License-Identifier: MIT
// Weights of exponential accumulation.
#ifndef REPRISE_EQUATIONS_ACCUMULATION_H
#define REPRISE_EQUATIONS_ACCUMULATION_H

#include "equations/language.h"
EQ_BEGIN

// Variance reduction, as a number of independent samples, of an exponential filter of weight alpha
// that began with its first sample and has seen n >= 1 (Yang, Liu, Salvi 2020, section 3.2).
EQ_FN float effectiveSamples(float alpha, float n) {
  float q = (1.0f - alpha) * (1.0f - alpha);
  float tail = pow(q, n - 1.0f);
  return 1.0f / (alpha * alpha * (1.0f - tail) / (1.0f - q) + tail);
}

// The same after infinitely many.
EQ_FN float steadyEffectiveSamples(float alpha) {
  return (2.0f - alpha) / alpha;
}

// Effective samples after one more, of weight alpha, joins a history of `samples` (Yang et al.
// 2009, eq. 8).
EQ_FN float nextEffectiveSamples(float samples, float alpha) {
  return 1.0f / (alpha * alpha + (1.0f - alpha) * (1.0f - alpha) / samples);
}

// Weight of the current sample for an exact mean while `count` samples are held, and for the
// exponential filter once that would fall below `alpha_min` (Yang, Liu, Salvi 2020, section 3.2).
EQ_FN float runningMeanAlpha(float count, float alpha_min) {
  return max(1.0f / (count + 1.0f), alpha_min);
}

// Weight of history after one more sample: 0, 1/2, 2/3, 3/4 ... (MiniEngine, TemporalBlendCS).
// Another form of the running mean, for a history that stores its weight instead of a count.
EQ_FN float nextConfidence(float confidence) {
  return clamp(1.0f / (2.0f - confidence), 0.0f, 1.0f);
}

// Pedersen 2016 (INSIDE, after Lottes): similar lumas keep more history. Weight of the current
// sample between 0.03 (equal) and 0.12 (unlike), as a factor on 0.06, their geometric mean.
EQ_FN float contrastFeedback(float luma_now, float luma_then) {
  float difference = abs(luma_now - luma_then) / max(luma_now, max(luma_then, 0.2f));
  float w = 1.0f - clamp(difference, 0.0f, 1.0f);
  return mix(2.0f, 0.5f, w * w);
}

// Karis 2014: less of the current sample where history lies near the bound, so that a bound that
// jumps from frame to frame does not drag the image along. Factor in [0.2, 1]; 0.2 keeps it moving.
EQ_FN float boundsFeedback(float luma_then, float low, float high) {
  float distance = max(min(luma_then - low, high - luma_then), 0.0f);
  float range = max(high - low, 1.0e-4f);
  return mix(0.2f, 1.0f, clamp(4.0f * distance / range, 0.0f, 1.0f));
}

// Filament, "prevent flicker": factor in [0, 1] that falls with the square of the lumas' likeness.
EQ_FN float changeFeedback(float luma_now, float luma_then) {
  float change = abs(luma_now - luma_then) / (0.001f + max(luma_now, luma_then));
  float alike = max(1.0f - change, 0.0f);
  return alike * alike;
}

// 1 at rest, 0 at `limit_px` a frame and above: 64 px in MiniEngine, 128 in Intel's TAA.
EQ_FN float speedFactor(float speed_px, float limit_px) {
  return clamp(1.0f - speed_px / limit_px, 0.0f, 1.0f);
}

// Jimenez 2017: the weight that forgets with time constant `tau_s` at any frame time.
EQ_FN float frameRateAlpha(float frame_time_s, float tau_s) {
  return 1.0f - exp(-frame_time_s / tau_s);
}

EQ_END
#endif
