// SPDX-License-Identifier: MIT
// Algorithm 1 of Iglesias-Guitian et al. 2016 for one pixel, whatever holds the models: the
// including shader gives loadModel(px) and storeModel(px, model). Equation numbers refer to
// README.md.
#ifndef REPRISE_TECHNIQUES_PHLM_FILTER_GLSL
#define REPRISE_TECHNIQUES_PHLM_FILTER_GLSL

// The paper's form keeps models about feature 0; all others about the pixel's own feature, which
// shiftedModel changes exactly.
const bool kAboutZero = kStorage == kStoragePaper;

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

// A model about zero as a mean that the feature does not move. About the feature it would do to
// leave the slopes alone; brought back to zero their variance of 1000 z^2 would swallow the mean's
// 1 / n in single precision. One that rests already is told by its covariances, which are 0.
LinearModel restingModel(LinearModel m, vec3 z, float spread) {
  bool rests = all(equal(m.cross, vec3(0.0)));
  return constantModel(predictedColor(m, z), rests ? m.level : predictionVariance(m, z), spread);
}

struct Filtered {
  LinearModel model;
  vec3 color;
};

// `model` comes from where the pixel was, in this frame's exposure, about the feature that it had
// there (`old_feature`), or about 0.
Filtered filteredPixel(PhlmConstants k, ivec2 px, vec3 s[9], LinearModel model, vec3 old_feature,
                       vec3 feature, Origin origin) {
  // At rest jitter does what the input's filter does in motion, and ends exact.
  vec3 y = origin.still
               ? s[4]
               : weightedSample(s, k.filter_weights_0_3, k.filter_weights_4_7, k.filter_weight_8.x);
  // About the feature x = (1, 0), about zero x = (1, z). At rest the model stays where it was: a
  // feature that still settles would add the slopes' variance to the mean's.
  vec3 z = kAboutZero ? (origin.still ? old_feature : feature) : vec3(0.0);
  if (!kAboutZero) model = shiftedModel(model, origin.still ? vec3(0.0) : feature - old_feature);
  vec3 prediction = predictedColor(model, z);
  // One test for both, so that no number that is none passes.
  bool sound = isSound(model) && all(lessThan(abs(prediction), vec3(kMaxColor)));
  if (!origin.valid || !sound) {
    Filtered reset;
    z = kAboutZero ? feature : vec3(0.0);
    reset.model = constantModel(y, k.level_variance, k.spread_variance);
    // The first sample is in: what eq. 3 leaves of the prior.
    reset.model = updatedModel(reset.model, z, vec3(0.0), k.lambda);
    reset.color = y;
    return reset;
  }
  model = boundedModel(model, k.variance_limit, k.variance_limit);

  Correction correction = correctedPrediction(k, s, y, feature, prediction, origin.still);
  bool unbounded = origin.still && k.box_still <= 0.0;
  if (correction.needed && !unbounded) {
    if (kClip == kClipReset) {
      model = constantModel(correction.color, k.clip_variance, k.spread_variance);
    } else {
      float level = predictionVariance(model, z);
      model.intercept += correction.color - prediction;
      model.level += max(k.clip_variance - level, 0.0);
    }
    prediction = correction.color;
  }

  Filtered result;
  result.model = model;
  result.color = prediction;
  if (!isUpdated(px, k.frame.frame_number)) return result;
  if (origin.still) {
    // Only the intercept learns, and forgets nothing: the running mean (eq. 7), of light whatever
    // the models are of: a mean of compressed colours is too dark for ever.
    LinearModel here = kAboutZero ? restingModel(model, z, k.spread_variance) : model;
    here.cross = vec3(0.0);
    here.level = max(here.level, k.still_variance);
    here.intercept = fromWorking(here.intercept);
    here = updatedModel(here, vec3(0.0), fromWorking(y) - here.intercept, 1.0);
    here.intercept = toWorking(here.intercept);
    result.color = here.intercept;
    result.model = here;
    return result;
  }
  result.model = updatedModel(model, z, y - prediction, k.lambda);
  result.color = predictedColor(result.model, z);
  return result;
}

#endif
