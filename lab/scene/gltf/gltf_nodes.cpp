// SPDX-License-Identifier: MIT
#include "lab/scene/gltf/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace reprise::lab {
namespace {

// Numbers of a node's property; `missing` where it has none.
template <size_t N>
std::array<float, N> numbers(const GltfFile& file, const std::vector<double>& from,
                             const std::array<float, N>& missing, const char* what) {
  if (from.empty()) return missing;
  std::array<float, N> to{};
  if (from.size() != N) file.fail(std::string("a node's ") + what + " has the wrong length");
  for (size_t i = 0; i < N; ++i) {
    to[i] = static_cast<float>(from[i]);
    if (!std::isfinite(to[i])) file.fail(std::string("a node's ") + what + " is not finite");
  }
  return to;
}

glm::quat asRotation(glm::vec4 xyzw) {
  const float length = glm::length(xyzw);
  if (!(length > 0.0f)) return {1.0f, 0.0f, 0.0f, 0.0f};
  xyzw /= length;
  return {xyzw.w, xyzw.x, xyzw.y, xyzw.z};
}

}  // namespace

glm::vec4 GltfChannel::at(double time_s) const {
  const double wrapped = duration_s > 0.0 ? std::fmod(time_s, duration_s) : 0.0;
  const auto t = static_cast<float>(wrapped);
  const bool cubic = interpolation == Interpolation::kCubic;
  const auto value = [&](size_t key) { return values[cubic ? 3 * key + 1 : key]; };
  if (t <= times_s.front()) return value(0);
  if (t >= times_s.back()) return value(times_s.size() - 1);
  const auto above = std::upper_bound(times_s.begin(), times_s.end(), t);
  const auto next = static_cast<size_t>(above - times_s.begin());
  const size_t last = next - 1;
  const float span = times_s[next] - times_s[last];
  const float s = span > 0.0f ? (t - times_s[last]) / span : 0.0f;
  if (interpolation == Interpolation::kStep) return value(last);
  if (cubic) {
    const float s2 = s * s;
    const float s3 = s2 * s;
    return (2.0f * s3 - 3.0f * s2 + 1.0f) * value(last) +
           (s3 - 2.0f * s2 + s) * span * values[3 * last + 2] +
           (3.0f * s2 - 2.0f * s3) * value(next) + (s3 - s2) * span * values[3 * next];
  }
  if (path != Path::kRotation) return glm::mix(value(last), value(next), s);
  const glm::quat turned = glm::slerp(asRotation(value(last)), asRotation(value(next)), s);
  return {turned.x, turned.y, turned.z, turned.w};
}

GltfNodes::GltfNodes(GltfFile& file) : nodes_(file.model().nodes.size()) {
  readRest(file);
  readAnimations(file);
  const tinygltf::Model& model = file.model();
  if (model.scenes.empty()) {
    for (size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].parent < 0) show(file, static_cast<int>(i));
    }
  } else {
    const int scene = model.defaultScene >= 0 ? model.defaultScene : 0;
    for (const int root : model.scenes[file.checked(scene, model.scenes.size(), "scene")].nodes) {
      show(file, root);
    }
  }
}

void GltfNodes::readRest(const GltfFile& file) {
  const std::vector<tinygltf::Node>& from = file.model().nodes;
  for (size_t i = 0; i < from.size(); ++i) {
    Node& node = nodes_[i];
    const auto t = numbers<3>(file, from[i].translation, {0.0f, 0.0f, 0.0f}, "translation");
    const auto r = numbers<4>(file, from[i].rotation, {0.0f, 0.0f, 0.0f, 1.0f}, "rotation");
    const auto s = numbers<3>(file, from[i].scale, {1.0f, 1.0f, 1.0f}, "scale");
    node.translation = {t[0], t[1], t[2]};
    node.rotation = asRotation({r[0], r[1], r[2], r[3]});
    node.scale = {s[0], s[1], s[2]};
    node.has_matrix = !from[i].matrix.empty();
    if (node.has_matrix) {
      const auto m = numbers<16>(file, from[i].matrix, {}, "matrix");
      for (int c = 0; c < 4; ++c) {
        for (int k = 0; k < 4; ++k) node.matrix[c][k] = m[static_cast<size_t>(4 * c + k)];
      }
    }
    for (const int child : from[i].children) {
      Node& below = nodes_[file.checked(child, nodes_.size(), "node")];
      if (below.parent >= 0) file.fail("node " + std::to_string(child) + " has two parents");
      below.parent = static_cast<int>(i);
    }
  }
  // Rings have no root: a way up longer than there are nodes.
  for (const Node& node : nodes_) {
    size_t steps = 0;
    for (int up = node.parent; up >= 0; up = nodes_[static_cast<size_t>(up)].parent) {
      if (++steps > nodes_.size()) file.fail("nodes hang on each other in a ring");
    }
  }
}

void GltfNodes::readAnimations(GltfFile& file) {
  for (const tinygltf::Animation& animation : file.model().animations) {
    std::vector<std::pair<size_t, GltfChannel>> channels;
    double duration_s = 0.0;
    for (const tinygltf::AnimationChannel& from : animation.channels) {
      if (from.target_node < 0) continue;
      const size_t node = file.checked(from.target_node, nodes_.size(), "node");
      GltfChannel channel;
      if (from.target_path == "translation") {
        channel.path = GltfChannel::Path::kTranslation;
      } else if (from.target_path == "rotation") {
        channel.path = GltfChannel::Path::kRotation;
      } else if (from.target_path == "scale") {
        channel.path = GltfChannel::Path::kScale;
      } else {
        file.warn("animation of other than translation, rotation and scale is left out");
        continue;
      }
      if (nodes_[node].has_matrix) file.fail("an animated node has a matrix");
      const tinygltf::AnimationSampler& sampler =
          animation
              .samplers[file.checked(from.sampler, animation.samplers.size(), "animation sampler")];
      const bool cubic = sampler.interpolation == "CUBICSPLINE";
      channel.interpolation = cubic ? GltfChannel::Interpolation::kCubic
                              : sampler.interpolation == "STEP"
                                  ? GltfChannel::Interpolation::kStep
                                  : GltfChannel::Interpolation::kLinear;
      channel.times_s = file.floats(sampler.input, 1);
      const int components = channel.path == GltfChannel::Path::kRotation ? 4 : 3;
      const std::vector<float> values = file.floats(sampler.output, components);
      const size_t keys = channel.times_s.size();
      if (keys == 0 || !std::is_sorted(channel.times_s.begin(), channel.times_s.end()) ||
          values.size() != keys * static_cast<size_t>(components) * (cubic ? 3 : 1)) {
        file.fail("an animation's times and values do not fit");
      }
      const auto n = static_cast<size_t>(components);
      for (size_t i = 0; i < values.size(); i += n) {
        channel.values.emplace_back(values[i], values[i + 1], values[i + 2],
                                    n == 4 ? values[i + 3] : 0.0f);
      }
      duration_s = std::max(duration_s, static_cast<double>(channel.times_s.back()));
      channels.emplace_back(node, std::move(channel));
    }
    for (auto& [node, channel] : channels) {
      channel.duration_s = duration_s;
      nodes_[node].channels.push_back(std::move(channel));
    }
  }
}

void GltfNodes::show(const GltfFile& file, int root) {
  std::vector<size_t> open{file.checked(root, nodes_.size(), "node")};
  while (!open.empty()) {
    const size_t i = open.back();
    open.pop_back();
    if (shown_.size() >= nodes_.size()) file.fail("a node is shown twice");
    Node& node = nodes_[i];
    const bool carried = node.parent >= 0 && nodes_[static_cast<size_t>(node.parent)].moves;
    node.moves = carried || !node.channels.empty();
    shown_.push_back(static_cast<uint32_t>(i));
    for (const int child : file.model().nodes[i].children) {
      open.push_back(static_cast<size_t>(child));
    }
  }
}

glm::mat4 GltfNodes::worldFromNode(uint32_t node, double time_s) const {
  glm::mat4 world(1.0f);
  for (int up = static_cast<int>(node); up >= 0; up = nodes_[static_cast<size_t>(up)].parent) {
    const Node& n = nodes_[static_cast<size_t>(up)];
    if (n.has_matrix) {
      world = n.matrix * world;
      continue;
    }
    glm::vec3 translation = n.translation;
    glm::quat rotation = n.rotation;
    glm::vec3 scale = n.scale;
    for (const GltfChannel& channel : n.channels) {
      const glm::vec4 value = channel.at(time_s);
      if (channel.path == GltfChannel::Path::kTranslation) translation = glm::vec3(value);
      if (channel.path == GltfChannel::Path::kRotation) rotation = asRotation(value);
      if (channel.path == GltfChannel::Path::kScale) scale = glm::vec3(value);
    }
    glm::mat4 local = glm::translate(glm::mat4(1.0f), translation) * glm::mat4_cast(rotation);
    for (int c = 0; c < 3; ++c) local[c] *= scale[c];
    world = local * world;
  }
  return world;
}

}  // namespace reprise::lab
