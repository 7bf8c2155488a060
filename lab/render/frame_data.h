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

// Kinds of material; each has its shading in lab/scene/shading, and its line in shading_list.glsl.
LAB_CONST kMaterialChart = 0u;
LAB_CONST kMaterialBrick = 1u;
LAB_CONST kMaterialWood = 2u;
LAB_CONST kMaterialMarble = 3u;
LAB_CONST kMaterialCells = 4u;
LAB_CONST kMaterialGlazed = 5u;
LAB_CONST kMaterialStone = 6u;
LAB_CONST kMaterialRust = 7u;
LAB_CONST kMaterialFiguredWood = 8u;
LAB_CONST kMaterialVeinedMarble = 9u;
LAB_CONST kMaterialTextured = 16u;
LAB_CONST kMaterialLeaf = 17u;
LAB_CONST kMaterialHangar = 18u;

LAB_CONST kMaxLights = 8u;
LAB_CONST kLightPoint = 0u;
LAB_CONST kLightCone = 1u;
LAB_CONST kLightSun = 2u;
LAB_CONST kLightGobo = 3u;  // a cone behind a mask that turns

LAB_CONST kMaxCoarseSize = 4u;  // REPRISE_MAX_COARSE_SIZE

// Layers of light: what a pass shows of the scene's light is a mask of these.
LAB_CONST kLightLayerMain = 1u;      // all that techniques may amortize, and the ambient light
LAB_CONST kLightLayerDeferred = 2u;  // shaded in every frame and added after the resolve
LAB_CONST kAllLightLayers = 3u;

// Textures lie in arrays by size class (textures.glsl), at most as many as this.
LAB_CONST kMaxTextureClasses = 8u;

// Bindings of passes that shade: 0 to 7 are the scene (scene_buffers.glsl, shade_triangle.glsl),
// then the sun's shadow map, the textures' sampler and arrays, lamps; a pass's own begin after
// them.
LAB_CONST kShadowMapBinding = 8u;
LAB_CONST kShadeSamplerBinding = 9u;
LAB_CONST kLampsBinding = 18u;  // and what tiles see of them (lamps.glsl)
LAB_CONST kLampTilesBinding = 19u;
LAB_CONST kFirstPassBinding = 20u;

// Local lights, many and small: a tile of the screen has a mask of those that may reach what it
// sees, a bit each (Forward+; light_tiles.comp).
LAB_CONST kMaxLamps = 512u;
LAB_CONST kLampWords = 16u;  // kMaxLamps / 32
LAB_CONST kLightTile_px = 16u;

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

// Textures: 0 is none. Scenes give the number that addImage returned; on the GPU it is a class and
// a layer (Textures::reference).
struct GpuMaterial {
  vec4 parameters;  // meaning by kind
  vec4 emission;    // rgb: linear light given off; w: meaning by kind
  uint kind;
  uint color_texture;     // rgb: base colour, a: coverage
  uint normal_texture;    // tangent space, xyz * 2 - 1
  uint surface_texture;   // r: share of ambient light, g: roughness, b: metalness
  uint emission_texture;  // rgb: factor of `emission`
  float alpha_cutoff;     // above 0: holes where the colour texture's alpha is below it
  float normal_scale;     // of the normal texture's x and y
  uint padding;
};

// How a vertex follows the wind, a function of time and wind alone (sway.glsl). All zero: stiff.
struct GpuSway {
  vec4
      pivot_angle;  // xyz: a point of the axis it turns about, instance's space; w: amplitude (rad)
  vec4 axis_phase;  // xyz: unit direction of that axis; w: phase of the turn (rad)
  vec4 push;        // m along the wind in a wind of 1: x: steady lean, y: swing; z: its phase (rad)
};

struct GpuLight {
  vec4 position_world;   // xyz (m); not of a sun. Of a gobo, w: cosine of the mask's turn
  vec4 color;            // rgb: radiant intensity over pi, so that a white wall 1 m away shows it;
                         // of a sun: what a white wall that faces it shows. Of a gobo, w: sine
  vec4 direction_world;  // xyz: unit, the way the light goes (cone, sun); w: 1: casts a shadow
  vec2 cone_cosines;     // of the half angles: full light inside the first, none outside the second
  uint kind;
  uint layer;
};

// A local light. Its light falls with the square of distance and is 0 from its range on.
struct GpuLamp {
  vec4 position_range;   // xyz: world (m), w: range (m)
  vec4 color_inner;      // rgb: as GpuLight's; w: cosine of the half angle of full light
  vec4 direction_outer;  // xyz: unit, the way a cone goes; w: cosine of the half angle beyond which
                         // there is none; below -1: a point light
};

// One frame. Element a of the arrays is a frames back; transforms of instances lie in a buffer of
// their own, [a * instance_count + instance].
struct GpuFrame {
  mat4 view_projection[9];  // to Vulkan clip space, reversed infinite depth, no jitter
  mat4 shadow_from_world;   // to the shadow map's clip space: depth grows along the light, no w
  vec4 wind[9];             // xyz: direction and strength in the world, w: time (s)
  vec4 eye_world;           // xyz
  vec4 ambient;             // rgb: what a white surface shows without any light
  GpuLight lights[8];       // kMaxLights
  vec2 extent_px;
  uint instance_count;
  float mip_bias;
  float time_s;
  uint light_count;
  uint shadow_light;  // the sun that has the shadow map; kMaxLights: none
  float shadow_bias;  // in the map's depth
};

// Push constants of the passes.
struct VisibilityConstants {
  vec2 jitter_px;
  uint instance;
  uint material;
};

struct ShadeConstants {
  vec2 jitter_px;
  uint unjitter;   // 1: shade at the pixel centre, wherever visibility was sampled
  uint offset_on;  // 1: add equation shadingOffset
  float offset_sigma_px;
  uint offset_seed;
  uint offset_quadrant;
  uint light_layers;  // mask of kLightLayer...
};

// Of shading below the pixels' rate (coarse.comp, checkerboard.comp).
struct CoarseConstants {
  vec2 jitter_px;
  uint origin_x_px;  // below the coarse pixels' size
  uint origin_y_px;
  uint checkerboard;  // 1: pixels whose x + y is even; 2: odd
  uint light_layers;
  uint shade_covered;  // 1: amid the pixels that the triangle covers, 0: at the coarse centre
};

// Of shading by fragments (shade.vert, shade.frag). The image may lie beside the frame by less than
// a fragment, since fragments begin at multiples of their size.
struct RasterConstants {
  VisibilityConstants draw;  // as visibility drew it: all that the vertex shader sees of these
  ShadeConstants shade;
  uint shift_x_px;  // from the frame to the image
  uint shift_y_px;
  uint shade_covered;  // as CoarseConstants has it
  uint padding;
};

struct LateConstants {
  vec2 jitter_px;
  uint positions;  // 1 or 4
};

struct ServeConstants {
  uint light_layers;
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

struct LightTilesConstants {
  vec2 jitter_px;
  float near_plane;  // view depth is near_plane / depth
  uint cull;         // 0: every lamp in every tile
};

struct FinishConstants {
  float scale;  // 1 / samples
};

#ifdef __cplusplus
static_assert(sizeof(GpuVertex) == 32);
static_assert(sizeof(GpuMaterial) == 64);
static_assert(sizeof(GpuSway) == 48);
static_assert(sizeof(GpuLight) == 64);
static_assert(sizeof(GpuFrame) == 10 * 64 + 9 * 16 + 32 + kMaxLights * sizeof(GpuLight) + 32);
static_assert(sizeof(GpuLamp) == 48);
static_assert(kMaxLamps == 32 * kLampWords);
static_assert(kLampsBinding == kShadeSamplerBinding + 1 + kMaxTextureClasses);
static_assert(kFirstPassBinding == kLampTilesBinding + 1);
}  // namespace reprise::lab
#endif

#endif
