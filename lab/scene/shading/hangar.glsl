// SPDX-License-Identifier: MIT
// Metal of the hangar: steel, a floor of plates, and a ship's hull that mirrors the hall's lamps.
// parameters: paint rgb; w: 0 steel, 1 floor, 2 hull.
#ifndef REPRISE_LAB_HANGAR_GLSL
#define REPRISE_LAB_HANGAR_GLSL

#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/noise.glsl"
#include "lab/scene/shading/surface_point.glsl"

// The hall as mirrors see it (hangar.cpp builds the same): rows of lamps under the roof.
const float kLampHeight_m = 11.2;
const float kLampSpacing_m = 5.0;
const float kLampHalfWidth_m = 0.12;
const float kLampHalfLength_m = 1.6;
const vec3 kLampColor = vec3(26.0, 24.0, 20.0);
const vec3 kHallColor = vec3(0.05, 0.06, 0.08);

// What a ray from inside the hall sees: lamps where it meets their plane, else sky above the roof
// and dusk below.
vec3 hallLight(vec3 from_world, vec3 towards_world) {
  vec3 sky = mix(kHallColor, vec3(0.30, 0.40, 0.55), smoothstep(0.1, 0.9, towards_world.y));
  if (towards_world.y < 0.02) return kHallColor * (1.0 + towards_world.y * 0.6);
  float t = (kLampHeight_m - from_world.y) / towards_world.y;
  vec2 at = from_world.xz + towards_world.xz * t;
  vec2 cell = abs(at - kLampSpacing_m * round(at / kLampSpacing_m));
  bool lamp = cell.x < kLampHalfWidth_m && cell.y < kLampHalfLength_m && abs(at.x) < 13.0 &&
              abs(at.y) < 28.0;
  // The roof's trusses stand dark against the sky.
  float truss = abs(at.y - 5.0 * round(at.y / 5.0));
  if (truss > 2.3) sky *= 0.35;
  return lamp ? kLampColor : sky;
}

// Distance (m) to the nearest line of a grid of plates; every second row is shifted.
float plateLine_m(vec2 at_m, vec2 plate_m) {
  float row = floor(at_m.y / plate_m.y);
  at_m.x += fract(row * 0.5) * plate_m.x;
  vec2 within = at_m - plate_m * floor(at_m / plate_m);
  vec2 nearest = min(within, plate_m - within);
  return min(nearest.x, nearest.y);
}

float plateTone(vec2 at_m, vec2 plate_m, uint seed) {
  float row = floor(at_m.y / plate_m.y);
  float column = floor((at_m.x + fract(row * 0.5) * plate_m.x) / plate_m.x);
  return latticeValue(ivec2(column, row), seed);
}

vec3 mirrored(SurfacePoint s, vec3 normal, float f0) {
  float grazing = 1.0 - clamp(dot(normal, s.to_eye_world), 0.0, 1.0);
  float fresnel = f0 + (1.0 - f0) * pow(grazing, 5.0);
  if ((shown_light_layers & kLightLayerMain) == 0u) return vec3(0.0);
  return fresnel * hallLight(s.position_world, reflect(-s.to_eye_world, normal));
}

vec3 shadeFloor(SurfacePoint s) {
  const vec2 kPlate_m = vec2(2.0, 1.0);
  vec2 at_m = s.position_world.xz;
  vec3 albedo = s.parameters.rgb * (0.75 + 0.5 * plateTone(at_m, kPlate_m, 31u));
  albedo *= 0.85 + 0.3 * valueNoise(at_m * 1.7, 33u);
  // Warning stripes along the bay, 12 cm wide.
  float bay = abs(abs(at_m.x) - 6.5);
  if (bay < 0.18)
    albedo = fract((at_m.x + at_m.y) / 0.24) < 0.5 ? vec3(0.55, 0.40, 0.03) : vec3(0.03);
  if (plateLine_m(at_m, kPlate_m) < 0.008) albedo *= 0.15;
  vec3 color = litSurface(s, Appearance(s.normal_world, albedo, 1.0, 0.03, 60.0, vec3(0.0)));
  return color + 0.5 * mirrored(s, s.normal_world, 0.03);
}

// uv: metres along the hull, turns around it.
vec3 shadeHull(SurfacePoint s) {
  const vec2 kPanel_m = vec2(1.3, 0.62);
  vec2 at_m = vec2(s.uv.x, s.uv.y * 9.0);
  float tone = plateTone(at_m, kPanel_m, 41u);
  vec3 albedo = s.parameters.rgb * (0.55 + 0.45 * tone);
  // Plates are not quite flat with their neighbours, so that reflections break at their edges.
  uint bits = uint(tone * 65535.0);
  vec3 tilt = (vec3(bits & 31u, (bits >> 5) & 31u, (bits >> 10) & 31u) / 31.0 - 0.5) * 0.03;
  vec3 normal = normalize(s.normal_world + tilt);
  float line_m = plateLine_m(at_m, kPanel_m);
  if (line_m < 0.006) return albedo * 0.1 * (ambientLight() + 0.05);
  // Rivets 4 cm inside the edges, 9 cm apart.
  float rivet = length(vec2(line_m - 0.04, fract((at_m.x + at_m.y) / 0.09) * 0.09 - 0.045));
  if (rivet < 0.010) albedo *= 0.45;
  float stripe = step(abs(s.uv.y - 0.25), 0.018);
  albedo = mix(albedo, vec3(0.45, 0.05, 0.03), stripe);
  vec3 color = litSurface(s, Appearance(normal, albedo, 1.0, 0.12, 300.0, vec3(0.0)));
  return color + mirrored(s, normal, 0.25);
}

vec3 shadeHangar(SurfacePoint s) {
  if (s.parameters.w > 1.5) return shadeHull(s);
  if (s.parameters.w > 0.5) return shadeFloor(s);
  vec3 color =
      litSurface(s, Appearance(s.normal_world, s.parameters.rgb, 1.0, 0.08, 70.0, vec3(0.0)));
  return color + 0.5 * mirrored(s, s.normal_world, 0.06);
}

#endif
