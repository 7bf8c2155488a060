// SPDX-License-Identifier: MIT
//
// The nodes of a glTF file: who hangs on whom, and where each is at a time. All animations play at
// once, each over and over.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "lab/scene/gltf/gltf_file.h"

namespace reprise::lab {

// One animated property of a node (glTF 2.0, 3.11 and appendix C).
struct GltfChannel {
  enum class Path { kTranslation, kRotation, kScale };
  enum class Interpolation { kStep, kLinear, kCubic };
  Path path = Path::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  double duration_s = 0.0;  // of the whole animation
  std::vector<float> times_s;
  std::vector<glm::vec4> values;  // a time each; of kCubic: tangent in, value, tangent out

  glm::vec4 at(double time_s) const;
};

class GltfNodes {
 public:
  // Throws SceneFileError where nodes do not form trees.
  explicit GltfNodes(GltfFile& file);

  // Nodes of the scene that the file shows, parents before children.
  const std::vector<uint32_t>& shown() const { return shown_; }
  // Whether the node, or one that it hangs on, moves.
  bool moves(uint32_t node) const { return nodes_[node].moves; }
  glm::mat4 worldFromNode(uint32_t node, double time_s) const;

 private:
  struct Node {
    int parent = -1;
    bool moves = false;
    bool has_matrix = false;
    glm::mat4 matrix{1.0f};
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};
    std::vector<GltfChannel> channels;
  };
  void readRest(const GltfFile& file);
  void readAnimations(GltfFile& file);
  void show(const GltfFile& file, int root);

  std::vector<Node> nodes_;
  std::vector<uint32_t> shown_;
};

}  // namespace reprise::lab
