// SPDX-License-Identifier: MIT
//
// capture.json: what a captured sequence holds and by which conventions. docs/capture.md lists
// every key; a key that is not listed there is an error.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reprise/reprise.h"

namespace reprise::lab {

using MatrixRows = std::array<float, 16>;  // row after row

struct CaptureCamera {
  float near_plane = 0.1f;
  float far_plane = std::numeric_limits<float>::infinity();
  // World to camera, right-handed, -z forward.
  std::optional<MatrixRows> view;
  // To clip space with y up, no jitter. The depth row is not read: `depth` says what depth is.
  std::optional<MatrixRows> projection;
};

struct CaptureFrameInfo {
  uint32_t number = 0;  // of frame_NNNN.exr
  float jitter_px[2] = {0.0f, 0.0f};
  bool reset = false;
  float pre_exposure = 1.0f;
  std::optional<CaptureCamera> camera;
};

enum class CaptureDepth { kPlanar, kRay, kDevice, kOrthographic };
enum class MotionUnit { kPixels, kUv, kNdc };

struct CaptureDescription {
  std::string generator;
  VkExtent2D extent{};
  double frame_rate = 60.0;
  std::string color_layer;  // channels color_layer + ".R" and so on; "" for plain R, G, B
  struct Depth {
    std::string channel;
    CaptureDepth kind = CaptureDepth::kPlanar;
    bool reversed = false;
    bool infinite = false;
    std::optional<float> background;  // the value of pixels that nothing covers
  } depth;
  struct Motion {
    std::array<std::string, 2> channels;
    std::array<float, 2> scale{1.0f, 1.0f};
    MotionUnit unit = MotionUnit::kPixels;
    bool from_previous = false;  // px = prev_px + motion instead of prev_px = px + motion
    bool includes_jitter = false;
    bool background_is_zero = false;  // background motion is missing: it comes from the cameras
  } motion;
  std::string reactive_channel;    // "": none
  std::string id_channel;          // "": none
  uint32_t reference_samples = 0;  // 0: no references
  std::string reference_filter = "box";
  std::string plan;  // the technique that it was sampled for, with its settings
  std::vector<CaptureFrameInfo> frames;

  // What the library is told. Ray depth is made planar as it is read.
  RepriseDepthKind depthKind() const;
  // The file pattern's name of frame `index`: "frame_0001.exr".
  std::string file_prefix = "frame_";
  int file_digits = 4;
  std::string frameFile(size_t index) const;
  std::string referenceFile(size_t index) const;
};

// Throws CaptureError with the key's path.
CaptureDescription parseDescription(const std::string& text, const std::string& file);
std::string descriptionText(const CaptureDescription& description);

// Cameras as the library wants them (columns, Vulkan clip space); nullopt without both matrices.
std::optional<RepriseCamera> libraryCamera(const CaptureCamera& camera);
CaptureCamera captureCamera(const RepriseCamera& camera, float near_plane, float far_plane);

}  // namespace reprise::lab
