// SPDX-License-Identifier: MIT
#include "lab/scene/gltf/gltf_meshes.h"

#include <algorithm>
#include <map>
#include <optional>

#include "lab/scene/gltf/gltf_materials.h"

namespace reprise::lab {
namespace {

// Vertices of a whole scene. World positions are read as texels, two a vertex, and devices must
// offer no more than 2^27 (lavapipe's limit); memory ends before.
constexpr size_t kMostVertices = size_t{1} << 25;

struct Mesh {
  std::vector<GpuVertex> vertices;
  std::vector<uint32_t> indices;
};

std::vector<uint32_t> triangleList(std::vector<uint32_t> corners, int mode) {
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    corners.resize(corners.size() / 3 * 3);
    return corners;
  }
  std::vector<uint32_t> list;
  for (size_t i = 2; i < corners.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
      list.insert(list.end(), {corners[i - 1], corners[i], corners[0]});
    } else {
      // glTF 2.0, 3.7.2.1: p_i = {v_i, v_(i + 1 + i % 2), v_(i + 2 - i % 2)}.
      const size_t first = i - 2;
      list.insert(list.end(),
                  {corners[first], corners[first + 1 + first % 2], corners[first + 2 - first % 2]});
    }
  }
  return list;
}

// A corner of each triangle for itself, with the triangle's normal: what glTF asks for where a
// file has no normals.
Mesh flat(const Mesh& smooth) {
  Mesh mesh;
  for (size_t i = 0; i + 2 < smooth.indices.size(); i += 3) {
    GpuVertex corners[3];
    for (size_t k = 0; k < 3; ++k) corners[k] = smooth.vertices[smooth.indices[i + k]];
    const glm::vec3 p0(corners[0].position_u);
    const glm::vec3 normal =
        glm::cross(glm::vec3(corners[1].position_u) - p0, glm::vec3(corners[2].position_u) - p0);
    const float length = glm::length(normal);
    const glm::vec3 unit = length > 0.0f ? normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
    for (GpuVertex& corner : corners) {
      corner.normal_v = glm::vec4(unit, corner.normal_v.w);
      mesh.indices.push_back(static_cast<uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(corner);
    }
  }
  return mesh;
}

glm::vec3 unitOr(glm::vec3 v, glm::vec3 otherwise) {
  const float length = glm::length(v);
  return length > 0.0f && length < 1.0e30f ? v / length : otherwise;
}

class MeshBuilder {
 public:
  MeshBuilder(GltfFile& file, Geometry& geometry)
      : file_(file), geometry_(geometry), materials_(file, geometry) {}

  void place(uint32_t node, int mesh, const GltfNodes& nodes) {
    const tinygltf::Model& model = file_.model();
    const size_t number = file_.checked(mesh, model.meshes.size(), "mesh");
    if (!model.meshes[number].weights.empty()) file_.warn("morph targets are left out");
    if (model.nodes[node].skin >= 0) file_.warn("skins are left out: meshes stay in bind pose");
    for (size_t p = 0; p < model.meshes[number].primitives.size(); ++p) {
      const tinygltf::Primitive& primitive = model.meshes[number].primitives[p];
      const GltfMaterial material = materials_.material(primitive.material);
      if (material.invisible) continue;
      const Mesh* from = read(number, p, primitive, material);
      if (from == nullptr) continue;
      vertices_ += from->vertices.size();
      if (vertices_ > kMostVertices) file_.fail("more vertices than this lab renders");
      if (nodes.moves(node)) {
        movers_.push_back({node, material.number, *from});
      } else {
        bake(*from, nodes.worldFromNode(node, 0.0), still_[material.number]);
      }
    }
  }

  void finish(std::vector<int>& movers) {
    for (const auto& [material, mesh] : still_) {
      append(mesh, material);
      movers.push_back(-1);
    }
    for (const Mover& mover : movers_) {
      append(mover.mesh, mover.material);
      movers.push_back(static_cast<int>(mover.node));
    }
    if (geometry_.indices.empty()) file_.fail("holds no triangles that can be shown");
  }

 private:
  struct Mover {
    uint32_t node;
    uint32_t material;
    Mesh mesh;
  };

  // The primitive in its mesh's space; null where it has no triangles.
  const Mesh* read(size_t mesh, size_t number, const tinygltf::Primitive& primitive,
                   const GltfMaterial& material) {
    std::optional<Mesh>& kept = read_[{mesh, number}];
    if (!kept) kept = build(primitive, material);
    return kept->indices.empty() ? nullptr : &*kept;
  }

  Mesh build(const tinygltf::Primitive& primitive, const GltfMaterial& material) {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode < TINYGLTF_MODE_TRIANGLES || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
      file_.warn("points and lines are left out");
      return {};
    }
    const auto accessor = [&](const std::string& name) {
      const auto found = primitive.attributes.find(name);
      return found == primitive.attributes.end() ? -1 : found->second;
    };
    if (accessor("POSITION") < 0) {
      file_.warn("a primitive without positions is left out");
      return {};
    }
    if (accessor("COLOR_0") >= 0) file_.warn("colours of vertices are left out");
    if (!primitive.targets.empty()) file_.warn("morph targets are left out");
    const std::vector<float> positions = file_.floats(accessor("POSITION"), 3);
    const size_t count = positions.size() / 3;
    Mesh mesh;
    mesh.vertices.resize(count);
    const auto attribute = [&](const std::string& name, int components) {
      std::vector<float> values;
      if (accessor(name) < 0) return values;
      values = file_.floats(accessor(name), components);
      if (values.size() != count * static_cast<size_t>(components)) {
        file_.fail(name + " of a mesh has not as many elements as POSITION");
      }
      return values;
    };
    const std::vector<float> normals = attribute("NORMAL", 3);
    const std::vector<float> uvs = attribute("TEXCOORD_" + std::to_string(material.mapping.set), 2);
    bool beyond = false;
    for (size_t i = 0; i < count; ++i) {
      glm::vec2 uv(0.0f);
      if (!uvs.empty()) uv = material.mapping.apply({uvs[2 * i], uvs[2 * i + 1]});
      glm::vec3 normal(0.0f, 1.0f, 0.0f);
      if (!normals.empty()) {
        normal = unitOr({normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]}, normal);
      }
      constexpr float kRounding = 1.0e-3f;
      beyond = beyond || std::min(uv.x, uv.y) < -kRounding || std::max(uv.x, uv.y) > 1 + kRounding;
      mesh.vertices[i] = {
          glm::vec4(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], uv.x),
          glm::vec4(normal, uv.y)};
    }
    if (beyond && !material.repeats) {
      file_.warn("textures that clamp or mirror repeat instead");
    }
    mesh.indices = triangleList(corners(primitive, count), mode);
    return normals.empty() ? flat(mesh) : mesh;
  }

  std::vector<uint32_t> corners(const tinygltf::Primitive& primitive, size_t count) const {
    std::vector<uint32_t> all;
    if (primitive.indices < 0) {
      all.resize(count);
      for (size_t i = 0; i < count; ++i) all[i] = static_cast<uint32_t>(i);
      return all;
    }
    all = file_.indices(primitive.indices);
    for (const uint32_t corner : all) {
      if (corner >= count) file_.fail("a mesh's index goes beyond its vertices");
    }
    return all;
  }

  static void bake(const Mesh& from, const glm::mat4& world, Mesh& to) {
    const auto base = static_cast<uint32_t>(to.vertices.size());
    const glm::mat3 linear(world);
    // Cofactors: normals under any scale (transform.comp has the same).
    const glm::mat3 turn(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                         glm::cross(linear[0], linear[1]));
    for (const GpuVertex& v : from.vertices) {
      const glm::vec3 normal(v.normal_v);
      to.vertices.push_back(
          {glm::vec4(glm::vec3(world * glm::vec4(glm::vec3(v.position_u), 1.0f)), v.position_u.w),
           glm::vec4(unitOr(turn * normal, normal), v.normal_v.w)});
    }
    for (const uint32_t index : from.indices) to.indices.push_back(base + index);
  }

  void append(const Mesh& mesh, uint32_t material) {
    const auto base = static_cast<uint32_t>(geometry_.vertices.size());
    const auto first = static_cast<uint32_t>(geometry_.indices.size());
    geometry_.vertices.insert(geometry_.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const uint32_t index : mesh.indices) geometry_.indices.push_back(base + index);
    geometry_.instances.push_back({first, static_cast<uint32_t>(mesh.indices.size()), material});
  }

  GltfFile& file_;
  Geometry& geometry_;
  GltfMaterials materials_;
  std::map<std::pair<size_t, size_t>, std::optional<Mesh>> read_;
  std::map<uint32_t, Mesh> still_;  // by material
  std::vector<Mover> movers_;
  size_t vertices_ = 0;
};

}  // namespace

void appendMeshes(GltfFile& file, const GltfNodes& nodes, Geometry& geometry,
                  std::vector<int>& movers) {
  MeshBuilder builder(file, geometry);
  for (const uint32_t node : nodes.shown()) {
    const int mesh = file.model().nodes[node].mesh;
    if (mesh >= 0) builder.place(node, mesh, nodes);
  }
  builder.finish(movers);
  for (const GpuVertex& vertex : geometry.vertices) {
    const glm::vec2 uv(vertex.position_u.w, vertex.normal_v.w);
    // Squares of distances must stay finite.
    if (!(glm::length(glm::vec3(vertex.position_u)) < 1.0e15f) || !(glm::length(uv) < 1.0e15f)) {
      file.fail("a vertex lies farther away than can be rendered");
    }
  }
}

}  // namespace reprise::lab
