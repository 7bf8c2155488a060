// SPDX-License-Identifier: MIT
//
// What the lab's shaders read, in GLSL and C++. GpuFrame is a std140 uniform block: CPU drivers
// load uniform data once for many pixels, storage buffers pixel by pixel. The rest is std430.
#ifndef REPRISE_LAB_FRAME_DATA_H
#define REPRISE_LAB_FRAME_DATA_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace reprise::lab {
using glm::mat4;
using glm::vec2;
using glm::vec4;
using uint = uint32_t;
#define LAB_CONST constexpr uint
#else
#define LAB_CONST const uint
#endif

// How far back motion can be asked for (frames).
LAB_CONST kMaxFramesBack = 8u;

// Kinds of material; each has its shading in lab/scene/shading.
LAB_CONST kMaterialChart = 0u;
LAB_CONST kMaterialBrick = 1u;

// In an instance's space, or, after the transform pass, in world space (m).
struct GpuVertex {
  vec4 position_u;  // xyz, w: u
  vec4 normal_v;    // xyz unit, w: v
};

// One a triangle: corners in the vertex buffer, and the material.
struct GpuTriangle {
  uint vertex_0;
  uint vertex_1;
  uint vertex_2;
  uint material;
};

struct GpuMaterial {
  vec4 parameters;  // meaning by kind
  uint kind;
  uint padding_0;
  uint padding_1;
  uint padding_2;
};

struct GpuLight {
  vec4 position_world;  // xyz (m)
  vec4 color;           // rgb: radiant intensity over pi, so that a white wall 1 m away shows it
  vec4 ambient;         // rgb
};

// One frame. Element a of the arrays is a frames back; transforms of instances lie in a buffer of
// their own, [a * instance_count + instance].
struct GpuFrame {
  mat4 view_projection[9];  // to Vulkan clip space, reversed infinite depth, no jitter
  vec4 eye_world;           // xyz
  GpuLight light;
  vec2 extent_px;
  uint instance_count;
  float mip_bias;
};

// Push constants of the passes.
struct VisibilityConstants {
  vec2 jitter_px;
  uint instance;
  uint padding;
};

struct ShadeConstants {
  vec2 jitter_px;
  uint unjitter;   // 1: shade at the pixel centre, wherever visibility was sampled
  uint offset_on;  // 1: add equation shadingOffset
  float offset_sigma_px;
  uint offset_seed;
  uint offset_quadrant;
  uint padding;
};

struct MotionConstants {
  vec2 jitter_px;
  uint frames_back;  // as given to the transform pass
  uint padding;
};

struct TransformConstants {
  uint vertex_count;
  uint row_length;  // vertices a row of the dispatch
  uint frames_back;
  uint padding;
};

struct FinishConstants {
  float scale;  // 1 / samples
};

#ifdef __cplusplus
static_assert(sizeof(GpuVertex) == 32);
static_assert(sizeof(GpuMaterial) == 32);
static_assert(sizeof(GpuFrame) == 9 * 64 + 16 + 48 + 16);
}  // namespace reprise::lab
#endif

#endif
