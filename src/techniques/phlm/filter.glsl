// SPDX-License-Identifier: MIT
// Algorithm 1 of Iglesias-Guitian et al. 2016 for one pixel, whatever holds the models: the
// including shader gives loadModel(px) and storeModel(px, model). Equation numbers refer to
// README.md.
#ifndef REPRISE_TECHNIQUES_PHLM_FILTER_GLSL
#define REPRISE_TECHNIQUES_PHLM_FILTER_GLSL

// The box of believable predictions (eq. 5), in RGB or YCoCg.
Bound believable(PhlmConstants k, vec3 s[9]) {
  if (kBox == kBoxVariance) {
    Moments m = moments(s);
    return Bound(m.mean - k.box_gamma * m.deviation, m.mean + k.box_gamma * m.deviation);
  }
  return kBox == kBoxRounded ? roundedExtremes(s) : squareExtremes(s);
}

Bound widened(Bound bound, float factor) {
  vec3 centre = 0.5 * (bound.low + bound.high);
  vec3 half_size = 0.5 * (bound.high - bound.low) * factor;
  return Bound(centre - half_size, centre + half_size);
}

struct Correction {
  vec3 color;  // where the ray from the prediction to the sample enters the box
  bool needed;
};

Correction correctedPrediction(PhlmConstants k, vec3 s[9], vec3 y, vec3 feature, vec3 prediction,
                               bool still) {
  vec3 box_s[9];
  for (int i = 0; i < 9; ++i) box_s[i] = kBoxYCoCg != 0u ? yCoCgFromRgb(s[i]) : s[i];
  vec3 target = kBoxYCoCg != 0u ? yCoCgFromRgb(y) : y;
  vec3 f = kBoxYCoCg != 0u ? yCoCgFromRgb(prediction) : prediction;
  Bound bound = believable(k, box_s);
  if (kBoxFeature == kBoxFeatureAlways || (kBoxFeature == kBoxFeatureStill && still)) {
    // A line thinner than a pixel leaves neighbourhoods that say nothing of it; the feature has
    // seen it, and forgets what has gone.
    vec3 steady = kBoxYCoCg != 0u ? yCoCgFromRgb(feature) : feature;
    bound.low = min(bound.low, steady);
    bound.high = max(bound.high, steady);
  }
  if (still) bound = widened(bound, k.box_still);
  float slack = boundSlack(f, target);
  vec3 low = bound.low - slack;
  vec3 high = bound.high + slack;
  // Not by comparing the hit with the prediction: y + (f - y) is not f to the last bit.
  bool outside = any(lessThan(f, low)) || any(greaterThan(f, high));
  vec3 hit = clipTowardSample(low, high, target, f);
  return Correction(kBoxYCoCg != 0u ? rgbFromYCoCg(hit) : hit, outside);
}

bool isUpdated(ivec2 px, float frame_number) {
  uint turn = uint(frame_number);
  if (kUpdate == kUpdateHalf) return (uint(px.x + px.y) + turn) % 2u == 0u;
  // 2 x 2 pixels in the order of a helix: diagonal, then across.
  if (kUpdate == kUpdateQuarter) {
    uint place = uint(px.x & 1) + 2u * uint(px.y & 1);
    uint order[4] = uint[4](0u, 3u, 1u, 2u);
    return place == order[turn % 4u];
  }
  return true;
}

// What reprojection leaves: nothing that is no number, nothing that outgrew its storage.
bool isSound(LinearModel m) {
  return abs(m.intercept.x) < kMaxColor && abs(m.intercept.y) < kMaxColor &&
         abs(m.intercept.z) < kMaxColor && m.level > 0.0;
}

// A model that knows a colour, about the feature: the paper's prior is about 0, where it lets the
// slopes have their part of the first error.
LinearModel knownColor(vec3 color, float level, float spread, vec3 feature) {
  LinearModel m = constantModel(color, level, spread);
  return kAboutZero != 0u ? shiftedModel(m, feature) : m;
}

float forgetting(PhlmConstants k, vec3 y, vec3 prediction) {
  if (kForget == kForgetEvenly) return k.lambda;
  float feedback = contrastFeedback(toneMappedLuma(y), toneMappedLuma(prediction));
  return max(1.0 - (1.0 - k.lambda) * feedback, 0.5);
}

struct Filtered {
  LinearModel model;  // about the pixel's feature
  vec3 color;
  bool rests;  // a running mean
};

// `model` comes from where the pixel was, in this frame's exposure, about the feature that it had
// there (`old_feature`).
Filtered filteredPixel(PhlmConstants k, ivec2 px, vec3 s[9], LinearModel model, vec3 old_feature,
                       vec3 feature, Origin origin) {
  // At rest jitter does what the input's filter does in motion, and ends exact.
  vec3 y = origin.still
               ? s[4]
               : weightedSample(s, k.filter_weights_0_3, k.filter_weights_4_7, k.filter_weight_8.x);
  // About the feature x = (1, 0). At rest the model stays where it was: a feature that still
  // settles would add the slopes' variance to the mean's.
  const vec3 kHere = vec3(0.0);
  if (!origin.still) model = shiftedModel(model, feature - old_feature);
  vec3 prediction = model.intercept;
  Filtered result;
  result.rests = false;
  // One test for both, so that no number that is none passes.
  bool sound = isSound(model) && all(lessThan(abs(prediction), vec3(kMaxColor)));
  if (!origin.valid || !sound) {
    // The first sample is in: what eq. 3 leaves of the prior.
    result.model = updatedModel(knownColor(y, k.level_variance, k.spread_variance, feature), kHere,
                                vec3(0.0), k.lambda);
    result.color = y;
    return result;
  }
  model = boundedModel(model, k.variance_limit, k.variance_limit);

  Correction correction = correctedPrediction(k, s, y, feature, prediction, origin.still);
  bool unbounded = origin.still && k.box_still <= 0.0;
  if (correction.needed && !unbounded) {
    if (kClip == kClipReset) {
      model = knownColor(correction.color, k.clip_variance, k.spread_variance, feature);
    } else {
      model.intercept = correction.color;
      model.level = max(model.level, k.clip_variance);
    }
    prediction = correction.color;
  }

  result.model = model;
  result.color = prediction;
  if (!isUpdated(px, k.frame.frame_number)) return result;
  if (origin.still) {
    // Only the intercept learns, and forgets nothing: the running mean (eq. 7), of light whatever
    // the models are of: a mean of compressed colours is too dark for ever.
    LinearModel mean = model;
    mean.cross = vec3(0.0);
    mean.level = max(mean.level, k.still_variance);
    mean.intercept = fromWorking(mean.intercept);
    mean = updatedModel(mean, kHere, fromWorking(y) - mean.intercept, 1.0);
    mean.intercept = toWorking(mean.intercept);
    result.color = mean.intercept;
    result.model = mean;
    result.rests = true;
    return result;
  }
  result.model = updatedModel(model, kHere, y - prediction, forgetting(k, y, prediction));
  result.color = result.model.intercept;
  return result;
}

#endif
