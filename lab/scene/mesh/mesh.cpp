// SPDX-License-Identifier: MIT
#include "lab/scene/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace reprise::lab {
namespace {

// Places compare by value, so that 0 and -0 are one.
using Place = std::tuple<float, float, float>;

Place placeOf(glm::vec3 p) {
  return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
}

// Number of each vertex's place.
std::vector<uint32_t> placesOf(const Mesh& mesh) {
  std::map<Place, uint32_t> known;
  std::vector<uint32_t> places;
  places.reserve(mesh.vertices.size());
  for (uint32_t i = 0; i < mesh.vertices.size(); ++i) {
    places.push_back(
        known.try_emplace(placeOf(mesh.position(i)), static_cast<uint32_t>(known.size()))
            .first->second);
  }
  return places;
}

struct Corner {
  uint32_t triangle;
  float angle;  // radians
};

float angleBetween(glm::vec3 a, glm::vec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

Mesh gridMesh(uint32_t columns, uint32_t rows,
              const std::function<GridPoint(uint32_t, uint32_t)>& point) {
  Mesh mesh;
  for (uint32_t row = 0; row <= rows; ++row) {
    for (uint32_t column = 0; column <= columns; ++column) {
      const GridPoint p = point(column, row);
      mesh.vertices.push_back({{p.position, p.uv.x}, {0.0f, 0.0f, 0.0f, p.uv.y}});
    }
  }
  const auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) {
    const glm::vec3 pa = mesh.position(a);
    const glm::vec3 pb = mesh.position(b);
    const glm::vec3 pc = mesh.position(c);
    if (pa == pb || pb == pc || pc == pa) return;
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  };
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t column = 0; column < columns; ++column) {
      const uint32_t corner = row * (columns + 1) + column;
      const uint32_t above = corner + columns + 1;
      triangle(corner, corner + 1, above + 1);
      triangle(corner, above + 1, above);
    }
  }
  return mesh;
}

void append(Mesh& mesh, const Mesh& more) {
  const auto base = static_cast<uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  for (const uint32_t index : more.indices) mesh.indices.push_back(base + index);
}

Mesh transformed(Mesh mesh, const glm::mat4& matrix) {
  const glm::mat3 turn(matrix);
  const float scale = std::cbrt(std::abs(glm::determinant(turn)));
  for (GpuVertex& vertex : mesh.vertices) {
    const glm::vec3 position = glm::vec3(matrix * glm::vec4(glm::vec3(vertex.position_u), 1.0f));
    const glm::vec3 normal = turn * glm::vec3(vertex.normal_v) / scale;
    vertex = {{position, vertex.position_u.w}, {normal, vertex.normal_v.w}};
  }
  if (glm::determinant(turn) < 0.0f) {
    for (size_t k = 0; k < mesh.indices.size(); k += 3) {
      std::swap(mesh.indices[k + 1], mesh.indices[k + 2]);
    }
  }
  return mesh;
}

void weld(Mesh& mesh, float tolerance) {
  using Cell = std::array<int64_t, 3>;
  std::map<Cell, std::vector<glm::vec3>> kept;  // cells as wide as the tolerance
  const auto cellOf = [&](glm::vec3 p, int axis, int step) {
    return static_cast<int64_t>(std::floor(p[axis] / tolerance)) + step;
  };
  for (GpuVertex& vertex : mesh.vertices) {
    const glm::vec3 p(vertex.position_u);
    const glm::vec3* near = nullptr;
    for (int k = 0; k < 27 && near == nullptr; ++k) {
      const Cell cell{cellOf(p, 0, k % 3 - 1), cellOf(p, 1, k / 3 % 3 - 1),
                      cellOf(p, 2, k / 9 - 1)};
      const auto found = kept.find(cell);
      if (found == kept.end()) continue;
      for (const glm::vec3& other : found->second) {
        if (glm::distance(other, p) < tolerance) near = &other;
      }
    }
    if (near != nullptr) {
      vertex.position_u = {*near, vertex.position_u.w};
    } else {
      kept[{cellOf(p, 0, 0), cellOf(p, 1, 0), cellOf(p, 2, 0)}].push_back(p);
    }
  }
  std::vector<uint32_t> indices;
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    const uint32_t* c = &mesh.indices[k];
    const glm::vec3 p[3] = {mesh.position(c[0]), mesh.position(c[1]), mesh.position(c[2])};
    if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0]) indices.insert(indices.end(), c, c + 3);
  }
  mesh.indices = std::move(indices);
}

void makeSmooth(Mesh& mesh, float crease) {
  const std::vector<uint32_t> places = placesOf(mesh);
  std::vector<std::vector<Corner>> corners(places.size());  // by place
  std::vector<glm::vec3> faces;                             // unit normal of each triangle
  for (uint32_t k = 0; k < mesh.indices.size(); k += 3) {
    glm::vec3 p[3];
    for (int i = 0; i < 3; ++i) p[i] = mesh.position(mesh.indices[k + i]);
    const glm::vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const float length = glm::length(normal);
    faces.push_back(length > 0.0f ? normal / length : glm::vec3(0.0f));
    for (int i = 0; i < 3; ++i) {
      corners[places[mesh.indices[k + i]]].push_back(
          {k / 3, angleBetween(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i])});
    }
  }
  const float least_cosine = crease >= 3.15f ? -2.0f : std::cos(crease);
  std::vector<GpuVertex> vertices;
  std::map<std::tuple<uint32_t, float, float, float>, uint32_t> known;
  for (uint32_t k = 0; k < mesh.indices.size(); ++k) {
    const uint32_t old = mesh.indices[k];
    const glm::vec3 own = faces[k / 3];
    glm::vec3 sum(0.0f);
    for (const Corner& corner : corners[places[old]]) {
      const glm::vec3 face = faces[corner.triangle];
      if (glm::dot(face, own) >= least_cosine) sum += corner.angle * face;
    }
    const float length = glm::length(sum);
    const glm::vec3 normal = length > 1.0e-6f ? sum / length : own;
    const auto [entry, fresh] = known.try_emplace({old, normal.x, normal.y, normal.z},
                                                  static_cast<uint32_t>(vertices.size()));
    if (fresh) {
      const GpuVertex& vertex = mesh.vertices[old];
      vertices.push_back({vertex.position_u, {normal, vertex.normal_v.w}});
    }
    mesh.indices[k] = entry->second;
  }
  mesh.vertices = std::move(vertices);
}

uint32_t addInstance(Geometry& geometry, const Mesh& mesh, uint32_t material) {
  const auto base = static_cast<uint32_t>(geometry.vertices.size());
  const auto first_index = static_cast<uint32_t>(geometry.indices.size());
  geometry.vertices.insert(geometry.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (const uint32_t index : mesh.indices) geometry.indices.push_back(base + index);
  geometry.instances.push_back({first_index, static_cast<uint32_t>(mesh.indices.size()), material});
  return static_cast<uint32_t>(geometry.instances.size()) - 1;
}

}  // namespace reprise::lab
