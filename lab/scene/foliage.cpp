// SPDX-License-Identifier: MIT
//
// A clearing in the wind: thousands of alpha-tested leaves, twigs thinner than a pixel, grass,
// textured ground, a sun with shadows. After the open world of Iglesias-Guitian et al. 2016. The
// plants are in plants/, their shading in shading/leaf.glsl and shading/textured.glsl.
#include <algorithm>
#include <cmath>
#include <vector>

#include "lab/scene/plants/backdrop.h"
#include "lab/scene/plants/plant.h"
#include "lab/scene/plants/plant_images.h"
#include "lab/scene/scene.h"

namespace reprise::lab {
namespace {

constexpr float kAlphaCutoff = 0.5f;
constexpr float kGroundHalf_m = 40.0f;
constexpr uint32_t kGroundCells = 80;
constexpr float kSoilSide_m = 2.5f;  // of the picture
constexpr float kEye_m = 1.6f;
constexpr double kStillAt_s = 0.35;
const glm::vec3 kWindDirection = glm::normalize(glm::vec3(1.0f, 0.0f, 0.35f));
const glm::vec3 kSunTowards(-0.55f, -0.80f, 0.45f);

float groundHeight(float x, float z) {
  return 0.22f * std::sin(0.31f * x + 0.5f) * std::cos(0.27f * z) +
         0.07f * std::sin(0.9f * x - 0.7f * z);
}

glm::vec3 onGround(float x, float z) {
  return {x, groundHeight(x, z), z};
}

// Middle of the path that the walker follows.
float pathX(float z) {
  return 0.9f * std::sin(0.35f * z);
}

// Neighbours on the ground become neighbours in the mesh, so that what is out of sight can be left
// out by runs of triangles.
std::vector<glm::vec2> inRows(std::vector<glm::vec2> feet) {
  constexpr float kRow_m = 2.0f;
  std::sort(feet.begin(), feet.end(), [](glm::vec2 a, glm::vec2 b) {
    const float row_a = std::floor(a.y / kRow_m);
    const float row_b = std::floor(b.y / kRow_m);
    return row_a != row_b ? row_a < row_b : a.x < b.x;
  });
  return feet;
}

class Foliage final : public Scene {
 public:
  Foliage() {
    Geometry& g = geometry_;
    const auto material = [&](uint32_t kind, glm::vec4 parameters, uint32_t color, uint32_t normal,
                              float cutoff) {
      g.materials.push_back({.parameters = parameters,
                             .kind = kind,
                             .color_texture = color,
                             .normal_texture = normal,
                             .alpha_cutoff = cutoff,
                             .normal_scale = 1.0f});
      return static_cast<uint32_t>(g.materials.size() - 1);
    };
    const glm::vec4 through_leaf(1.1f, 1.25f, 0.45f, 0.6f);
    ground_ = material(kMaterialTextured, {1.0f, 1.0f, 1.0f, 0.95f}, addImage(g, soilImage()),
                       addImage(g, soilNormalImage()), 0.0f);
    bark_ = material(kMaterialTextured, {1.0f, 1.0f, 1.0f, 0.9f}, addImage(g, barkImage()),
                     addImage(g, barkNormalImage()), 0.0f);
    leaf_ = material(kMaterialLeaf, through_leaf, addImage(g, leafImage(kAlphaCutoff)), 0,
                     kAlphaCutoff);
    tuft_ = material(kMaterialLeaf, through_leaf, addImage(g, grassImage(kAlphaCutoff)), 0,
                     kAlphaCutoff);
    blade_ = material(kMaterialLeaf, through_leaf, addImage(g, bladeImage()), 0, 0.0f);
    addGround();
    addTrees();
    addGrass();
    addDistance();
  }

  const Geometry& geometry() const override { return geometry_; }
  glm::mat4 transform(uint32_t, double) const override { return glm::mat4(1.0f); }

  CameraPose camera(std::string_view name, const CameraValues& values, double time_s,
                    uint32_t) const override {
    const auto t = static_cast<float>(name == "still" ? kStillAt_s : values.at("from") + time_s);
    // Walks at 1.5 m/s, faster and slower by a half; steps twice a second; looks around.
    const float z = 6.0f - 1.5f * t + 0.45f * std::sin(1.7f * t);
    const float x = pathX(z) + 0.03f * std::sin(6.28f * t);
    const float y = groundHeight(x, z) + kEye_m + 0.035f * std::abs(std::sin(6.28f * t));
    const float yaw = 0.30f * std::sin(1.9f * t + 0.4f) + 0.06f * std::sin(4.7f * t);
    const float pitch = 0.02f + 0.07f * std::sin(1.3f * t + 1.0f);
    CameraPose pose;
    pose.eye_world = {x, y, z};
    pose.target_world = pose.eye_world + glm::vec3(std::sin(yaw) * std::cos(pitch), std::sin(pitch),
                                                   -std::cos(yaw) * std::cos(pitch));
    pose.up_world = {0.02f * std::sin(3.1f * t), 1.0f, 0.0f};
    pose.vertical_fov = 0.95f;
    return pose;
  }

  SceneLights lights(double) const override {
    return {.lights = {sunLight(kSunTowards, {2.9f, 2.55f, 2.0f}, true)},
            .ambient = {0.32f, 0.40f, 0.50f},
            .shadow_radius_m = 14.0f};
  }

  // A breeze with gusts; its strength stays above 0.
  glm::vec3 wind_world(double time_s) const override {
    const double strength = 0.9 + 0.45 * std::sin(0.8 * time_s) + 0.25 * std::sin(2.3 * time_s + 1);
    return kWindDirection * static_cast<float>(strength);
  }

 private:
  void addGround() {
    Mesh ground = gridMesh(kGroundCells, kGroundCells, [](uint32_t column, uint32_t row) {
      const float side = 2.0f * kGroundHalf_m / kGroundCells;
      const float x = -kGroundHalf_m + side * static_cast<float>(column);
      const float z = kGroundHalf_m - side * static_cast<float>(row);
      return GridPoint{onGround(x, z), glm::vec2(x, -z) / kSoilSide_m};
    });
    makeSmooth(ground, kNoCrease);
    addInstance(geometry_, ground, ground_);
  }

  void addTrees() {
    Dice dice(2016);
    SwayingMesh wood;
    SwayingMesh leaves;
    const auto plantBy = [&](Dice& by, float x, float z, const TreeShape& shape) {
      const Tree tree = growTree(onGround(x, z), shape, by);
      for (auto [to, from] : {std::pair{&wood, &tree.wood}, {&leaves, &tree.leaves}}) {
        append(to->mesh, from->mesh);
        to->sways.insert(to->sways.end(), from->sways.begin(), from->sways.end());
      }
    };
    const auto plant = [&](float x, float z, const TreeShape& shape) {
      plantBy(dice, x, z, shape);
    };
    for (const glm::vec2 at : {glm::vec2(-2.6f, 1.2f),
                               {2.9f, -0.4f},
                               {-3.3f, -4.6f},
                               {3.6f, -6.2f},
                               {-1.9f, -9.5f},
                               {5.6f, -11.0f},
                               {-6.8f, -9.0f}}) {
      TreeShape shape{};
      shape.height_m *= dice.between(0.8f, 1.25f);
      plant(at.x, at.y, shape);
    }
    // Bushes: all limbs, hardly a trunk.
    for (int i = 0; i < 26; ++i) {
      const float z = 2.6f - 0.62f * static_cast<float>(i);
      const float side = i % 2 == 0 ? 1.0f : -1.0f;
      plant(pathX(z) + side * dice.between(1.3f, 3.4f), z,
            {.height_m = dice.between(0.9f, 1.9f),
             .trunk_radius_m = 0.025f,
             .limbs = 9,
             .twigs_a_limb = 5,
             .leaves_a_twig = 16,
             .leaf_m = 0.08f});
    }
    // The wood's edge: fewer and larger leaves.
    for (int i = 0; i < 26; ++i) {
      const float turn = -1.1f + 2.2f * static_cast<float>(i) / 25.0f;
      const float distance = dice.between(15.0f, 27.0f);
      plant(distance * std::sin(turn), 4.0f - distance * std::cos(turn),
            {.height_m = dice.between(4.5f, 8.0f),
             .limbs = 10,
             .twigs_a_limb = 3,
             .leaves_a_twig = 15,
             .leaf_m = 0.28f});
    }
    // To the right, where the path bends towards.
    Dice right(2017);
    for (int i = 0; i < 12; ++i) {
      const float x = right.between(8.0f, 20.0f);
      plantBy(right, x, right.between(-22.0f, 0.0f),
              {.height_m = right.between(3.5f, 7.0f),
               .limbs = 10,
               .twigs_a_limb = 3,
               .leaves_a_twig = 15,
               .leaf_m = 0.24f});
    }
    addInstance(geometry_, wood, bark_);
    addInstance(geometry_, leaves, leaf_);
  }

  void addGrass() {
    Dice dice(55);
    SwayingMesh tufts;
    SwayingMesh blades;
    std::vector<glm::vec2> feet;
    for (int i = 0; i < 3400; ++i) {
      const float z = dice.between(-22.0f, 6.5f);
      const float off = dice.between(-9.0f, 9.0f);
      // The path is trodden.
      if (std::abs(off) >= 0.45f + 0.25f * dice.unit()) feet.emplace_back(pathX(z) + off, z);
    }
    // The open ground to the right.
    for (int i = 0; i < 1000; ++i) {
      const float x = dice.between(8.5f, 24.0f);
      feet.emplace_back(x, dice.between(-24.0f, 2.0f));
    }
    for (const glm::vec2 foot : inRows(feet)) {
      appendTuft(tufts, onGround(foot.x, foot.y), dice.between(0.16f, 0.42f),
                 dice.between(0.22f, 0.40f), kWindDirection, dice);
    }
    feet.clear();
    for (int i = 0; i < 2600; ++i) {
      const float z = dice.between(-12.0f, 6.0f);
      const float off = dice.between(-4.0f, 4.0f);
      if (std::abs(off) >= 0.35f) feet.emplace_back(pathX(z) + off, z);
    }
    for (const glm::vec2 foot : inRows(feet)) {
      appendBlade(blades, onGround(foot.x, foot.y), dice.between(0.15f, 0.65f), 0.007f,
                  kWindDirection, dice);
    }
    addInstance(geometry_, blades, blade_);
    addInstance(geometry_, tufts, tuft_);
  }

  void addDistance() {
    Geometry& g = geometry_;
    const auto far = [&](const Mesh& mesh, const GpuMaterial& material) {
      g.materials.push_back(material);
      addInstance(g, mesh, static_cast<uint32_t>(g.materials.size() - 1));
      g.instances.back().casts_shadow = 0;
    };
    // The air before them: the farther, the less colour and the more of the sky's light.
    const auto hazy = [](float share, uint32_t color, float cutoff) {
      return GpuMaterial{.parameters = glm::vec4(glm::vec3(1.0f - share), 1.0f),
                         .emission = glm::vec4(share * glm::vec3(0.30f, 0.36f, 0.42f), 0.0f),
                         .kind = kMaterialTextured,
                         .color_texture = color,
                         .alpha_cutoff = cutoff};
    };
    const uint32_t trees = addImage(g, treeLineImage(kAlphaCutoff));
    far(hillsMesh(37.0f, 170.0f), hazy(0.45f, addImage(g, canopyImage()), 0.0f));
    far(skyMesh(400.0f), {.parameters = {0.0f, 0.0f, 0.0f, 1.0f},
                          .emission = {1.0f, 1.0f, 1.0f, 0.0f},
                          .kind = kMaterialTextured,
                          .emission_texture = addImage(g, skyImage())});
    far(treeLineMesh(36.0f, 7.5f, 32, 0.0f), hazy(0.18f, trees, kAlphaCutoff));
    far(treeLineMesh(58.0f, 11.0f, 44, 0.37f), hazy(0.30f, trees, kAlphaCutoff));
  }

  Geometry geometry_;
  uint32_t ground_ = 0;
  uint32_t bark_ = 0;
  uint32_t leaf_ = 0;
  uint32_t tuft_ = 0;
  uint32_t blade_ = 0;
};

}  // namespace

SceneInfo foliageScene();
SceneInfo foliageScene() {
  return {.name = "foliage",
          .content = "alpha-tested leaves, twigs and grass in wind, textured ground, sun's shadows",
          .cameras = {{"walk",
                       "along a path, in steps, looking around",
                       {{"from", 0.0, "seconds into the path at which it begins"}}},
                      {"still", "does not move, nor does the wind", {}, kStillAt_s}},
          .create = [] { return std::unique_ptr<Scene>(std::make_unique<Foliage>()); }};
}

}  // namespace reprise::lab
