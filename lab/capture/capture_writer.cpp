// SPDX-License-Identifier: MIT
#include "lab/capture/capture_writer.h"

#include <cmath>
#include <cstring>

#include "lab/capture/capture_error.h"
#include "lab/capture/exr_file.h"
#include "lab/capture/output_file.h"
#include "lab/vk/image.h"

namespace reprise::lab {
namespace {

// The first `count` channels of interleaved texels, bits unchanged.
void addChannels(ExrImage& file, const std::vector<std::string>& names, ExrType type,
                 const std::vector<uint8_t>& texels, size_t texel_size) {
  const size_t size = type == ExrType::kHalf ? 2 : 4;
  const size_t count = texels.size() / texel_size;
  for (size_t c = 0; c < names.size(); ++c) {
    ExrChannel channel{names[c], type, std::vector<uint8_t>(count * size)};
    for (size_t i = 0; i < count; ++i) {
      std::memcpy(&channel.texels[i * size], &texels[i * texel_size + c * size], size);
    }
    file.channels.push_back(std::move(channel));
  }
}

}  // namespace

CaptureWriter::CaptureWriter(std::filesystem::path directory, const SourceInfo& source,
                             std::string plan, bool resume)
    : directory_(std::move(directory)), resume_(resume) {
  makeOutputDirectory(directory_);
  description_.generator = std::string("reprise ") + repriseGetVersion() + ", " + source.name;
  description_.extent = source.extent;
  description_.frame_rate = source.frame_rate;
  description_.color_layer = "color";
  description_.depth.channel = "depth.Z";
  switch (source.depth_kind) {
    case REPRISE_DEPTH_PLANAR:
      description_.depth.kind = CaptureDepth::kPlanar;
      break;
    case REPRISE_DEPTH_ORTHOGRAPHIC:
      description_.depth.kind = CaptureDepth::kOrthographic;
      break;
    default:
      description_.depth.kind = CaptureDepth::kDevice;
      break;
  }
  description_.depth.reversed = source.depth_kind == REPRISE_DEPTH_DEVICE_REVERSED ||
                                source.depth_kind == REPRISE_DEPTH_REVERSED_INFINITE;
  description_.depth.infinite = source.depth_kind == REPRISE_DEPTH_DEVICE_INFINITE ||
                                source.depth_kind == REPRISE_DEPTH_REVERSED_INFINITE;
  description_.motion.channels = {"motion.X", "motion.Y"};
  description_.motion.includes_jitter =
      (source.context_flags & REPRISE_CONTEXT_MOTION_INCLUDES_JITTER) != 0;
  description_.reference_samples = source.reference_samples;
  description_.reference_filter = source.reference_filter;
  description_.plan = std::move(plan);
}

bool CaptureWriter::isWhole(const std::filesystem::path& path) const {
  std::error_code error;
  if (!resume_ || !std::filesystem::exists(path, error)) return false;
  try {
    const ExrImage file = readExr(path);
    return file.width == description_.extent.width && file.height == description_.extent.height;
  } catch (const CaptureError&) {
    return false;
  }
}

void CaptureWriter::add(Device& device, const FrameInputs& inputs) {
  CaptureFrameInfo info;
  info.number = static_cast<uint32_t>(description_.frames.size()) + 1;
  info.jitter_px[0] = inputs.jitter_px[0];
  info.jitter_px[1] = inputs.jitter_px[1];
  info.reset = inputs.reset;
  info.pre_exposure = inputs.pre_exposure;
  if (inputs.camera.has_value()) {
    // An infinite far plane is left out.
    const bool infinite =
        description_.depth.infinite || description_.depth.kind == CaptureDepth::kPlanar;
    info.camera =
        captureCamera(*inputs.camera, inputs.near_plane,
                      infinite ? std::numeric_limits<float>::infinity() : inputs.far_plane);
  }
  description_.frames.push_back(info);
  const size_t index = description_.frames.size() - 1;

  const std::filesystem::path frame_path = directory_ / description_.frameFile(index);
  if (isWhole(frame_path)) {
    ++kept_;
  } else {
    ExrImage file{inputs.extent.width, inputs.extent.height, {}, nullptr};
    const bool half = inputs.color->format() == VK_FORMAT_R16G16B16A16_SFLOAT;
    addChannels(file, {"color.R", "color.G", "color.B"}, half ? ExrType::kHalf : ExrType::kFloat,
                downloadBytes(device, *inputs.color), half ? 8 : 16);
    addChannels(file, {"depth.Z"}, ExrType::kFloat, downloadBytes(device, *inputs.depth), 4);
    addChannels(file, {"motion.X", "motion.Y"}, ExrType::kFloat,
                downloadBytes(device, *inputs.motion), 8);
    writeExr(frame_path, file);
  }
}

void CaptureWriter::addReference(const FloatImage& reference) {
  const std::filesystem::path path =
      directory_ / description_.referenceFile(description_.frames.size() - 1);
  if (isWhole(path)) return;
  ExrImage file{reference.width, reference.height, {}, nullptr};
  const std::span<const float> texels(reference.texels);
  for (size_t c = 0; c < 3; ++c) {
    file.channels.push_back(exrChannel(std::string("color.") + "RGB"[c], ExrType::kFloat,
                                       texels.subspan(c), reference.channels));
  }
  writeExr(path, file);
}

void CaptureWriter::finish() {
  writeOutputFile(directory_ / "capture.json", descriptionText(description_));
}

}  // namespace reprise::lab
