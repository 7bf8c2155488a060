// SPDX-License-Identifier: MIT
#include "equations/hidden_light.h"

#include <gtest/gtest.h>

namespace reprise::eq {
namespace {

TEST(HiddenLight, OfTheSampleThatTheGainWasMadeOfIsTheSum) {
  for (const float gleam : {0.0f, 0.3f}) {
    const vec3 shown(0.2f, 0.05f, 0.0f);
    const vec3 hidden(0.1f, 0.4f, 0.7f);
    const float base = hiddenBase({gleam, 0.5f * gleam, 0.0f}, hidden);
    const vec3 whole = withHiddenLight(shown, hiddenGain(shown, hidden, base), base);
    EXPECT_NEAR(whole.x, 0.3f, 1e-6f);
    EXPECT_NEAR(whole.y, 0.45f, 1e-6f);
    EXPECT_NEAR(whole.z, 0.7f, 1e-6f);
  }
}

TEST(HiddenLight, FollowsTheSurfaceAndNotTheGleam) {
  // A sample on a joint half as bright as the surface around, which the hidden light follows by
  // the share of the shown one: 0.2 (0.1 + 0.002) / (0.2 + 0.1 + 0.002) more than the sample's own.
  const vec3 hidden(0.1f, 0.1f, 0.1f);
  const float base = hiddenBase({0.0f, 0.0f, 0.0f}, hidden);
  EXPECT_FLOAT_EQ(base, 0.102f);
  const vec3 joint = hiddenGain({0.2f, 0.2f, 0.2f}, hidden, base);
  EXPECT_NEAR(withHiddenLight({0.4f, 0.4f, 0.4f}, joint, base).x, 0.56623f, 1e-5f);
  // In a highlight of 2 the hidden light is added as it is, to within a fifth.
  const float gleaming = hiddenBase({2.0f, 2.0f, 2.0f}, hidden);
  EXPECT_FLOAT_EQ(gleaming, 8.102f);
  const vec3 glint = hiddenGain({2.2f, 2.2f, 2.2f}, hidden, gleaming);
  EXPECT_NEAR(withHiddenLight({0.4f, 0.4f, 0.4f}, glint, gleaming).x - 0.4f, 0.08253f, 1e-4f);
}

}  // namespace
}  // namespace reprise::eq
