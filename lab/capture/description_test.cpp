// SPDX-License-Identifier: MIT
#include "lab/capture/description.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>

#include "lab/capture/capture_error.h"
#include "lab/capture/far_motion.h"
#include "lab/capture/output_file.h"

namespace reprise::lab {
namespace {

const std::string kSmall = R"({
 "version": 1, "extent": [64, 32], "frame_rate": 24,
 "color": {"layer": "color"},
 "depth": {"channel": "depth.Z", "kind": "device", "reversed": true, "infinite": true},
 "motion": {"channels": ["motion.X", "motion.Y"]},
 "frames": [{"frame": 1, "jitter": [0.25, -0.5], "reset": true}, {"frame": 2, "jitter": [0, 0]}]
})";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

std::string errorOf(const std::string& text) {
  try {
    parseDescription(text, "capture.json");
  } catch (const CaptureError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Description, Defaults) {
  const CaptureDescription d = parseDescription(kSmall, "capture.json");
  EXPECT_EQ(d.extent.width, 64u);
  EXPECT_EQ(d.depthKind(), REPRISE_DEPTH_REVERSED_INFINITE);
  EXPECT_EQ(d.motion.unit, MotionUnit::kPixels);
  EXPECT_FALSE(d.motion.from_previous);
  ASSERT_EQ(d.frames.size(), 2u);
  EXPECT_EQ(d.frames[0].jitter_px[1], -0.5f);
  EXPECT_EQ(d.frameFile(1), "frame_0002.exr");
}

TEST(Description, BadInputNamesFileAndKey) {
  const struct {
    const char* what;
    const char* with;
    const char* error;
  } cases[] = {
      {"\"motion\":", "\"montion\":", "capture.json: motion: is missing"},
      {"\"frame_rate\": 24", "\"frame_rat\": 24", "frame_rat: unknown key; near: 'frame_rate'"},
      {"\"kind\": \"device\"", "\"kind\": \"z\"",
       "depth.kind: 'z' is not one of planar, ray, device"},
      {"\"kind\": \"device\"", "\"kind\": \"ray\"", "depth.kind: reversed and infinite belong"},
      {"\"reversed\": true", "\"revered\": true", "depth.revered: unknown key; near: 'reversed'"},
      {"[0.25, -0.5]", "[1.5, 0]", "frames[0].jitter: 1.5 is outside [-1, 1] pixels (frame 1)"},
      {"[0.25, -0.5]", "[0.5]", "frames[0].jitter: must be 2 numbers"},
      {"[64, 32]", "[64, 0]", "extent: 0 is not a whole number in [1, 16384]"},
      {"[64, 32]", "[64.5, 32]", "extent: 64.5"},
      {"\"version\": 1", "\"version\": 2", "version: 2 is not in [1, 1]"},
      {"\"frame\": 2", "\"frame\": 1", "numbers must rise: 1 comes after 1"},
      {"\"frame\": 2", "\"frame\": 2, \"rest\": 1", "frames[1].rest: unknown key; near: 'reset'"},
      {"\"reset\": true", "\"reset\": 1", "frames[0].reset: must be true or false"},
      {"[\"motion.X\", \"motion.Y\"]", "[\"motion.X\"]",
       "motion.channels: must be two channel names"},
      {"\"frame_rate\": 24,", "\"frame_rate\": 24", "line 3: is no valid JSON"},
      {"{\"layer\": \"color\"}", "3", "color: must be an object"},
  };
  for (const auto& c : cases) {
    EXPECT_NE(errorOf(replaced(kSmall, c.what, c.with)).find(c.error), std::string::npos)
        << errorOf(replaced(kSmall, c.what, c.with)) << "\nexpected: " << c.error;
  }
  EXPECT_NE(errorOf("[]").find("must be an object"), std::string::npos);
}

TEST(Description, ComesBackAsWritten) {
  CaptureDescription d = parseDescription(kSmall, "capture.json");
  RepriseCamera camera{};
  for (int i = 0; i < 16; ++i) {
    camera.view[i] = 0.1f * static_cast<float>(i) - 0.7f;
    camera.projection[i] = 1.0f / static_cast<float>(i + 3);
  }
  d.frames[1].camera = captureCamera(camera, 0.037f, std::numeric_limits<float>::infinity());
  d.frames[1].jitter_px[0] = 0.1f;
  d.reference_samples = 64;
  d.plan = "taa:alpha=0.1";
  const CaptureDescription back = parseDescription(descriptionText(d), "capture.json");
  EXPECT_EQ(descriptionText(back), descriptionText(d));
  ASSERT_TRUE(back.frames[1].camera.has_value());
  EXPECT_EQ(back.frames[1].camera->near_plane, 0.037f);
  EXPECT_TRUE(std::isinf(back.frames[1].camera->far_plane));
  EXPECT_EQ(back.frames[1].jitter_px[0], 0.1f);
  const std::optional<RepriseCamera> columns = libraryCamera(*back.frames[1].camera);
  ASSERT_TRUE(columns.has_value());
  EXPECT_EQ(std::memcmp(&*columns, &camera, sizeof(camera)), 0);
}

MatrixRows pinhole() {
  MatrixRows rows{};
  rows[0] = 2.0f;
  rows[5] = 4.0f;
  rows[14] = -1.0f;
  return rows;
}

MatrixRows yaw(float angle) {
  MatrixRows rows{};
  rows[0] = std::cos(angle);
  rows[2] = std::sin(angle);
  rows[5] = 1.0f;
  rows[8] = -std::sin(angle);
  rows[10] = std::cos(angle);
  rows[15] = 1.0f;
  return rows;
}

TEST(FarMotion, TurningMovesTheSkyAgainstIt) {
  const CaptureCamera before{0.1f, 10.0f, yaw(0.0f), pinhole()};
  CaptureCamera now{0.1f, 10.0f, yaw(0.1f), pinhole()};
  const auto motion = FarMotion::between(before, now, {200, 100});
  ASSERT_TRUE(motion.has_value());
  const auto centre = motion->at(100.0, 50.0);
  ASSERT_TRUE(centre.has_value());
  // The ray of the centre lies at tan(0.1) of the previous view; 2 is the projection's scale.
  EXPECT_NEAR(std::abs((*centre)[0]), std::tan(0.1) * 2.0 * 100.0, 1e-3);
  EXPECT_NEAR((*centre)[1], 0.0, 1e-4);
  // Moving without turning leaves points at infinity where they are.
  now = before;
  (*now.view)[3] = 5.0f;
  const auto moved = FarMotion::between(before, now, {200, 100});
  EXPECT_NEAR((*moved->at(17.0, 31.0))[0], 0.0, 1e-4);
  EXPECT_NEAR((*moved->at(17.0, 31.0))[1], 0.0, 1e-4);
  // Behind the previous camera.
  now.view = yaw(3.1f);
  EXPECT_FALSE(FarMotion::between(before, now, {200, 100})->at(100.0, 50.0).has_value());
  // No pinhole, no answer.
  now.projection = yaw(0.0f);
  EXPECT_FALSE(FarMotion::between(before, now, {200, 100}).has_value());
}

}  // namespace
}  // namespace reprise::lab
