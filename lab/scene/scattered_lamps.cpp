// SPDX-License-Identifier: MIT
#include "lab/scene/scattered_lamps.h"

#include <algorithm>
#include <cmath>

#include "equations/hash.h"

namespace reprise::lab {
namespace {

// Of half the scene's diagonal: in Sponza 3.7 m, so that of 512 lamps a pixel sees a dozen.
constexpr float kRange = 0.20f;
// From the surface, in ranges.
constexpr float kNearest = 0.08f;
constexpr float kFarthest = 0.5f;
// A white wall at a third of the range shows a sixth of full light.
constexpr float kStrength = 0.018f;
constexpr float kNarrowest = 0.5f;  // half angles of cones (radians)
constexpr float kWidest = 0.9f;
constexpr float kSoftEdge = 0.75f;  // where full light ends, of the half angle

class Placement {
 public:
  explicit Placement(const Scene& scene) {
    const Geometry& geometry = scene.geometry();
    glm::vec3 low(1.0e30f);
    glm::vec3 high(-1.0e30f);
    for (uint32_t i = 0; i < geometry.instances.size(); ++i) {
      const Instance& instance = geometry.instances[i];
      const glm::mat4 world = scene.transform(i, 0.0);
      for (uint32_t k = 0; k + 2 < instance.index_count; k += 3) {
        Face face;
        for (uint32_t c = 0; c < 3; ++c) {
          const uint32_t vertex = geometry.indices[instance.first_index + k + c];
          const glm::vec3 p(geometry.vertices[vertex].position_u);
          face.corners[c] = glm::vec3(world * glm::vec4(p, 1.0f));
          low = glm::min(low, face.corners[c]);
          high = glm::max(high, face.corners[c]);
        }
        const double area = glm::length(face.cross());
        if (!(area > 0.0)) continue;
        whole_ += area;
        faces_.push_back(face);
        areas_up_to_.push_back(whole_);
      }
    }
    radius_m_ = faces_.empty() ? 0.0f : 0.5f * glm::length(high - low);
  }

  bool empty() const { return faces_.empty(); }
  float radius_m() const { return radius_m_; }

  struct Place {
    glm::vec3 position, normal;
  };
  Place at(float which, float u, float v) const {
    const auto found = std::lower_bound(areas_up_to_.begin(), areas_up_to_.end(),
                                        whole_ * static_cast<double>(which));
    const auto last = static_cast<std::ptrdiff_t>(faces_.size()) - 1;
    const Face& face = faces_[static_cast<size_t>(std::min(found - areas_up_to_.begin(), last))];
    const float root = std::sqrt(u);
    return {(1.0f - root) * face.corners[0] + root * (1.0f - v) * face.corners[1] +
                root * v * face.corners[2],
            glm::normalize(face.cross())};
  }

 private:
  struct Face {
    glm::vec3 corners[3];
    glm::vec3 cross() const { return glm::cross(corners[1] - corners[0], corners[2] - corners[0]); }
  };
  std::vector<Face> faces_;
  std::vector<double> areas_up_to_;
  double whole_ = 0.0;
  float radius_m_ = 0.0f;
};

}  // namespace

std::vector<GpuLamp> scatteredLamps(const Scene& scene, uint32_t count, float reach) {
  std::vector<GpuLamp> lamps;
  if (count == 0) return lamps;
  const Placement placement(scene);
  if (placement.empty()) return lamps;
  const float range_m = kRange * placement.radius_m();
  for (uint32_t i = 0; i < std::min(count, kMaxLamps); ++i) {
    const auto drawn = [&](uint32_t k) { return eq::unitFloat(eq::hashPixel(i, k, 271u)); };
    const Placement::Place place = placement.at(drawn(0), drawn(1), drawn(2));
    const float away = range_m * (kNearest + (kFarthest - kNearest) * drawn(3));
    const glm::vec3 position = place.position + away * place.normal;
    // Warm to cold, none saturated.
    const float hue = 6.2831853f * drawn(4);
    const glm::vec3 tint(1.0f + 0.45f * std::cos(hue), 1.0f + 0.45f * std::cos(hue - 2.0943951f),
                         1.0f + 0.45f * std::cos(hue + 2.0943951f));
    const glm::vec3 color = kStrength * range_m * range_m * tint;
    if (i % 2 == 0) {
      lamps.push_back({{position, reach * range_m}, {color, -1.5f}, {0.0f, -1.0f, 0.0f, -2.0f}});
      continue;
    }
    const glm::vec3 aside(drawn(5) - 0.5f, drawn(6) - 0.5f, drawn(7) - 0.5f);
    const float half_angle = kNarrowest + (kWidest - kNarrowest) * drawn(8);
    lamps.push_back({{position, reach * range_m},
                     {2.0f * color, std::cos(kSoftEdge * half_angle)},
                     {glm::normalize(0.8f * aside - place.normal), std::cos(half_angle)}});
  }
  return lamps;
}

}  // namespace reprise::lab
