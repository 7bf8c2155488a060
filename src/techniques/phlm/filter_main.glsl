// SPDX-License-Identifier: MIT
// The body of both filter shaders, which differ in how they hold models.

// Models are computed with about the pixel's own feature, and stored so unless the paper's origin
// is asked for. There all of P but one direction is large: what bounds it or cuts a negative
// colour must not be done about 0, where the prediction is a difference of what it changes.
// A running mean is kept as one that no feature moves, told by its covariances of exactly 0: about
// 0 the slopes' variance of 1000 z^2 would swallow the mean's 1 / n in single precision.
LinearModel withoutSlopes(LinearModel m) {
  LinearModel r = constantModel(m.intercept, m.level, 0.0);
  r.spread = m.spread;
  return r;
}
LinearModel fromZero(LinearModel m, vec3 feature) {
  return all(equal(m.cross, vec3(0.0))) ? m : shiftedModel(m, feature);
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  vec3 s[9];
  for (int i = 0; i < 9; ++i) {
    s[i] = toWorking(fetchColor(color_image, px + ivec2(i % 3 - 1, i / 3 - 1), last_px));
  }
  Origin origin = originOf(depth_image, motion_image, k, px, last_px);
  vec4 previous = textureLod(feature_image, origin.px * k.frame.history_texel_uv, 0.0);
  origin.valid = origin.valid && sameSurface(k, origin, px, previous.a);
  vec3 old_feature = exposed(previous.rgb, k.frame.exposure_ratio);
  vec3 feature;
  if (kFused != 0u) {
    feature = temporalFeature(k, s, old_feature, origin);
    // The model is about the feature that the next frame will read.
    feature = evenlyRoundedToHalf(min(feature, vec3(kMaxColor)), px, k.frame.frame_number);
    imageStore(next_feature_image, px, vec4(feature, origin.view_depth));
  } else {
    feature = texelFetch(made_feature_image, px, 0).rgb;
  }
  LinearModel model = loadModel(origin.px, k.frame.previous_extent_px - 0.5);
  if (kAboutZero != 0u) model = fromZero(model, previous.rgb);
  if (kCompressed != 0u) {
    model.intercept = exposed(model.intercept, k.frame.exposure_ratio);
  } else {
    model = exposedModel(model, k.frame.exposure_ratio);
  }
  Filtered filtered = filteredPixel(k, px, s, model, old_feature, feature, origin);
  LinearModel kept = boundedModel(filtered.model, k.variance_limit, k.variance_limit);
  if (kAboutZero != 0u) kept = filtered.rests ? withoutSlopes(kept) : shiftedModel(kept, -feature);
  storeModel(px, kept);
  imageStore(output_image, px, vec4(min(fromWorking(filtered.color), vec3(kMaxColor)), 1.0));
}
