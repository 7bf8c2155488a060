// SPDX-License-Identifier: MIT
#include "lab/scene/mesh/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "lab/scene/mesh/box.h"
#include "lab/scene/mesh/lathe.h"
#include "lab/scene/mesh/loft.h"
#include "lab/scene/mesh/utah_teapot.h"

namespace reprise::lab {
namespace {

constexpr double kPi = std::numbers::pi;

using Place = std::tuple<float, float, float>;

Place placeOf(const Mesh& mesh, uint32_t index) {
  const glm::vec3 p = mesh.position(index) + 0.0f;
  return {p.x, p.y, p.z};
}

// Every edge between two places is walked once each way.
void expectClosed(const Mesh& mesh) {
  std::map<std::pair<Place, Place>, int> walked;
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    for (size_t i = 0; i < 3; ++i) {
      ++walked[{placeOf(mesh, mesh.indices[k + i]), placeOf(mesh, mesh.indices[k + (i + 1) % 3])}];
    }
  }
  ASSERT_FALSE(walked.empty());
  int wrong = 0;
  for (const auto& [edge, count] : walked) {
    const auto back = walked.find({edge.second, edge.first});
    wrong += count == 1 && back != walked.end() && back->second == 1 ? 0 : 1;
  }
  EXPECT_EQ(wrong, 0);
}

// By the divergence theorem; positive where faces look outwards.
double volumeOf(const Mesh& mesh) {
  double six = 0.0;
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    const glm::dvec3 a(mesh.position(mesh.indices[k]));
    const glm::dvec3 b(mesh.position(mesh.indices[k + 1]));
    const glm::dvec3 c(mesh.position(mesh.indices[k + 2]));
    six += glm::dot(a, glm::cross(b, c));
  }
  return six / 6.0;
}

double areaOf(const Mesh& mesh) {
  double twice = 0.0;
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    const glm::dvec3 a(mesh.position(mesh.indices[k]));
    const glm::dvec3 b(mesh.position(mesh.indices[k + 1]));
    const glm::dvec3 c(mesh.position(mesh.indices[k + 2]));
    twice += glm::length(glm::cross(b - a, c - a));
  }
  return twice / 2.0;
}

// Unit, and on the outer side of every face they belong to.
void expectGoodNormals(const Mesh& mesh) {
  for (const GpuVertex& vertex : mesh.vertices) {
    ASSERT_NEAR(glm::length(glm::vec3(vertex.normal_v)), 1.0f, 1e-4f);
  }
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    const glm::vec3 a = mesh.position(mesh.indices[k]);
    const glm::vec3 face =
        glm::cross(mesh.position(mesh.indices[k + 1]) - a, mesh.position(mesh.indices[k + 2]) - a);
    for (size_t i = 0; i < 3; ++i) {
      ASSERT_GT(glm::dot(face, glm::vec3(mesh.vertices[mesh.indices[k + i]].normal_v)), 0.0f);
    }
  }
}

void expectSolid(const Mesh& mesh, double volume, double area, double tolerance) {
  expectClosed(mesh);
  expectGoodNormals(mesh);
  EXPECT_NEAR(volumeOf(mesh), volume, tolerance * volume);
  EXPECT_NEAR(areaOf(mesh), area, tolerance * area);
}

TEST(Mesh, Sphere) {
  const Mesh mesh = sphereMesh(0.7f, 64);
  expectSolid(mesh, 4.0 / 3.0 * kPi * 0.343, 4.0 * kPi * 0.49, 0.01);
  for (const GpuVertex& vertex : mesh.vertices) {
    EXPECT_GT(glm::dot(glm::vec3(vertex.normal_v), glm::vec3(vertex.position_u) / 0.7f), 0.999f);
  }
}

TEST(Mesh, Ellipsoid) {
  // Area by Thomsen's formula, p = 1.6075, within 1.1 %.
  const double p = 1.6075;
  const double a = std::pow(0.3, p);
  const double b = std::pow(0.5, p);
  const double c = std::pow(0.8, p);
  expectSolid(ellipsoidMesh({0.3f, 0.5f, 0.8f}, 64), 4.0 / 3.0 * kPi * 0.12,
              4.0 * kPi * std::pow((a * b + a * c + b * c) / 3.0, 1.0 / p), 0.02);
}

TEST(Mesh, Torus) {
  expectSolid(torusMesh(1.0f, 0.3f, 96, 48), 2.0 * kPi * kPi * 0.09, 4.0 * kPi * kPi * 0.3, 0.01);
}

TEST(Mesh, FrustumKeepsItsEdges) {
  const Mesh mesh = frustumMesh(0.5f, 0.5f, 2.0f, 64);
  expectSolid(mesh, kPi * 0.25 * 2.0, 2.0 * kPi * 0.25 + kPi * 2.0, 0.01);
  for (const GpuVertex& vertex : mesh.vertices) {
    EXPECT_TRUE(std::abs(vertex.normal_v.y) < 0.01f || std::abs(vertex.normal_v.y) > 0.99f);
  }
}

TEST(Mesh, Box) {
  const Mesh mesh = boxMesh({1.0f, 2.0f, 3.0f}, 4);
  expectSolid(mesh, 6.0, 22.0, 1e-5);
  EXPECT_EQ(mesh.triangleCount(), 6u * 4 * 4 * 2);
  for (const GpuVertex& vertex : mesh.vertices) {
    const glm::vec3 n = glm::abs(glm::vec3(vertex.normal_v));
    EXPECT_NEAR(std::max({n.x, n.y, n.z}), 1.0f, 1e-5f);
  }
}

TEST(Mesh, ReliefStaysClosed) {
  const Mesh mesh = boxMesh({1.0f, 1.0f, 1.0f}, 16, [](uint32_t, glm::vec2 p) {
    return 0.05f * (0.25f - p.x * p.x) * (0.25f - p.y * p.y) * 16.0f;
  });
  expectClosed(mesh);
  expectGoodNormals(mesh);
  // 16 times the integral of (1/4 - x^2) is 16 / 36 a face.
  EXPECT_NEAR(volumeOf(mesh), 1.0 + 6.0 * 0.05 * 16.0 / 36.0, 0.002);
}

TEST(Mesh, LoftIsACapsule) {
  const std::vector<Section> sections = {{{0.0f, 0.0f, 0.0f}, 0.5f, 0.5f},
                                         {{2.0f, 0.0f, 0.0f}, 0.5f, 0.5f}};
  const Mesh mesh =
      loft(sections, {.around = 96, .rows_a_span = 4, .cap_rows = 24, .cap_length = 1.0f});
  expectSolid(mesh, kPi * 0.25 * 2.0 + 4.0 / 3.0 * kPi * 0.125, kPi * 2.0 + 4.0 * kPi * 0.25, 0.01);
}

TEST(Mesh, LoftBendsAndSwells) {
  const std::vector<Section> sections = {{{0.0f, 0.0f, 0.0f}, 0.3f, 0.1f},
                                         {{1.0f, 0.2f, 0.0f}, 0.2f, 0.3f},
                                         {{1.5f, 1.0f, 0.0f}, 0.1f, 0.1f}};
  const Mesh mesh = loft(sections);
  expectClosed(mesh);
  expectGoodNormals(mesh);
  // Sections are met: the widest place lies on the second one's ellipse.
  float widest = 0.0f;
  for (const GpuVertex& vertex : mesh.vertices) widest = std::max(widest, vertex.position_u.z);
  EXPECT_NEAR(widest, 0.3f, 0.01f);
}

TEST(Mesh, UtahTeapot) {
  EXPECT_EQ(utahTeapotPatches().size(), 32u);
  const Mesh mesh = utahTeapotMesh(16, 1.0f);
  expectGoodNormals(mesh);
  glm::vec3 low(1e9f);
  glm::vec3 high(-1e9f);
  for (const GpuVertex& vertex : mesh.vertices) {
    low = glm::min(low, glm::vec3(vertex.position_u));
    high = glm::max(high, glm::vec3(vertex.position_u));
  }
  // Newell's pot with its bottom: 3.15 high, 4 wide, handle at -3, spout to about 3.43.
  EXPECT_NEAR(high.y - low.y, 3.15f, 1e-3f);
  EXPECT_NEAR(high.z, 2.0f, 0.02f);
  EXPECT_NEAR(low.x, -2.99f, 0.02f);
  EXPECT_NEAR(high.x, 3.43f, 0.03f);
  // Open are only the rim's inside and the lid's edge (64 edges each), and both ends of the handle
  // and of the spout (32 each): everywhere else patches join.
  std::map<std::pair<Place, Place>, int> walked;
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    for (size_t i = 0; i < 3; ++i) {
      ++walked[{placeOf(mesh, mesh.indices[k + i]), placeOf(mesh, mesh.indices[k + (i + 1) % 3])}];
    }
  }
  int open = 0;
  for (const auto& [edge, count] : walked) {
    EXPECT_EQ(count, 1);
    open += walked.count({edge.second, edge.first}) == 0 ? 1 : 0;
  }
  EXPECT_EQ(open, 2 * 64 + 4 * 32);
}

TEST(Mesh, MirroringKeepsTheOutsideOut) {
  const glm::mat4 mirror = glm::scale(glm::mat4(1.0f), glm::vec3(-2.0f, 2.0f, 2.0f));
  const Mesh mesh = transformed(boxMesh({1.0f, 1.0f, 1.0f}, 2), mirror);
  expectSolid(mesh, 8.0, 24.0, 1e-5);
}

TEST(Mesh, WeldClosesGaps) {
  Mesh mesh = boxMesh({1.0f, 1.0f, 1.0f}, 3);
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    mesh.vertices[i].position_u.x += 1e-6f * static_cast<float>(i % 5);
  }
  weld(mesh, 1e-4f);
  expectClosed(mesh);
  EXPECT_EQ(mesh.triangleCount(), 6u * 3 * 3 * 2);
}

TEST(Mesh, InstancesKeepTheirOwnIndices) {
  Geometry geometry;
  const Mesh box = boxMesh({1.0f, 1.0f, 1.0f}, 1);
  EXPECT_EQ(addInstance(geometry, box, 0), 0u);
  EXPECT_EQ(addInstance(geometry, box, 2), 1u);
  EXPECT_EQ(geometry.instances[1].first_index, box.indices.size());
  EXPECT_EQ(geometry.instances[1].material, 2u);
  EXPECT_EQ(geometry.indices[box.indices.size()], box.indices[0] + box.vertices.size());
}

}  // namespace
}  // namespace reprise::lab
