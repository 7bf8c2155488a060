// SPDX-License-Identifier: MIT
// Cells about random points, in three dimensions, with exact gradients.
#ifndef REPRISE_LAB_VORONOI_GLSL
#define REPRISE_LAB_VORONOI_GLSL

#include "equations/hash.h"

struct VoronoiCell {
  uint hash;   // of the nearest point
  float edge;  // second distance less the first: 0 on borders
  vec3 edge_gradient;
};

// One point a unit cube. The nearest two are looked for in the 27 cubes about p.
VoronoiCell voronoiCell(vec3 p) {
  vec3 base = floor(p);
  vec3 f = p - base;
  float first = 1.0e9;
  float second = 1.0e9;
  vec3 to_first = vec3(0.0);
  vec3 to_second = vec3(0.0);
  uint hash = 0u;
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        uvec3 cube = uvec3(ivec3(base) + ivec3(x, y, z));
        uint h = hashPcg(cube.x * 1597334677u ^ cube.y * 3812015801u ^ cube.z * 2246822519u);
        vec3 point = vec3(h & 1023u, (h >> 10) & 1023u, (h >> 20) & 1023u) / 1023.0;
        vec3 way = vec3(x, y, z) + point - f;
        float d = dot(way, way);
        bool nearest = d < first;
        bool next = d < second;
        second = nearest ? first : (next ? d : second);
        to_second = nearest ? to_first : (next ? way : to_second);
        first = nearest ? d : first;
        to_first = nearest ? way : to_first;
        hash = nearest ? h : hash;
      }
    }
  }
  float near = sqrt(max(first, 1.0e-8));
  float far = sqrt(max(second, 1.0e-8));
  return VoronoiCell(hash, far - near, to_first / near - to_second / far);
}

#endif
