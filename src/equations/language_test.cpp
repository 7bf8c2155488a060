// SPDX-License-Identifier: MIT
// The C++ side of the common subset means what GLSL means.
#include "equations/language.h"

#include <gtest/gtest.h>

namespace reprise::eq {
namespace {

// Both languages must lay shared structs out alike.
static_assert(sizeof(vec2) == 8 && sizeof(vec4) == 16 && sizeof(mat4) == 64);
static_assert(sizeof(uvec2) == 8 && sizeof(ivec2) == 8);

TEST(Language, VectorsAreComponentWise) {
  const vec3 a(1.0f, -2.0f, 4.0f), b(2.0f, 4.0f, -8.0f);
  const vec3 quotient = a / b;
  EXPECT_EQ(quotient.x, 0.5f);
  EXPECT_EQ(quotient.y, -0.5f);
  EXPECT_EQ(quotient.z, -0.5f);
  EXPECT_EQ((2.0f - a).y, 4.0f);
  EXPECT_EQ((a * 3.0f).z, 12.0f);
  EXPECT_EQ((-a).y, 2.0f);
  vec3 c = a;
  c += b;
  c *= 2.0f;
  EXPECT_EQ(c.x, 6.0f);
  EXPECT_EQ(dot(a, b), -38.0f);
  EXPECT_EQ(length(vec2(3.0f, 4.0f)), 5.0f);
  EXPECT_EQ(min(a, b).z, -8.0f);
  EXPECT_EQ(mix(a, b, 0.25f).x, 1.25f);
  EXPECT_EQ(clamp(a, vec3(0.0f), vec3(1.0f)).y, 0.0f);
  EXPECT_EQ(clamp(a, vec3(0.0f), vec3(1.0f)).z, 1.0f);
}

TEST(Language, MatricesAreColumnMajor) {
  mat4 m(1.0f);
  m[3] = vec4(5.0f, 6.0f, 7.0f, 1.0f);
  EXPECT_EQ((m * vec4(1.0f, 1.0f, 1.0f, 1.0f)).y, 7.0f);
  EXPECT_EQ((m * vec4(1.0f, 1.0f, 1.0f, 0.0f)).y, 1.0f);
  const mat4 square = m * m;
  EXPECT_EQ(square[3].x, 10.0f);
  EXPECT_EQ(square[0].x, 1.0f);
}

TEST(Language, Builtins) {
  EXPECT_EQ(fract(-0.25f), 0.75f);
  EXPECT_EQ(sign(-3.0f), -1.0f);
  EXPECT_EQ(sign(0.0f), 0.0f);
  EXPECT_EQ(floor(vec2(-0.5f, 1.5f)).x, -1.0f);
  EXPECT_EQ(bitfieldReverse(1u), 0x80000000u);
  EXPECT_EQ(floatBitsToUint(1.0f), 0x3f800000u);
  EXPECT_EQ(uintBitsToFloat(0x40000000u), 2.0f);
}

}  // namespace
}  // namespace reprise::eq
