// SPDX-License-Identifier: MIT
#include "equations/hidden_light.h"

#include <gtest/gtest.h>

namespace reprise::eq {
namespace {

TEST(HiddenLight, OfTheSampleThatTheGainWasMadeOfIsTheSum) {
  for (const float gleam : {0.0f, 0.3f}) {
    const float base = hiddenBase({gleam, 0.5f * gleam, 0.0f});
    const vec3 shown(0.2f, 0.05f, 0.0f);
    const vec3 hidden(0.1f, 0.4f, 0.7f);
    const vec3 whole = withHiddenLight(shown, hiddenGain(shown, hidden, base), base);
    EXPECT_NEAR(whole.x, 0.3f, 1e-6f);
    EXPECT_NEAR(whole.y, 0.45f, 1e-6f);
    EXPECT_NEAR(whole.z, 0.7f, 1e-6f);
  }
}

TEST(HiddenLight, FollowsTheSurfaceAndNotTheGleam) {
  // A sample on a joint half as bright as the surface around: the gain is the surface's.
  const vec3 joint = hiddenGain({0.2f, 0.2f, 0.2f}, {0.1f, 0.1f, 0.1f}, hiddenBase({0, 0, 0}));
  EXPECT_NEAR(withHiddenLight({0.4f, 0.4f, 0.4f}, joint, kLeastShownLight).x, 0.6f, 1e-3f);
  // In a highlight of 2 the hidden 0.1 is added as it is, to within the share 1 / (1 + 4).
  const float base = hiddenBase({2.0f, 2.0f, 2.0f});
  EXPECT_FLOAT_EQ(base, 8.002f);
  const vec3 glint = hiddenGain({2.2f, 2.2f, 2.2f}, {0.1f, 0.1f, 0.1f}, base);
  EXPECT_NEAR(withHiddenLight({0.4f, 0.4f, 0.4f}, glint, base).x - 0.4f, 0.0824f, 1e-4f);
}

}  // namespace
}  // namespace reprise::eq
