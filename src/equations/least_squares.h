// SPDX-License-Identifier: MIT
// Recursive least squares of a pixel's colour against a feature of three numbers (Ljung,
// Soederstrom 1987; Iglesias-Guitian et al. 2016, eq. 4, 6, 7), with what keeps it sound for ever:
// storage that cannot become unsymmetric, and variances that cannot wind up.
#ifndef REPRISE_EQUATIONS_LEAST_SQUARES_H
#define REPRISE_EQUATIONS_LEAST_SQUARES_H

#include "equations/language.h"
EQ_BEGIN

// colour = intercept + slopes (z - origin), z the feature. `slope_r` is the derivative of red by
// the three features, and so on. The inverse covariance of the coefficients, in units of one
// sample's variance, is one for all three colours:
//   P = ( level       cross^T )   with S = ( spread.x       spread_cross.x  spread_cross.y )
//       ( cross       S       )            ( spread_cross.x spread.y        spread_cross.z )
//                                          ( spread_cross.y spread_cross.z  spread.z       )
// `level` is the variance of the prediction at the origin: 1 / n after n samples of a constant.
struct LinearModel {
  vec3 intercept;
  vec3 slope_r;
  vec3 slope_g;
  vec3 slope_b;
  float level;
  vec3 cross;
  vec3 spread;
  vec3 spread_cross;
};

// A model that knows nothing but a colour, with these prior variances.
EQ_FN LinearModel constantModel(vec3 color, float level, float spread) {
  LinearModel m;
  m.intercept = color;
  m.slope_r = vec3(0.0f);
  m.slope_g = vec3(0.0f);
  m.slope_b = vec3(0.0f);
  m.level = level;
  m.cross = vec3(0.0f);
  m.spread = vec3(spread);
  m.spread_cross = vec3(0.0f);
  return m;
}

// Eq. 4 for a feature `z` away from the origin.
EQ_FN vec3 predictedColor(LinearModel m, vec3 z) {
  return m.intercept + vec3(dot(m.slope_r, z), dot(m.slope_g, z), dot(m.slope_b, z));
}

EQ_FN vec3 spreadTimes(LinearModel m, vec3 z) {
  return vec3(m.spread.x * z.x + m.spread_cross.x * z.y + m.spread_cross.y * z.z,
              m.spread_cross.x * z.x + m.spread.y * z.y + m.spread_cross.z * z.z,
              m.spread_cross.y * z.x + m.spread_cross.z * z.y + m.spread.z * z.z);
}

// Variance x^T P x of the prediction at `z` away from the origin, x = (1, z).
EQ_FN float predictionVariance(LinearModel m, vec3 z) {
  return m.level + 2.0f * dot(m.cross, z) + dot(z, spreadTimes(m, z));
}

// The same model about another origin, `shift` away: beta' = T beta, P' = T P T^T with
// T = (1 shift^T; 0 I). Exact. A model about the present feature predicts by its intercept and, in
// half precision, keeps the digits that the prediction needs.
EQ_FN LinearModel shiftedModel(LinearModel m, vec3 shift) {
  LinearModel r = m;
  vec3 along = spreadTimes(m, shift);
  r.intercept = predictedColor(m, shift);
  r.level = m.level + 2.0f * dot(m.cross, shift) + dot(shift, along);
  r.cross = m.cross + along;
  return r;
}

// The model in an exposure that is `ratio` times the old one: colour and feature scale together.
EQ_FN LinearModel exposedModel(LinearModel m, float ratio) {
  LinearModel r = m;
  r.intercept = m.intercept * ratio;
  r.cross = m.cross / ratio;
  r.spread = m.spread / (ratio * ratio);
  r.spread_cross = m.spread_cross / (ratio * ratio);
  return r;
}

// Eq. 6 and 7: one sample at `z` away from the origin, whose colour is `error` above the
// prediction; `forgetting` is lambda.
EQ_FN LinearModel updatedModel(LinearModel m, vec3 z, vec3 error, float forgetting) {
  LinearModel r;
  float p_level = m.level + dot(m.cross, z);  // P x
  vec3 p = m.cross + spreadTimes(m, z);
  float scale = 1.0f / (forgetting + p_level + dot(p, z));
  r.intercept = m.intercept + error * (p_level * scale);
  r.slope_r = m.slope_r + p * (error.x * scale);
  r.slope_g = m.slope_g + p * (error.y * scale);
  r.slope_b = m.slope_b + p * (error.z * scale);
  float keep = 1.0f / forgetting;
  r.level = (m.level - p_level * p_level * scale) * keep;
  r.cross = (m.cross - p * (p_level * scale)) * keep;
  r.spread = (m.spread - p * p * scale) * keep;
  r.spread_cross = (m.spread_cross - vec3(p.x * p.y, p.x * p.z, p.y * p.z) * scale) * keep;
  return r;
}

// Smallest variance that a model keeps: 4096 samples; below, rounding could turn it negative.
EQ_CONST float kLeastVariance = 1.0f / 4096.0f;

EQ_FN float boundedCovariance(float c, float a, float b) {
  float limit = sqrt(a * b);
  return clamp(c, -limit, limit);
}

// Windup: with forgetting below 1, what the feature does not excite grows by 1 / lambda a frame,
// for ever. Each variance above its limit is brought back to it, and its covariances with it: D P
// D, D diagonal, which leaves P positive. Covariances that rounding has made larger than their
// variances allow are cut.
EQ_FN LinearModel boundedModel(LinearModel m, float level_limit, float spread_limit) {
  LinearModel r = m;
  r.level = clamp(m.level, kLeastVariance, level_limit);
  r.spread = clamp(m.spread, vec3(kLeastVariance), vec3(spread_limit));
  float d0 = sqrt(min(1.0f, level_limit / max(m.level, kLeastVariance)));
  vec3 d = sqrt(min(vec3(1.0f), vec3(spread_limit) / max(m.spread, vec3(kLeastVariance))));
  vec3 c = m.cross * d * d0;
  r.cross =
      vec3(boundedCovariance(c.x, r.level, r.spread.x), boundedCovariance(c.y, r.level, r.spread.y),
           boundedCovariance(c.z, r.level, r.spread.z));
  vec3 s = m.spread_cross * vec3(d.x * d.y, d.x * d.z, d.y * d.z);
  r.spread_cross = vec3(boundedCovariance(s.x, r.spread.x, r.spread.y),
                        boundedCovariance(s.y, r.spread.x, r.spread.z),
                        boundedCovariance(s.z, r.spread.y, r.spread.z));
  return r;
}

// Weight of the new low-passed sample in the temporal feature (Iglesias-Guitian et al. 2016,
// section 5.1): phi / (l + range), phi = a l^2 + b v l^3, l the distance of the feature's luma to
// the nearer end of the neighbourhood's range, v the speed in px a frame.
EQ_FN float featureAlpha(float distance, float range, float speed_px, float a, float b) {
  float phi = distance * distance * (a + b * speed_px * distance);
  return phi / max(distance + range, 1.0e-6f);
}

EQ_END
#endif
