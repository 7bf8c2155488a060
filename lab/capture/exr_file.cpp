// SPDX-License-Identifier: MIT
#include "lab/capture/exr_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <half.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "lab/capture/capture_error.h"
#include "lab/capture/output_file.h"

namespace reprise::lab {
namespace {

size_t texelSize(ExrType type) {
  return type == ExrType::kHalf ? 2 : 4;
}

ExrType fromImf(Imf::PixelType type) {
  return type == Imf::UINT ? ExrType::kUint : type == Imf::HALF ? ExrType::kHalf : ExrType::kFloat;
}
Imf::PixelType toImf(ExrType type) {
  return type == ExrType::kUint ? Imf::UINT : type == ExrType::kHalf ? Imf::HALF : Imf::FLOAT;
}

class MemoryStream final : public Imf::OStream {
 public:
  MemoryStream() : Imf::OStream("memory") {}
  void write(const char* bytes, int count) override {
    const auto size = static_cast<size_t>(count);
    if (position_ + size > bytes_.size()) bytes_.resize(position_ + size);
    std::memcpy(bytes_.data() + position_, bytes, size);
    position_ += size;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
  size_t position_ = 0;
};

ExrImage headerOf(const Imf::Header& header, const std::string& file) {
  const Imath::Box2i window = header.dataWindow();
  const int64_t width = int64_t{window.max.x} - window.min.x + 1;
  const int64_t height = int64_t{window.max.y} - window.min.y + 1;
  if (width < 1 || height < 1 || width > kMaxExrSide || height > kMaxExrSide) {
    throw CaptureError(file, "dataWindow",
                       "extent " + std::to_string(width) + "x" + std::to_string(height) +
                           " is not in [1, " + std::to_string(kMaxExrSide) + "]");
  }
  ExrImage image;
  image.width = static_cast<uint32_t>(width);
  image.height = static_cast<uint32_t>(height);
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
    if (c.channel().xSampling != 1 || c.channel().ySampling != 1) {
      throw CaptureError(file, c.name(), "subsampled channels are not supported");
    }
    image.channels.push_back({c.name(), fromImf(c.channel().type), {}});
  }
  image.attributes = std::make_shared<Imf::Header>(header);
  return image;
}

ExrImage read(const std::filesystem::path& path, bool texels) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw CaptureError(path.string(), "", "there is no such file");
  }
  try {
    Imf::InputFile file(path.c_str());
    ExrImage image = headerOf(file.header(), path.string());
    if (!texels) return image;
    const Imath::Box2i window = file.header().dataWindow();
    Imf::FrameBuffer frame;
    for (ExrChannel& channel : image.channels) {
      const size_t size = texelSize(channel.type);
      const size_t row = size * image.width;
      channel.texels.resize(row * image.height);
      // Imf addresses texel (x, y) at base + x * size + y * row, from the data window's corner on.
      char* base = reinterpret_cast<char*>(channel.texels.data()) -
                   static_cast<std::ptrdiff_t>(window.min.x) * static_cast<std::ptrdiff_t>(size) -
                   static_cast<std::ptrdiff_t>(window.min.y) * static_cast<std::ptrdiff_t>(row);
      frame.insert(channel.name, Imf::Slice(toImf(channel.type), base, size, row));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return image;
  } catch (const CaptureError&) {
    throw;
  } catch (const std::exception& failure) {
    // Imf's own text holds the path and may have several lines.
    std::string text = failure.what();
    std::replace(text.begin(), text.end(), '\n', ' ');
    throw CaptureError(path.string(), "", "truncated or damaged EXR file (" + text + ")");
  }
}

}  // namespace

std::vector<float> ExrChannel::floats() const {
  std::vector<float> values(texels.size() / texelSize(type));
  for (size_t i = 0; i < values.size(); ++i) {
    if (type == ExrType::kHalf) {
      uint16_t bits = 0;
      std::memcpy(&bits, &texels[2 * i], 2);
      half value;
      value.setBits(bits);
      values[i] = value;
    } else if (type == ExrType::kFloat) {
      std::memcpy(&values[i], &texels[4 * i], 4);
    } else {
      uint32_t value = 0;
      std::memcpy(&value, &texels[4 * i], 4);
      values[i] = static_cast<float>(value);
    }
  }
  return values;
}

const ExrChannel* ExrImage::find(std::string_view name) const {
  for (const ExrChannel& channel : channels) {
    if (channel.name == name) return &channel;
  }
  return nullptr;
}

ExrChannel* ExrImage::find(std::string_view name) {
  return const_cast<ExrChannel*>(std::as_const(*this).find(name));
}

ExrImage readExr(const std::filesystem::path& path) {
  return read(path, true);
}
ExrImage readExrHeader(const std::filesystem::path& path) {
  return read(path, false);
}

void writeExr(const std::filesystem::path& path, const ExrImage& image) {
  const int width = static_cast<int>(image.width);
  const int height = static_cast<int>(image.height);
  Imf::Header header(width, height);
  if (image.attributes != nullptr) {
    header = *std::static_pointer_cast<const Imf::Header>(image.attributes);
    // A tiled source is written as scanlines.
    if (header.hasTileDescription()) header.erase("tiles");
    if (header.hasType()) header.setType(Imf::SCANLINEIMAGE);
    header.erase("chunkCount");
    const Imath::Box2i kept = header.dataWindow();
    if (kept.max.x - kept.min.x + 1 != width || kept.max.y - kept.min.y + 1 != height) {
      // Scaled: neither window means anything any more.
      header.dataWindow() = Imath::Box2i({0, 0}, {width - 1, height - 1});
      header.displayWindow() = header.dataWindow();
    }
  }
  const Imath::Box2i window = header.dataWindow();
  header.channels() = Imf::ChannelList();
  Imf::FrameBuffer frame;
  for (const ExrChannel& channel : image.channels) {
    header.channels().insert(channel.name, Imf::Channel(toImf(channel.type)));
    const size_t size = texelSize(channel.type);
    const size_t row = size * image.width;
    char* base = const_cast<char*>(reinterpret_cast<const char*>(channel.texels.data())) -
                 static_cast<std::ptrdiff_t>(window.min.x) * static_cast<std::ptrdiff_t>(size) -
                 static_cast<std::ptrdiff_t>(window.min.y) * static_cast<std::ptrdiff_t>(row);
    frame.insert(channel.name, Imf::Slice(toImf(channel.type), base, size, row));
  }
  MemoryStream stream;
  try {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame);
    file.writePixels(height);
  } catch (const std::exception& failure) {
    throw CaptureError(path.string(), "", std::string("cannot be encoded: ") + failure.what());
  }
  writeOutputFile(path, stream.bytes());
}

ExrChannel exrChannel(std::string name, ExrType type, std::span<const float> values,
                      size_t stride) {
  const size_t count = (values.size() + stride - 1) / stride;
  ExrChannel channel{std::move(name), type, std::vector<uint8_t>(count * texelSize(type))};
  for (size_t i = 0; i < count; ++i) {
    const float value = values[i * stride];
    if (type == ExrType::kHalf) {
      const uint16_t bits = half(value).bits();
      std::memcpy(&channel.texels[2 * i], &bits, 2);
    } else if (type == ExrType::kFloat) {
      std::memcpy(&channel.texels[4 * i], &value, 4);
    } else {
      const uint32_t whole = static_cast<uint32_t>(value);
      std::memcpy(&channel.texels[4 * i], &whole, 4);
    }
  }
  return channel;
}

}  // namespace reprise::lab
