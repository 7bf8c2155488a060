// SPDX-License-Identifier: MIT
//
// What lets one text be GLSL 450 and C++20. In GLSL: three macros. In C++: the few vector types and
// builtins that the equations use, with GLSL's meaning, in namespace reprise::eq.
//
// Rules for text in the common subset: arguments and results by value; components by .x .y .z .w
// only; `f` on float literals and `u` on unsigned ones; conversions written out (float(i),
// uint(x)); no bool, vec3 or array in a struct that both languages lay out; no % or / on negative
// integers.
#ifndef REPRISE_EQUATIONS_LANGUAGE_H
#define REPRISE_EQUATIONS_LANGUAGE_H

#ifdef __cplusplus

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#define EQ_FN inline
#define EQ_CONST inline constexpr
// Brackets a header's declarations; nothing in GLSL, which has no namespaces.
#define EQ_BEGIN namespace reprise::eq {
#define EQ_END }

namespace reprise::eq {

using uint = std::uint32_t;

struct vec2 {
  float x = 0.0f, y = 0.0f;
  constexpr vec2() = default;
  explicit constexpr vec2(float s) : x(s), y(s) {}
  constexpr vec2(float a, float b) : x(a), y(b) {}
  static constexpr int kSize = 2;
  constexpr float& operator[](int i) { return i == 0 ? x : y; }
  constexpr float operator[](int i) const { return i == 0 ? x : y; }
};

struct vec3 {
  float x = 0.0f, y = 0.0f, z = 0.0f;
  constexpr vec3() = default;
  explicit constexpr vec3(float s) : x(s), y(s), z(s) {}
  constexpr vec3(float a, float b, float c) : x(a), y(b), z(c) {}
  static constexpr int kSize = 3;
  constexpr float& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr float operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};

struct vec4 {
  float x = 0.0f, y = 0.0f, z = 0.0f, w = 0.0f;
  constexpr vec4() = default;
  explicit constexpr vec4(float s) : x(s), y(s), z(s), w(s) {}
  constexpr vec4(float a, float b, float c, float d) : x(a), y(b), z(c), w(d) {}
  static constexpr int kSize = 4;
  constexpr float& operator[](int i) { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
  constexpr float operator[](int i) const { return i == 0 ? x : i == 1 ? y : i == 2 ? z : w; }
};

struct uvec2 {
  uint x = 0u, y = 0u;
  constexpr uvec2() = default;
  constexpr uvec2(uint a, uint b) : x(a), y(b) {}
  constexpr bool operator==(const uvec2&) const = default;
};

struct ivec2 {
  int x = 0, y = 0;
  constexpr ivec2() = default;
  constexpr ivec2(int a, int b) : x(a), y(b) {}
  constexpr bool operator==(const ivec2&) const = default;
};

template <typename V>
concept Vector = requires {
  V::kSize;
};

// The component-wise image of one, two or three vectors.
template <Vector V, typename F>
constexpr V mapped(V a, F f) {
  V r;
  for (int i = 0; i < V::kSize; ++i) r[i] = f(a[i]);
  return r;
}
template <Vector V, typename F>
constexpr V mapped(V a, V b, F f) {
  V r;
  for (int i = 0; i < V::kSize; ++i) r[i] = f(a[i], b[i]);
  return r;
}

template <Vector V>
constexpr V operator-(V a) {
  return mapped(a, [](float x) { return -x; });
}
#define EQ_VECTOR_OPERATOR(op)                                    \
  template <Vector V>                                             \
  constexpr V operator op(V a, V b) {                             \
    return mapped(a, b, [](float x, float y) { return x op y; }); \
  }                                                               \
  template <Vector V>                                             \
  constexpr V operator op(V a, float s) {                         \
    return a op V(s);                                             \
  }                                                               \
  template <Vector V>                                             \
  constexpr V operator op(float s, V a) {                         \
    return V(s) op a;                                             \
  }                                                               \
  template <Vector V, typename T>                                 \
  constexpr V& operator op##=(V& a, T b) {                        \
    return a = a op b;                                            \
  }
EQ_VECTOR_OPERATOR(+)
EQ_VECTOR_OPERATOR(-)
EQ_VECTOR_OPERATOR(*)
EQ_VECTOR_OPERATOR(/)
#undef EQ_VECTOR_OPERATOR

// Column-major, as in GLSL: m[column][row].
struct mat4 {
  vec4 columns[4];
  constexpr mat4() = default;
  // `s` on the diagonal.
  explicit constexpr mat4(float s)
      : columns{vec4(s, 0.0f, 0.0f, 0.0f), vec4(0.0f, s, 0.0f, 0.0f), vec4(0.0f, 0.0f, s, 0.0f),
                vec4(0.0f, 0.0f, 0.0f, s)} {}
  constexpr mat4(vec4 a, vec4 b, vec4 c, vec4 d) : columns{a, b, c, d} {}
  constexpr vec4& operator[](int i) { return columns[i]; }
  constexpr const vec4& operator[](int i) const { return columns[i]; }
};

constexpr vec4 operator*(const mat4& m, vec4 v) {
  return m[0] * v.x + m[1] * v.y + m[2] * v.z + m[3] * v.w;
}
constexpr mat4 operator*(const mat4& a, const mat4& b) {
  return mat4(a * b[0], a * b[1], a * b[2], a * b[3]);
}

// GLSL's builtins. min and max return the first argument where neither is smaller (larger).
constexpr float min(float a, float b) {
  return b < a ? b : a;
}
constexpr float max(float a, float b) {
  return a < b ? b : a;
}
constexpr uint min(uint a, uint b) {
  return b < a ? b : a;
}
constexpr uint max(uint a, uint b) {
  return a < b ? b : a;
}
constexpr float clamp(float x, float low, float high) {
  return min(max(x, low), high);
}
constexpr float mix(float a, float b, float t) {
  return a * (1.0f - t) + b * t;
}
constexpr float sign(float x) {
  return x > 0.0f ? 1.0f : x < 0.0f ? -1.0f : 0.0f;
}
inline float abs(float x) {
  return std::fabs(x);
}
inline float floor(float x) {
  return std::floor(x);
}
inline float fract(float x) {
  return x - std::floor(x);
}
inline float sqrt(float x) {
  return std::sqrt(x);
}
inline float exp(float x) {
  return std::exp(x);
}
inline float exp2(float x) {
  return std::exp2(x);
}
inline float log(float x) {
  return std::log(x);
}
inline float log2(float x) {
  return std::log2(x);
}
inline float pow(float x, float y) {
  return std::pow(x, y);
}
inline float sin(float x) {
  return std::sin(x);
}
inline float cos(float x) {
  return std::cos(x);
}
inline uint floatBitsToUint(float x) {
  return std::bit_cast<uint>(x);
}
inline float uintBitsToFloat(uint x) {
  return std::bit_cast<float>(x);
}

constexpr uint bitfieldReverse(uint x) {
  uint reversed = 0u;
  for (int i = 0; i < 32; ++i) reversed |= ((x >> i) & 1u) << (31 - i);
  return reversed;
}

#define EQ_COMPONENT_WISE(name)                        \
  template <Vector V>                                  \
  inline V name(V a) {                                 \
    return mapped(a, [](float x) { return name(x); }); \
  }
EQ_COMPONENT_WISE(abs)
EQ_COMPONENT_WISE(floor)
EQ_COMPONENT_WISE(fract)
EQ_COMPONENT_WISE(sqrt)
EQ_COMPONENT_WISE(exp)
EQ_COMPONENT_WISE(exp2)
EQ_COMPONENT_WISE(log)
EQ_COMPONENT_WISE(log2)
EQ_COMPONENT_WISE(sign)
#undef EQ_COMPONENT_WISE

template <Vector V>
constexpr V min(V a, V b) {
  return mapped(a, b, [](float x, float y) { return min(x, y); });
}
template <Vector V>
constexpr V max(V a, V b) {
  return mapped(a, b, [](float x, float y) { return max(x, y); });
}
template <Vector V>
constexpr V clamp(V x, V low, V high) {
  return min(max(x, low), high);
}
template <Vector V>
constexpr V mix(V a, V b, float t) {
  return a * (1.0f - t) + b * t;
}
template <Vector V>
inline V pow(V a, V b) {
  return mapped(a, b, [](float x, float y) { return pow(x, y); });
}
template <Vector V>
constexpr float dot(V a, V b) {
  float sum = 0.0f;
  for (int i = 0; i < V::kSize; ++i) sum += a[i] * b[i];
  return sum;
}
template <Vector V>
inline float length(V a) {
  return sqrt(dot(a, a));
}

}  // namespace reprise::eq

#else

#define EQ_FN
#define EQ_CONST const
#define EQ_BEGIN
#define EQ_END

#endif

#endif
