// SPDX-License-Identifier: MIT
#include "lab/capture/capture_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "lab/capture/capture_error.h"
#include "lab/capture/far_motion.h"

namespace reprise::lab {
namespace {

constexpr uint16_t kHalfOne = 0x3c00;

// Of colour channel 0, 1 or 2.
std::string colorChannel(const CaptureDescription& description, size_t c) {
  const std::string prefix = description.color_layer.empty() ? "" : description.color_layer + ".";
  return prefix + "RGB"[c];
}

class FrameReader {
 public:
  FrameReader(const std::filesystem::path& directory, const CaptureDescription& description,
              size_t index)
      : description_(description),
        info_(description.frames[index]),
        previous_(index > 0 ? &description.frames[index - 1] : nullptr),
        path_((directory / description.frameFile(index)).string()) {
    frame_.file = readExr(path_);
    width_ = description.extent.width;
    height_ = description.extent.height;
    if (frame_.file.width != width_ || frame_.file.height != height_) {
      fail("extent", fmt::format("{}x{} where the sequence has {}x{}", frame_.file.width,
                                 frame_.file.height, width_, height_));
    }
  }

  CaptureFrame read() {
    readColor();
    const std::vector<bool> background = readDepth();
    readMotion(background);
    if (!description_.reactive_channel.empty()) {
      frame_.reactive = channel(description_.reactive_channel, "reactive").floats();
      for (float& value : frame_.reactive) value = std::isfinite(value) ? value : 0.0f;
    }
    if (!description_.id_channel.empty()) {
      for (float value : channel(description_.id_channel, "id").floats()) {
        frame_.id.push_back(value >= 0.0f && value < 4.0e9f ? static_cast<uint32_t>(value) : 0u);
      }
    }
    return std::move(frame_);
  }

 private:
  [[noreturn]] void fail(const std::string& field, const std::string& what) const {
    throw CaptureError(path_, fmt::format("frame {}: {}", info_.number, field), what);
  }

  const ExrChannel& channel(const std::string& name, const char* field) const {
    const ExrChannel* found = frame_.file.find(name);
    if (found == nullptr) fail(field, "there is no channel '" + name + "'");
    return *found;
  }

  void readColor() {
    const size_t count = size_t{width_} * height_;
    FloatImage rgb(width_, height_, 3);
    frame_.color_is_half = colorIsHalf(frame_.file, description_);
    const ExrChannel* channels[3];
    for (size_t c = 0; c < 3; ++c) {
      channels[c] = &channel(colorChannel(description_, c), "color");
      const std::vector<float> values = channels[c]->floats();
      for (size_t i = 0; i < count; ++i) rgb.texels[3 * i + c] = values[i];
    }
    frame_.repairs.color = repairColor(rgb);
    if (frame_.color_is_half) {
      // The very bits, but for repaired texels: what a live image held comes back.
      std::vector<uint16_t> texels(4 * count, kHalfOne);
      for (size_t c = 0; c < 3; ++c) {
        const ExrChannel& source = *channels[c];
        const ExrChannel repaired =
            frame_.repairs.color > 0
                ? exrChannel("", ExrType::kHalf, std::span(rgb.texels).subspan(c), 3)
                : source;
        for (size_t i = 0; i < count; ++i) {
          std::memcpy(&texels[4 * i + c], &repaired.texels[2 * i], 2);
        }
      }
      const auto* bytes = reinterpret_cast<const uint8_t*>(texels.data());
      frame_.color.assign(bytes, bytes + texels.size() * sizeof(texels[0]));
    } else {
      std::vector<float> texels(4 * count, 1.0f);
      for (size_t i = 0; i < count; ++i) std::copy_n(&rgb.texels[3 * i], 3, &texels[4 * i]);
      const auto* bytes = reinterpret_cast<const uint8_t*>(texels.data());
      frame_.color.assign(bytes, bytes + texels.size() * sizeof(texels[0]));
    }
  }

  uint64_t repairColor(FloatImage& rgb) const {
    std::vector<size_t> broken;
    for (size_t i = 0; i < rgb.texelCount(); ++i) {
      const float* texel = &rgb.texels[3 * i];
      if (!std::isfinite(texel[0]) || !std::isfinite(texel[1]) || !std::isfinite(texel[2])) {
        broken.push_back(i);
      }
    }
    if (broken.empty()) return 0;
    const FloatImage source = rgb;
    for (size_t i : broken) {
      const int x = static_cast<int>(i % width_);
      const int y = static_cast<int>(i / width_);
      for (uint32_t c = 0; c < 3; ++c) {
        float sum = 0.0f;
        int count = 0;
        for (int ny = std::max(y - 1, 0); ny <= std::min<int>(y + 1, height_ - 1); ++ny) {
          for (int nx = std::max(x - 1, 0); nx <= std::min<int>(x + 1, width_ - 1); ++nx) {
            const float value = source.at(static_cast<uint32_t>(nx), static_cast<uint32_t>(ny))[c];
            if (!std::isfinite(value)) continue;
            sum += value;
            ++count;
          }
        }
        rgb.texels[3 * i + c] = count > 0 ? sum / static_cast<float>(count) : 0.0f;
      }
    }
    return broken.size();
  }

  // Returns which pixels nothing covers.
  std::vector<bool> readDepth() {
    frame_.depth = channel(description_.depth.channel, "depth").floats();
    const bool device = description_.depth.kind == CaptureDepth::kDevice;
    const float far_value =
        device ? (description_.depth.reversed ? 0.0f : 1.0f) : std::numeric_limits<float>::max();
    const float background_value = description_.depth.background.value_or(far_value);
    std::vector<bool> background(frame_.depth.size());
    for (size_t i = 0; i < frame_.depth.size(); ++i) {
      float& depth = frame_.depth[i];
      // Cycles and others write +infinity for what nothing covers.
      if (std::isnan(depth) || (std::isinf(depth) && device) || depth < 0.0f) {
        depth = background_value;
        ++frame_.repairs.depth;
      }
      if (std::isinf(depth)) depth = background_value;
      background[i] = device ? depth == background_value : depth >= background_value;
    }
    if (description_.depth.kind == CaptureDepth::kRay) makePlanar(background);
    return background;
  }

  // planar = ray / |(x, y, -1)| with (x, y, -1) the ray through the sample.
  void makePlanar(const std::vector<bool>& background) {
    if (!info_.camera.has_value() || !info_.camera->projection.has_value()) {
      fail("camera", "depth of the kind 'ray' needs 'projection' or 'fov_y_deg'");
    }
    const MatrixRows& p = *info_.camera->projection;
    for (uint32_t y = 0; y < height_; ++y) {
      for (uint32_t x = 0; x < width_; ++x) {
        const size_t i = size_t{y} * width_ + x;
        if (background[i]) continue;
        const double ndc_x = 2.0 * (x + 0.5 - info_.jitter_px[0]) / width_ - 1.0;
        const double ndc_y = 1.0 - 2.0 * (y + 0.5 - info_.jitter_px[1]) / height_;
        const double ray_x = (ndc_x + p[2]) / p[0];
        const double ray_y = (ndc_y + p[6]) / p[5];
        frame_.depth[i] =
            static_cast<float>(frame_.depth[i] / std::sqrt(ray_x * ray_x + ray_y * ray_y + 1.0));
      }
    }
  }

  void readMotion(const std::vector<bool>& background) {
    const CaptureDescription::Motion& motion = description_.motion;
    const std::vector<float> x = channel(motion.channels[0], "motion").floats();
    const std::vector<float> y = channel(motion.channels[1], "motion").floats();
    float scale[2] = {motion.scale[0], motion.scale[1]};
    if (motion.unit != MotionUnit::kPixels) {
      const float whole = motion.unit == MotionUnit::kUv ? 1.0f : 0.5f;
      scale[0] *= whole * static_cast<float>(width_);
      scale[1] *= whole * static_cast<float>(height_);
    }
    if (motion.from_previous) {
      scale[0] = -scale[0];
      scale[1] = -scale[1];
    }
    std::optional<FarMotion> far_motion;
    if (motion.background_is_zero && previous_ != nullptr && previous_->camera && info_.camera) {
      far_motion = FarMotion::between(*previous_->camera, *info_.camera, description_.extent);
    }
    frame_.motion.resize(2 * x.size());
    for (size_t i = 0; i < x.size(); ++i) {
      float* texel = &frame_.motion[2 * i];
      texel[0] = x[i] * scale[0];
      texel[1] = y[i] * scale[1];
      if (!std::isfinite(texel[0]) || !std::isfinite(texel[1])) {
        texel[0] = texel[1] = 0.0f;
        ++frame_.repairs.motion;
      }
      const size_t column = i % width_;
      const size_t row = i / width_;
      if (std::abs(texel[0]) > static_cast<float>(width_) ||
          std::abs(texel[1]) > static_cast<float>(height_)) {
        fail("motion", fmt::format("({}, {}) px at pixel ({}, {}) is larger than the image",
                                   texel[0], texel[1], column, row));
      }
      if (far_motion.has_value() && background[i]) {
        const auto moved = far_motion->at(static_cast<double>(column) + 0.5 - info_.jitter_px[0],
                                          static_cast<double>(row) + 0.5 - info_.jitter_px[1]);
        // Behind the previous camera: anything off the screen will do.
        texel[0] = moved ? (*moved)[0] : 2.0f * static_cast<float>(width_);
        texel[1] = moved ? (*moved)[1] : 2.0f * static_cast<float>(height_);
      }
    }
  }

  const CaptureDescription& description_;
  const CaptureFrameInfo& info_;
  const CaptureFrameInfo* previous_;
  std::string path_;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  CaptureFrame frame_;
};

}  // namespace

void Repairs::add(const Repairs& other) {
  color += other.color;
  depth += other.depth;
  motion += other.motion;
}

bool colorIsHalf(const ExrImage& file, const CaptureDescription& description) {
  for (size_t c = 0; c < 3; ++c) {
    const ExrChannel* channel = file.find(colorChannel(description, c));
    if (channel == nullptr || channel->type != ExrType::kHalf) return false;
  }
  return true;
}

CaptureFrame readCaptureFrame(const std::filesystem::path& directory,
                              const CaptureDescription& description, size_t index) {
  return FrameReader(directory, description, index).read();
}

FloatImage readCaptureReference(const std::filesystem::path& directory,
                                const CaptureDescription& description, size_t index) {
  const std::string path = (directory / description.referenceFile(index)).string();
  const ExrImage file = readExr(path);
  if (file.width != description.extent.width || file.height != description.extent.height) {
    throw CaptureError(path, "extent",
                       fmt::format("{}x{} where the sequence has {}x{}", file.width, file.height,
                                   description.extent.width, description.extent.height));
  }
  FloatImage rgb(file.width, file.height, 3);
  for (size_t c = 0; c < 3; ++c) {
    const std::string name = colorChannel(description, c);
    const ExrChannel* channel = file.find(name);
    if (channel == nullptr) throw CaptureError(path, "color", "there is no channel '" + name + "'");
    const std::vector<float> values = channel->floats();
    for (size_t i = 0; i < values.size(); ++i) rgb.texels[3 * i + c] = values[i];
  }
  return rgb;
}

}  // namespace reprise::lab
