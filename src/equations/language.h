// SPDX-License-Identifier: MIT
//
// The common subset of GLSL and C++ in which every equation of the project is written once.
// Rules: arguments and results by value; no swizzles, .x .y .z .w only; `f` on float literals; no vec3
// and no bool in structs that both sides share; loops and % on uint.
#ifndef REPRISE_EQUATIONS_LANGUAGE_H
#define REPRISE_EQUATIONS_LANGUAGE_H

#ifndef __cplusplus

#define EQ_FN
#define EQ_CONST const

#else

#define EQ_FN inline
#define EQ_CONST constexpr

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace reprise::eq {

using uint = uint32_t;

struct vec2 {
  float x = 0.0f, y = 0.0f;
  constexpr vec2() = default;
  constexpr explicit vec2(float s) : x(s), y(s) {}
  constexpr vec2(float x_, float y_) : x(x_), y(y_) {}
};

struct vec3 {
  float x = 0.0f, y = 0.0f, z = 0.0f;
  constexpr vec3() = default;
  constexpr explicit vec3(float s) : x(s), y(s), z(s) {}
  constexpr vec3(float x_, float y_, float z_) : x(x_), y(y_), z(z_) {}
};

struct vec4 {
  float x = 0.0f, y = 0.0f, z = 0.0f, w = 0.0f;
  constexpr vec4() = default;
  constexpr explicit vec4(float s) : x(s), y(s), z(s), w(s) {}
  constexpr vec4(float x_, float y_, float z_, float w_) : x(x_), y(y_), z(z_), w(w_) {}
};

#define REPRISE_VECTOR_OPERATORS(op)                                                            \
  constexpr vec2 operator op(vec2 a, vec2 b) { return vec2(a.x op b.x, a.y op b.y); }            \
  constexpr vec3 operator op(vec3 a, vec3 b) {                                                  \
    return vec3(a.x op b.x, a.y op b.y, a.z op b.z);                                            \
  }                                                                                             \
  constexpr vec4 operator op(vec4 a, vec4 b) {                                                  \
    return vec4(a.x op b.x, a.y op b.y, a.z op b.z, a.w op b.w);                                \
  }                                                                                             \
  constexpr vec2 operator op(vec2 a, float s) { return a op vec2(s); }                           \
  constexpr vec3 operator op(vec3 a, float s) { return a op vec3(s); }                           \
  constexpr vec4 operator op(vec4 a, float s) { return a op vec4(s); }                           \
  constexpr vec2 operator op(float s, vec2 a) { return vec2(s) op a; }                           \
  constexpr vec3 operator op(float s, vec3 a) { return vec3(s) op a; }                           \
  constexpr vec4 operator op(float s, vec4 a) { return vec4(s) op a; }
REPRISE_VECTOR_OPERATORS(+)
REPRISE_VECTOR_OPERATORS(-)
REPRISE_VECTOR_OPERATORS(*)
REPRISE_VECTOR_OPERATORS(/)
#undef REPRISE_VECTOR_OPERATORS

constexpr vec3 operator-(vec3 a) { return vec3(-a.x, -a.y, -a.z); }

inline float min(float a, float b) { return b < a ? b : a; }
inline float max(float a, float b) { return a < b ? b : a; }
inline vec3 min(vec3 a, vec3 b) { return vec3(min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)); }
inline vec3 max(vec3 a, vec3 b) { return vec3(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)); }
inline float abs(float a) { return std::fabs(a); }
inline vec3 abs(vec3 a) { return vec3(abs(a.x), abs(a.y), abs(a.z)); }
inline float clamp(float v, float lo, float hi) { return min(max(v, lo), hi); }
inline vec3 clamp(vec3 v, vec3 lo, vec3 hi) { return min(max(v, lo), hi); }
inline float mix(float a, float b, float t) { return a * (1.0f - t) + b * t; }
inline vec3 mix(vec3 a, vec3 b, float t) { return a * (1.0f - t) + b * t; }
inline float dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float dot(vec4 a, vec4 b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
inline float length(vec2 a) { return std::sqrt(dot(a, a)); }
inline float floor(float a) { return std::floor(a); }
inline float fract(float a) { return a - std::floor(a); }
inline float exp(float a) { return std::exp(a); }
inline float log(float a) { return std::log(a); }
inline float exp2(float a) { return std::exp2(a); }
inline float log2(float a) { return std::log2(a); }
inline float pow(float a, float b) { return std::pow(a, b); }
inline float sqrt(float a) { return std::sqrt(a); }
inline float sin(float a) { return std::sin(a); }
inline float cos(float a) { return std::cos(a); }

}  // namespace reprise::eq

#endif

#ifdef __cplusplus
#define EQ_BEGIN namespace reprise::eq {
#define EQ_END }
#else
#define EQ_BEGIN
#define EQ_END
#endif

#endif
