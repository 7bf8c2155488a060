// SPDX-License-Identifier: MIT
#include "lab/capture/layouts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "lab/capture/capture_error.h"
#include "lab/capture/exr_file.h"

namespace reprise::lab {
namespace {

// What Blender writes where nothing is covered (Cycles and Eevee, "Z" pass).
constexpr float kBlenderBackground = 1.0e10f;

struct NumberedFile {
  std::string prefix;
  int digits = 0;
  uint32_t number = 0;
};

// "room_0020.exr" -> {"room_", 4, 20}.
std::optional<NumberedFile> numbered(const std::filesystem::path& path) {
  if (path.extension() != ".exr") return std::nullopt;
  const std::string stem = path.stem().string();
  size_t begin = stem.size();
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(stem[begin - 1])) != 0) --begin;
  const size_t digits = stem.size() - begin;
  if (digits == 0 || digits > 8) return std::nullopt;
  return NumberedFile{stem.substr(0, begin), static_cast<int>(digits),
                      static_cast<uint32_t>(std::stoul(stem.substr(begin)))};
}

void findFrames(const std::filesystem::path& directory, CaptureDescription& description) {
  std::error_code error;
  std::map<std::string, std::vector<NumberedFile>> sequences;
  for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
    const std::optional<NumberedFile> file = numbered(entry.path());
    if (file.has_value() && file->prefix != "reference_") sequences[file->prefix].push_back(*file);
  }
  if (error) throw CaptureError(directory.string(), "", "cannot be read: " + error.message());
  if (sequences.empty()) {
    throw CaptureError(directory.string(), "",
                       "holds no capture.json and no numbered EXR files (NAME0001.exr ...)");
  }
  if (sequences.size() > 1) {
    throw CaptureError(
        directory.string(), "",
        fmt::format("holds {} sequences ('{}' and '{}'): give one a directory", sequences.size(),
                    sequences.begin()->first, std::next(sequences.begin())->first));
  }
  auto& [prefix, files] = *sequences.begin();
  std::sort(files.begin(), files.end(),
            [](const NumberedFile& a, const NumberedFile& b) { return a.number < b.number; });
  description.file_prefix = prefix;
  description.file_digits = files.front().digits;
  for (uint32_t number = files.front().number; number <= files.back().number; ++number) {
    description.frames.push_back({.number = number});
  }
  description.frames.front().reset = true;
}

// The layer whose channel LAYER + suffix exists; nullopt without one.
std::optional<std::string> layerWith(const ExrImage& image, const std::string& suffix) {
  for (const ExrChannel& channel : image.channels) {
    if (channel.name.ends_with(suffix)) {
      return channel.name.substr(0, channel.name.size() - suffix.size());
    }
  }
  return std::nullopt;
}

// The first of `names` that the file has.
std::string oneOf(const ExrImage& image, const std::string& file, const char* what,
                  const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (image.find(name) != nullptr) return name;
  }
  throw CaptureError(file, what,
                     fmt::format("no such channel (looked for {})", fmt::join(names, ", ")));
}

void describeBlender(const ExrImage& image, const std::string& file, DetectedCapture& detected) {
  CaptureDescription& d = detected.description;
  const std::optional<std::string> layer = layerWith(image, ".Combined.R");
  if (!layer.has_value()) {
    throw CaptureError(file, "color", "no channel *.Combined.R: is this Blender's multilayer EXR?");
  }
  d.generator = "Blender";
  d.color_layer = *layer + ".Combined";
  d.depth.channel = oneOf(image, file, "depth", {*layer + ".Depth.Z"});
  d.depth.kind = CaptureDepth::kPlanar;
  d.depth.background = kBlenderBackground;
  d.motion.channels = {oneOf(image, file, "motion", {*layer + ".Vector.X"}),
                       oneOf(image, file, "motion", {*layer + ".Vector.Y"})};
  d.motion.scale = {1.0f, -1.0f};
  d.motion.background_is_zero = true;
  const std::string id = *layer + ".IndexOB.X";
  if (image.find(id) != nullptr) d.id_channel = id;
  detected.assumptions = {
      "Blender: depth is planar, motion goes to the previous frame in pixels with y up",
      "jitter is not known and taken as 0: without jittered samples still edges stay aliased",
      "cameras are not known: motion of the background is taken as 0"};
}

void describeEngine(const std::filesystem::path& path, const ExrImage& image,
                    DetectedCapture& detected) {
  CaptureDescription& d = detected.description;
  const std::string file = path.string();
  const std::string red = oneOf(image, file, "color", {"color.R", "Color.R", "R"});
  d.color_layer = red == "R" ? "" : red.substr(0, red.size() - 2);
  d.depth.channel = oneOf(image, file, "depth",
                          {"depth.Z", "Depth.Z", "Z", "depth.R", "depth.Y", "depth", "Depth"});
  const std::string x =
      oneOf(image, file, "motion",
            {"motion.X", "Motion.X", "velocity.X", "motion.R", "velocity.R", "motion.U"});
  const std::string layer = x.substr(0, x.size() - 1);
  const char other = x.back() == 'X' ? 'Y' : x.back() == 'R' ? 'G' : 'V';
  d.motion.channels = {x, oneOf(image, file, "motion", {layer + other})};
  if (image.find("reactive.R") != nullptr) d.reactive_channel = "reactive.R";
  if (image.find("id.X") != nullptr) d.id_channel = "id.X";

  const std::vector<float> depth = readExr(path).find(d.depth.channel)->floats();
  const bool device =
      std::all_of(depth.begin(), depth.end(), [](float z) { return z >= 0.0f && z <= 1.0f; });
  if (device) {
    d.depth.kind = CaptureDepth::kDevice;
    d.depth.reversed = true;
    d.depth.infinite = true;
  }
  detected.assumptions = {
      device
          ? "depth lies in [0, 1]: taken as device depth, reversed, far plane at infinity, near 0.1"
          : "depth exceeds 1: taken as planar view depth",
      "motion is taken as pixels to the previous frame, y down, without jitter",
      "jitter is not known and taken as 0: without jittered samples still edges stay aliased"};
}

}  // namespace

const std::vector<std::string> kCaptureLayouts{"auto", "blender", "engine"};

DetectedCapture detectCapture(const std::filesystem::path& directory, CaptureLayout layout) {
  DetectedCapture detected;
  CaptureDescription& d = detected.description;
  findFrames(directory, d);
  const std::filesystem::path first = directory / d.frameFile(0);
  const ExrImage image = readExrHeader(first);
  d.extent = {image.width, image.height};
  d.frame_rate = 24.0;
  const bool blender = layout == CaptureLayout::kBlender ||
                       (layout == CaptureLayout::kAuto && layerWith(image, ".Combined.R"));
  if (blender) {
    describeBlender(image, first.string(), detected);
  } else {
    describeEngine(first, image, detected);
  }
  return detected;
}

}  // namespace reprise::lab
