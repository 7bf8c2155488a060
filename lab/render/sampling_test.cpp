// SPDX-License-Identifier: MIT
//
// Samples a pixel, alpha test and sway, on the scenes that have them.
#include <cmath>
#include <cstring>

#include "equations/jitter.h"
#include "lab/render/made_up_scene.h"

namespace reprise::lab {
namespace {

using Sampling = DeviceTest;

std::vector<float> floatsOf(Device& device, const Buffer& buffer) {
  Buffer staging(device, buffer.bytes(), BufferKind::kHost);
  device.submitAndWait([&](VkCommandBuffer commands) {
    fullBarrier(commands);
    const VkBufferCopy copy{0, 0, buffer.bytes()};
    vkCmdCopyBuffer(commands, buffer.handle(), staging.handle(), 1, &copy);
    fullBarrier(commands);
  });
  std::vector<float> floats(buffer.bytes() / sizeof(float));
  std::memcpy(floats.data(), staging.mapped(), buffer.bytes());
  return floats;
}

TEST_F(Sampling, SamplesAreOneTwoOrFour) {
  SceneSourceOptions options = testOptions({8, 8});
  options.switches.samples = 3;
  EXPECT_THROW(SceneSource(device, parseSceneRun("brick/still"), options), std::invalid_argument);
}

TEST_F(Sampling, PastOfSwayingLeavesIsWhereTheyWereDrawn) {
  Renderer renderer(device, parseSceneRun("foliage/walk"), {16, 16}, 60.0);
  const auto transform = [&](uint32_t index, uint32_t frames_back) {
    renderer.setFrame(index, 0.0f);
    device.submitAndWait(
        [&](VkCommandBuffer commands) { renderer.recordTransform(commands, frames_back); });
  };
  for (const uint32_t frames_back : {1u, 3u, kMaxFramesBack}) {
    transform(9, frames_back);
    const std::vector<float> claimed = floatsOf(device, renderer.buffers().previousWorld());
    const std::vector<float> now = floatsOf(device, renderer.buffers().world());
    transform(9 - frames_back, 0);
    const std::vector<float> drawn = floatsOf(device, renderer.buffers().world());
    size_t moved = 0;
    for (size_t v = 0; v < claimed.size() / 4; ++v) {
      for (size_t c = 0; c < 3; ++c) {
        ASSERT_EQ(claimed[4 * v + c], drawn[8 * v + c]) << "vertex " << v;
        moved += now[8 * v + c] != drawn[8 * v + c] ? 1 : 0;
      }
    }
    EXPECT_GT(moved, claimed.size() / 4);  // most vertices are in the wind
  }
}

// A card with a hole in its middle before a wall: the hole shows the wall, its motion is the
// wall's.
MadeUp cardBeforeWall() {
  MadeUp scene;
  SceneImage image{64, 64, ImageRole::kColor, 0.5f, std::vector<uint8_t>(4 * 64 * 64, 255)};
  for (uint32_t y = 16; y < 48; ++y) {
    for (uint32_t x = 16; x < 48; ++x) image.rgba[4 * (64 * y + x) + 3] = 0;
  }
  const GpuMaterial white{.parameters = {1.0f, 1.0f, 1.0f, 1.0f}, .kind = kMaterialTextured};
  scene.geometry.materials = {white, white};
  scene.geometry.materials[1].color_texture = addImage(scene.geometry, image);
  scene.geometry.materials[1].alpha_cutoff = 0.5f;
  addQuad(scene.geometry, {-1.0f, -1.0f, 0.0f}, {2, 0, 0}, {0, 2, 0}, {1, 1}, 1);
  addQuad(scene.geometry, {-9.0f, -9.0f, -2.0f}, {18, 0, 0}, {0, 18, 0}, {1, 1}, 0);
  // The card slides with the wind, the wall does not.
  scene.geometry.sways.assign(4, GpuSway{});
  for (GpuSway& sway : scene.geometry.sways) sway.push = {0.0f, 0.2f, 0.3f, 0.0f};
  scene.wind_world = {1.0f, 0.0f, 0.0f};
  scene.lights.ambient = glm::vec3(1.0f);
  scene.pose = {.eye_world = {0.0f, 0.0f, 1.0f},
                .target_world = {0.0f, 0.0f, 0.0f},
                .vertical_fov = 1.5707963f};
  return scene;
}

// Vulkan's standard positions.
std::vector<eq::vec2> standardOffsets(uint32_t samples) {
  if (samples == 2) return {eq::vec2(0.25f, 0.25f), eq::vec2(-0.25f, -0.25f)};
  return {eq::rotatedGridOffset(0), eq::rotatedGridOffset(1), eq::rotatedGridOffset(2),
          eq::rotatedGridOffset(3)};
}

TEST_F(Sampling, SeveralSamplesAreTheMeanOfAsManyRenders) {
  for (const uint32_t samples : {2u, 4u})
    for (const SceneRun& run : {madeUpRun<cardBeforeWall>(), parseSceneRun("brick/pan")}) {
      SceneSourceOptions options = testOptions({48, 32});
      SceneSource one(device, run, options);
      options.switches.samples = samples;
      SceneSource several(device, run, options);
      const eq::vec2 jitter_px(0.2f, -0.3f);
      FloatImage sum(48, 32, 4);
      for (const eq::vec2 offset : standardOffsets(samples)) {
        const FloatImage part =
            colorOf(device, one, 2, eq::vec2(jitter_px.x - offset.x, jitter_px.y - offset.y));
        for (size_t k = 0; k < sum.texels.size(); ++k)
          sum.texels[k] += part.texels[k] / static_cast<float>(samples);
      }
      const uint64_t evaluations = one.takeEvaluations();
      const FloatImage mean = colorOf(device, several, 2, jitter_px);
      for (size_t k = 0; k < sum.texels.size(); ++k) {
        ASSERT_NEAR(mean.texels[k], sum.texels[k], 1.0e-3f + 1.0e-3f * sum.texels[k]) << run.name;
      }
      EXPECT_EQ(several.takeEvaluations(), evaluations);
    }
}

TEST_F(Sampling, HolesShowWhatLiesBehindAndItsMotion) {
  SceneSource source(device, madeUpRun<cardBeforeWall>(), testOptions({64, 64}));
  constexpr uint32_t kFrame = 7;
  SamplePlan plan;
  FrameInputs inputs;
  device.submitAndWait(
      [&](VkCommandBuffer commands) { inputs = source.frame(commands, kFrame, plan); });
  const FloatImage depth = download(device, *inputs.depth);
  const FloatImage motion = download(device, *inputs.motion);
  // swayPush_world, with its constant of 2.3 rad/s; 32 pixels a metre at the card.
  const auto slide_m = [](double frame) { return 0.2 * std::sin(2.3 * frame / 60.0 + 0.3); };
  const double moved_px = 32.0 * (slide_m(kFrame - 1) - slide_m(kFrame));
  const double now_px = 32.0 * slide_m(kFrame);
  uint32_t seen[2] = {0, 0};
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 0; x < 64; ++x) {
      const double card_x = x + 0.5 - now_px;  // in pixels of the card, which is 64 wide
      const double from_hole = std::max(std::abs(card_x - 32.0), std::abs(y + 0.5 - 32.0)) - 16.0;
      if (std::abs(from_hole) < 1.5 || card_x < 1.5 || card_x > 62.5) continue;
      const bool hole = from_hole < 0.0;
      ++seen[hole ? 1 : 0];
      // near / view depth: the card at 1 m, the wall at 3 m.
      ASSERT_NEAR(depth.at(x, y)[0], 0.05f / (hole ? 3.0f : 1.0f), 1.0e-4f) << x << ", " << y;
      ASSERT_NEAR(motion.at(x, y)[0], hole ? 0.0 : moved_px, 1.0e-3) << x << ", " << y;
      ASSERT_NEAR(motion.at(x, y)[1], 0.0f, 1.0e-4f);
    }
  }
  EXPECT_GT(seen[0], 1500u);
  EXPECT_GT(seen[1], 700u);
}

TEST_F(Sampling, ReferencesOfOtherFiltersAreOtherReferences) {
  SceneSourceOptions options = testOptions({16, 16});
  SceneSource aniso(device, parseSceneRun("foliage/still"), options);
  options.switches.texture_filter = TextureFilter::kNone;
  SceneSource none(device, parseSceneRun("foliage/still"), options);
  aniso.renderer().setFrame(0, 0.0f);
  none.renderer().setFrame(0, 0.0f);
  EXPECT_NE(aniso.renderer().contentBytes(), none.renderer().contentBytes());
}

}  // namespace
}  // namespace reprise::lab
