// SPDX-License-Identifier: MIT
// Textured surfaces, metallic-roughness as glTF 2.0 defines it. parameters: base colour rgb,
// roughness; emission.w: metalness; textures of GpuMaterial are their factors. Normal textures
// point with green towards falling v, as glTF's do.
#ifndef REPRISE_LAB_TEXTURED_GLSL
#define REPRISE_LAB_TEXTURED_GLSL

#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/surface_point.glsl"

// Declared by lab/render/shade_triangle.glsl: materials, sampleTexture.

vec4 textureAt(SurfacePoint s, uint name) {
  float scale = exp2(s.mip_bias);
  return sampleTexture(name, s.uv, s.uv_dx * scale, s.uv_dy * scale);
}

// Tangent and bitangent are the gradients of u and v on the surface, from the derivatives of
// position and uv a pixel: no tangents are stored.
vec3 texturedNormal(SurfacePoint s, uint name, float normal_scale) {
  if (name == 0u) return s.normal_world;
  vec3 tangent_normal = textureAt(s, name).xyz * 2.0 - 1.0;
  tangent_normal.xy *= normal_scale;
  vec3 across_y = cross(s.position_dy_world, s.normal_world);
  vec3 across_x = cross(s.normal_world, s.position_dx_world);
  vec3 u_axis = across_y * s.uv_dx.x + across_x * s.uv_dy.x;
  vec3 v_axis = across_y * s.uv_dx.y + across_x * s.uv_dy.y;
  float largest = max(dot(u_axis, u_axis), dot(v_axis, v_axis));
  if (!(largest > 0.0)) return s.normal_world;
  float handed = sign(dot(s.position_dx_world, across_y)) * inversesqrt(largest);
  vec3 normal = handed * (u_axis * tangent_normal.x - v_axis * tangent_normal.y) +
                s.normal_world * max(tangent_normal.z, 0.05);
  return normalize(normal);
}

// glTF 2.0, appendix B: Trowbridge-Reitz distribution, Smith visibility (height-correlated),
// Schlick's Fresnel; all over pi, as light colours are.
vec3 microfacets(vec3 normal, vec3 to_eye, vec3 to_light, vec3 diffuse, vec3 f0, float alpha) {
  vec3 halfway = normalize(to_light + to_eye);
  float nl = max(dot(normal, to_light), 0.0);
  float nv = max(abs(dot(normal, to_eye)), 1.0e-3);
  float nh = max(dot(normal, halfway), 0.0);
  float hv = clamp(dot(halfway, to_eye), 0.0, 1.0);
  float a2 = alpha * alpha;
  float d = nh * nh * (a2 - 1.0) + 1.0;
  float distribution = a2 / max(d * d, 1.0e-7);
  float visibility =
      0.5 /
      max(nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2), 1.0e-4);
  vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - hv, 5.0);
  return nl * (diffuse * (1.0 - fresnel) + fresnel * distribution * visibility);
}

vec3 shadeTextured(SurfacePoint s) {
  GpuMaterial material = materials[s.material];
  vec3 base = s.parameters.rgb * textureAt(s, material.color_texture).rgb;
  vec4 surface = textureAt(s, material.surface_texture);
  float roughness = clamp(s.parameters.w * surface.g, 0.04, 1.0);
  float metal = material.emission.w * surface.b;
  vec3 normal = texturedNormal(s, material.normal_texture, material.normal_scale);
  vec3 diffuse = base * (1.0 - metal);
  vec3 f0 = mix(vec3(0.04), base, metal);
  // Skylight comes from above more than from below; metals mirror it.
  float open = (0.6 + 0.4 * normal.y) * surface.r;
  vec3 color = ambientLight() * open * (diffuse + f0);
  for (uint i = 0u; i < frame.light_count; ++i) {
    Arriving light = lightAt(i, s.position_world);
    color += light.color * microfacets(normal, s.to_eye_world, light.to_light_world, diffuse, f0,
                                       roughness * roughness);
  }
  for (LampCursor c = beforeLamps(); toLamp(c); passLamp(c)) {
    Arriving light = lampAt(lampOf(c), s.position_world);
    color += light.color * microfacets(normal, s.to_eye_world, light.to_light_world, diffuse, f0,
                                       roughness * roughness);
  }
  if ((shown_light_layers & kLightLayerMain) != 0u) {
    color += material.emission.rgb * textureAt(s, material.emission_texture).rgb;
  }
  return color;
}

#endif
