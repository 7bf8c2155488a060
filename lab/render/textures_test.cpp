// SPDX-License-Identifier: MIT
#include "lab/render/textures.h"

#include <cmath>
#include <random>

#include "lab/render/image_pyramid.h"
#include "lab/render/made_up_scene.h"

namespace reprise::lab {
namespace {

SceneImage plainImage(uint32_t width, uint32_t height, ImageRole role) {
  return {width, height, role, 0.0f, std::vector<uint8_t>(size_t{4} * width * height, 255)};
}

// Smooth noise with detail at every scale, so that every level looks different.
SceneImage noiseImage() {
  constexpr uint32_t kSize = 256;
  SceneImage image = plainImage(kSize, kSize, ImageRole::kMask);
  std::mt19937 random(5);
  for (uint8_t& value : image.rgba) value = static_cast<uint8_t>(random() >> 24);
  for (uint32_t block = 2; block <= 32; block *= 2) {
    for (uint32_t y = 0; y < kSize; y += block) {
      for (uint32_t x = 0; x < kSize; x += block) {
        const auto value = static_cast<uint8_t>(random() >> 24);
        for (uint32_t dy = 0; dy < block; ++dy) {
          for (uint32_t dx = 0; dx < block; ++dx) {
            uint8_t& texel = image.rgba[4 * ((y + dy) * kSize + x + dx)];
            texel = static_cast<uint8_t>((2 * texel + value) / 3);
          }
        }
      }
    }
  }
  return image;
}

constexpr VkExtent2D kExtent{64, 64};
// At pixel centres a bilinear lookup of one level is exactly a texel of the next.
const eq::vec2 kOff_px(0.37f, 0.21f);

// A wall that fills the frame, showing `x` and `y` texels of the noise a pixel, unlit.
template <int x_percent, int y_percent>
MadeUp wall() {
  MadeUp scene;
  const uint32_t texture = addImage(scene.geometry, noiseImage());
  scene.geometry.materials.push_back({.parameters = {0.0f, 0.0f, 0.0f, 1.0f},
                                      .emission = {1.0f, 1.0f, 1.0f, 0.0f},
                                      .kind = kMaterialTextured,
                                      .emission_texture = texture});
  // 90 degrees from 1 m: the frame is 2 m wide.
  const glm::vec2 uv(kExtent.width * (x_percent / 100.0f) / 256.0f,
                     kExtent.height * (y_percent / 100.0f) / 256.0f);
  addQuad(scene.geometry, {-1.0f, -1.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}, uv, 0);
  scene.pose = {.eye_world = {0.0f, 0.0f, 1.0f},
                .target_world = {0.0f, 0.0f, 0.0f},
                .vertical_fov = 1.5707963f};
  return scene;
}

float bilinear(const std::vector<std::vector<uint8_t>>& levels, uint32_t level, glm::vec2 uv) {
  const auto size = static_cast<int>(256u >> level);
  const glm::vec2 at = uv * static_cast<float>(size) - 0.5f;
  const glm::vec2 base = glm::floor(at);
  const glm::vec2 f = at - base;
  const auto texel = [&](int dx, int dy) {
    const int x = (static_cast<int>(base.x) + dx + 4 * size) % size;
    const int y = (static_cast<int>(base.y) + dy + 4 * size) % size;
    return static_cast<float>(levels[level][4 * (static_cast<size_t>(y) * size + x)]) / 255.0f;
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x), glm::mix(texel(0, 1), texel(1, 1), f.x),
                  f.y);
}

// Mean absolute difference between what was rendered and level `level` looked up on the CPU.
double distanceToLevel(const FloatImage& image, uint32_t level, float texels_a_px) {
  static const std::vector<std::vector<uint8_t>> levels = imagePyramid(noiseImage(), 256, 256);
  double sum = 0.0;
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      // v grows upwards.
      const glm::vec2 at(x + 0.5f - kOff_px.x,
                         static_cast<float>(image.height - y) - 0.5f + kOff_px.y);
      const glm::vec2 uv = at * texels_a_px / 256.0f;
      sum += std::abs(image.at(x, y)[0] - bilinear(levels, level, uv));
    }
  }
  return sum / static_cast<double>(image.texelCount());
}

using TextureFiltering = DeviceTest;

template <int percent>
FloatImage wallWith(Device& device, TextureFilter filter, float mip_bias = 0.0f) {
  SceneSourceOptions options = testOptions(kExtent);
  options.switches.texture_filter = filter;
  SceneSource source(device, madeUpRun<wall<percent, percent>>(), options);
  return colorOf(device, source, 0, kOff_px, mip_bias);
}

// 8-bit texels, 8-bit filter weights, half-precision output.
constexpr double kSame = 0.004;

TEST_F(TextureFiltering, PicksTheLevelOfOneTexelAPixel) {
  for (const TextureFilter filter : {TextureFilter::kTrilinear, TextureFilter::kAniso16}) {
    EXPECT_LT(distanceToLevel(wallWith<100>(device, filter), 0, 1.0f), kSame);
    EXPECT_LT(distanceToLevel(wallWith<200>(device, filter), 1, 2.0f), kSame);
    EXPECT_LT(distanceToLevel(wallWith<400>(device, filter), 2, 4.0f), kSame);
    EXPECT_GT(distanceToLevel(wallWith<400>(device, filter), 1, 4.0f), 4.0 * kSame);
    EXPECT_GT(distanceToLevel(wallWith<400>(device, filter), 3, 4.0f), 4.0 * kSame);
  }
}

TEST_F(TextureFiltering, NoneIsLevelZeroWhateverTheDistance) {
  EXPECT_LT(distanceToLevel(wallWith<400>(device, TextureFilter::kNone), 0, 4.0f), kSame);
}

TEST_F(TextureFiltering, MipBiasMovesTheLevelByItself) {
  const TextureFilter filter = TextureFilter::kTrilinear;
  EXPECT_LT(distanceToLevel(wallWith<400>(device, filter, -1.0f), 1, 4.0f), kSame);
  EXPECT_LT(distanceToLevel(wallWith<200>(device, filter, 1.0f), 2, 2.0f), kSame);
}

TEST_F(TextureFiltering, AnisotropyKeepsDetailAcrossTheShortGradient) {
  const auto contrast = [&](TextureFilter filter) {
    SceneSourceOptions options = testOptions(kExtent);
    options.switches.texture_filter = filter;
    SceneSource source(device, madeUpRun<wall<100, 800>>(), options);
    const FloatImage image = colorOf(device, source);
    double sum = 0.0;
    for (uint32_t y = 0; y < image.height; ++y) {
      for (uint32_t x = 1; x < image.width; ++x) {
        sum += std::abs(image.at(x, y)[0] - image.at(x - 1, y)[0]);
      }
    }
    return sum;
  };
  EXPECT_GT(contrast(TextureFilter::kAniso16), 2.0 * contrast(TextureFilter::kTrilinear));
}

TEST(ImagePyramid, AveragesLightNotBytes) {
  SceneImage image = plainImage(4, 4, ImageRole::kColor);
  for (size_t i = 0; i < 16; ++i) {
    const uint8_t v = (i + i / 4) % 2 == 0 ? 255 : 0;
    for (size_t c = 0; c < 3; ++c) image.rgba[4 * i + c] = v;
  }
  const auto levels = imagePyramid(image, 4, 4);
  ASSERT_EQ(levels.size(), 3u);
  EXPECT_EQ(levels[0], image.rgba);
  EXPECT_EQ(levels[1][0], 188);  // half the light in sRGB: 1.055 * 0.5^(1/2.4) - 0.055
  EXPECT_EQ(levels[2][0], 188);
}

TEST(ImagePyramid, WhatLiesInHolesDoesNotBleed) {
  SceneImage image = plainImage(2, 2, ImageRole::kColor);
  image.rgba = {0, 200, 0, 255, 255, 0, 0, 0, 255, 0, 0, 0, 0, 200, 0, 255};
  const auto levels = imagePyramid(image, 2, 2);
  EXPECT_LT(levels[1][0], 16);
  EXPECT_NEAR(levels[1][1], 200, 1);
  EXPECT_NEAR(levels[1][3], 128, 1);
}

TEST(ImagePyramid, KeepsCoverage) {
  SceneImage image = plainImage(128, 128, ImageRole::kColor);
  image.alpha_cutoff = 0.5f;
  std::mt19937 random(9);
  for (size_t i = 0; i < 128 * 128; ++i) {
    image.rgba[4 * i + 3] = random() % 10 < 3 ? 255 : 0;  // an average would fall below the cutoff
  }
  const auto levels = imagePyramid(image, 128, 128);
  const float wanted = coverage(levels[0], 0.5f);
  for (size_t level = 1; level < 5; ++level) {
    EXPECT_NEAR(coverage(levels[level], 0.5f), wanted, 0.06f)
        << level;  // 2 x 2 averages take few values
  }
  image.alpha_cutoff = 0.0f;
  EXPECT_LT(coverage(imagePyramid(image, 128, 128)[4], 0.5f), 0.5f * wanted);
}

TEST(ImagePyramid, NormalsStayUnit) {
  SceneImage image = plainImage(64, 32, ImageRole::kNormal);
  std::mt19937 random(2);
  for (size_t i = 0; i < 64 * 32; ++i) {
    image.rgba[4 * i] = static_cast<uint8_t>(random() % 256);
    image.rgba[4 * i + 1] = static_cast<uint8_t>(random() % 256);
    image.rgba[4 * i + 2] = 255;
  }
  for (const auto& level : imagePyramid(image, 64, 32)) {
    for (size_t i = 0; i < level.size(); i += 4) {
      const glm::vec3 normal =
          glm::vec3(level[i], level[i + 1], level[i + 2]) / 127.5f - glm::vec3(1.0f);
      ASSERT_NEAR(glm::length(normal), 1.0f, 0.02f);
    }
  }
}

TEST(TextureClasses, OneASizeAndSpaceWhileTheyFit) {
  const std::vector<SceneImage> images{
      plainImage(64, 64, ImageRole::kColor), plainImage(64, 64, ImageRole::kNormal),
      plainImage(64, 64, ImageRole::kColor), plainImage(64, 32, ImageRole::kMask)};
  const auto classes = textureClasses(images);
  ASSERT_EQ(classes.size(), 3u);
  EXPECT_EQ(classes[0].images, (std::vector<uint32_t>{0, 2}));
  EXPECT_TRUE(classes[0].srgb);
  EXPECT_FALSE(classes[1].srgb);
}

TEST(TextureClasses, ManySizesAreMergedToEight) {
  std::vector<SceneImage> images;
  for (uint32_t i = 0; i < 24; ++i) {
    images.push_back(plainImage(16 + 3 * i, 16 + (i * 7) % 40,
                                i % 2 == 0 ? ImageRole::kColor : ImageRole::kNormal));
  }
  const auto classes = textureClasses(images);
  EXPECT_EQ(classes.size(), size_t{kMaxTextureClasses});
  std::vector<int> seen(images.size(), 0);
  for (const TextureClass& c : classes) {
    for (const uint32_t image : c.images) {
      ++seen[image];
      EXPECT_EQ(c.srgb, images[image].role == ImageRole::kColor);
    }
  }
  for (const int times : seen) EXPECT_EQ(times, 1);
}

}  // namespace
}  // namespace reprise::lab
