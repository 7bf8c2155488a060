// SPDX-License-Identifier: MIT
#include "lab/capture/description.h"

#include <fmt/format.h>

#include <cmath>

#include "lab/capture/strict_json.h"

namespace reprise::lab {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kAny = std::numeric_limits<double>::max();
constexpr double kTiny = std::numeric_limits<float>::min();
constexpr double kMaxExtent = 16384.0;

const std::vector<std::string> kDepthKinds{"planar", "ray", "device", "orthographic"};
const std::vector<std::string> kMotionUnits{"pixels", "uv", "ndc"};
const std::vector<std::string> kDirections{"to-previous", "from-previous"};
const std::vector<std::string> kMotionBackgrounds{"valid", "zero"};

MatrixRows readMatrix(StrictObject& object, const char* key) {
  const nlohmann::json& rows = object.member(key);
  MatrixRows matrix{};
  bool right = rows.is_array() && rows.size() == 4;
  for (size_t r = 0; right && r < 4; ++r) {
    right = rows[r].is_array() && rows[r].size() == 4;
    for (size_t c = 0; right && c < 4; ++c) {
      right = rows[r][c].is_number() && std::isfinite(rows[r][c].get<float>());
      if (right) matrix[4 * r + c] = rows[r][c].get<float>();
    }
  }
  if (!right) object.fail(key, "must be 4 rows of 4 numbers");
  return matrix;
}

// A symmetric pinhole from its vertical field of view in degrees.
MatrixRows projectionFromFov(double fov_y_deg, VkExtent2D extent) {
  const double scale = 1.0 / std::tan(0.5 * fov_y_deg * 0.017453292519943295);
  MatrixRows rows{};
  rows[0] = static_cast<float>(scale * extent.height / extent.width);
  rows[5] = static_cast<float>(scale);
  rows[14] = -1.0f;
  return rows;
}

CaptureCamera readCamera(StrictObject object, VkExtent2D extent) {
  CaptureCamera camera;
  camera.near_plane = static_cast<float>(object.number("near", kTiny, kAny));
  if (object.has("far")) {
    camera.far_plane = static_cast<float>(object.number("far", camera.near_plane, kAny));
  }
  if (object.has("view")) camera.view = readMatrix(object, "view");
  if (object.has("projection")) {
    camera.projection = readMatrix(object, "projection");
  } else if (object.has("fov_y_deg")) {
    camera.projection = projectionFromFov(object.number("fov_y_deg", 0.01, 179.0), extent);
  }
  object.has("fov_y_deg");
  object.finish();
  return camera;
}

CaptureFrameInfo readFrame(StrictObject object, VkExtent2D extent) {
  CaptureFrameInfo frame;
  frame.number = static_cast<uint32_t>(object.number("frame", 0.0, 99999999.0));
  const std::vector<double> jitter = object.numbers("jitter", 2);
  for (size_t axis = 0; axis < 2; ++axis) {
    if (!(std::abs(jitter[axis]) <= 1.0)) {
      object.fail("jitter", fmt::format("{} is outside [-1, 1] pixels (frame {})", jitter[axis],
                                        frame.number));
    }
    frame.jitter_px[axis] = static_cast<float>(jitter[axis]);
  }
  frame.reset = object.boolean("reset", false);
  frame.pre_exposure = static_cast<float>(object.number("pre_exposure", kTiny, kAny, 1.0));
  if (object.has("camera")) frame.camera = readCamera(object.object("camera"), extent);
  object.finish();
  return frame;
}

void readDepth(StrictObject object, CaptureDescription::Depth& depth) {
  depth.channel = object.text("channel");
  depth.kind = static_cast<CaptureDepth>(object.choice("kind", kDepthKinds, nullptr));
  depth.reversed = object.boolean("reversed", false);
  depth.infinite = object.boolean("infinite", false);
  if (object.has("background")) {
    depth.background = static_cast<float>(object.number("background", -kAny, kAny));
  }
  if ((depth.reversed || depth.infinite) && depth.kind != CaptureDepth::kDevice) {
    object.fail("kind", "reversed and infinite belong to the kind 'device'");
  }
  object.finish();
}

void readMotion(StrictObject object, CaptureDescription::Motion& motion) {
  const nlohmann::json& channels = object.member("channels");
  if (!channels.is_array() || channels.size() != 2 || !channels[0].is_string() ||
      !channels[1].is_string()) {
    object.fail("channels", "must be two channel names");
  }
  motion.channels = {channels[0].get<std::string>(), channels[1].get<std::string>()};
  if (object.has("scale")) {
    const std::vector<double> scale = object.numbers("scale", 2);
    motion.scale = {static_cast<float>(scale[0]), static_cast<float>(scale[1])};
    if (motion.scale[0] == 0.0f || motion.scale[1] == 0.0f) object.fail("scale", "must not be 0");
  }
  motion.unit = static_cast<MotionUnit>(object.choice("unit", kMotionUnits, "pixels"));
  motion.from_previous = object.choice("direction", kDirections, "to-previous") == 1;
  motion.includes_jitter = object.boolean("includes_jitter", false);
  motion.background_is_zero = object.choice("background", kMotionBackgrounds, "valid") == 1;
  object.finish();
}

void readColor(StrictObject object, CaptureDescription& description, float& pre_exposure) {
  description.color_layer = object.text("layer");
  const std::string space = object.text("space", "linear-rec709");
  if (space != "linear-rec709") {
    object.fail("space", "'" + space + "' is not linear-rec709: other spaces are not supported");
  }
  pre_exposure = static_cast<float>(object.number("pre_exposure", kTiny, kAny, 1.0));
  object.finish();
}

std::string readChannel(StrictObject object) {
  std::string channel = object.text("channel");
  object.finish();
  return channel;
}

void readReference(StrictObject object, CaptureDescription& description) {
  description.reference_samples = static_cast<uint32_t>(object.number("samples", 1.0, 1.0e9));
  description.reference_filter = object.text("filter", "box");
  object.number("width_px", 0.0, 64.0, 1.0);
  object.finish();
}

Json rowsOf(const MatrixRows& matrix) {
  Json rows = Json::array();
  for (size_t r = 0; r < 4; ++r) {
    rows.push_back({matrix[4 * r], matrix[4 * r + 1], matrix[4 * r + 2], matrix[4 * r + 3]});
  }
  return rows;
}

Json frameJson(const CaptureFrameInfo& frame) {
  Json json{{"frame", frame.number},
            {"jitter", {frame.jitter_px[0], frame.jitter_px[1]}},
            {"reset", frame.reset}};
  if (frame.pre_exposure != 1.0f) json["pre_exposure"] = frame.pre_exposure;
  if (frame.camera.has_value()) {
    Json& camera = json["camera"];
    camera["near"] = frame.camera->near_plane;
    if (std::isfinite(frame.camera->far_plane)) camera["far"] = frame.camera->far_plane;
    if (frame.camera->view.has_value()) camera["view"] = rowsOf(*frame.camera->view);
    if (frame.camera->projection.has_value()) {
      camera["projection"] = rowsOf(*frame.camera->projection);
    }
  }
  return json;
}

}  // namespace

RepriseDepthKind CaptureDescription::depthKind() const {
  switch (depth.kind) {
    case CaptureDepth::kDevice:
      if (depth.infinite) {
        return depth.reversed ? REPRISE_DEPTH_REVERSED_INFINITE : REPRISE_DEPTH_DEVICE_INFINITE;
      }
      return depth.reversed ? REPRISE_DEPTH_DEVICE_REVERSED : REPRISE_DEPTH_DEVICE;
    case CaptureDepth::kOrthographic:
      return REPRISE_DEPTH_ORTHOGRAPHIC;
    default:
      return REPRISE_DEPTH_PLANAR;
  }
}

std::string CaptureDescription::frameFile(size_t index) const {
  return fmt::format("{}{:0{}}.exr", file_prefix, frames[index].number, file_digits);
}
std::string CaptureDescription::referenceFile(size_t index) const {
  return fmt::format("reference_{:04}.exr", frames[index].number);
}

CaptureDescription parseDescription(const std::string& text, const std::string& file) {
  const nlohmann::json json = parseJson(text, file);
  StrictObject root(json, file, "");
  CaptureDescription description;
  root.number("version", 1.0, 1.0);
  description.generator = root.text("generator", "");
  const std::vector<double> extent = root.numbers("extent", 2);
  for (double side : extent) {
    if (!(side >= 1.0 && side <= kMaxExtent && side == std::floor(side))) {
      root.fail("extent", fmt::format("{} is not a whole number in [1, {}]", side, kMaxExtent));
    }
  }
  description.extent = {static_cast<uint32_t>(extent[0]), static_cast<uint32_t>(extent[1])};
  description.frame_rate = root.number("frame_rate", 0.001, 100000.0, 60.0);
  float pre_exposure = 1.0f;
  readColor(root.object("color"), description, pre_exposure);
  readDepth(root.object("depth"), description.depth);
  readMotion(root.object("motion"), description.motion);
  if (root.has("reactive")) description.reactive_channel = readChannel(root.object("reactive"));
  if (root.has("id")) description.id_channel = readChannel(root.object("id"));
  if (root.has("reference")) readReference(root.object("reference"), description);
  description.plan = root.text("plan", "");
  // For people; nothing reads them.
  for (const char* note : {"description", "jitter", "samples_per_pixel"}) root.has(note);

  const nlohmann::json& frames = root.member("frames");
  if (!frames.is_array() || frames.empty()) root.fail("frames", "must list at least one frame");
  for (size_t i = 0; i < frames.size(); ++i) {
    description.frames.push_back(
        readFrame(StrictObject(frames[i], file, fmt::format("frames[{}]", i)), description.extent));
    CaptureFrameInfo& frame = description.frames.back();
    frame.pre_exposure *= pre_exposure;
    if (i > 0 && frame.number <= description.frames[i - 1].number) {
      root.fail("frames", fmt::format("numbers must rise: {} comes after {}", frame.number,
                                      description.frames[i - 1].number));
    }
  }
  root.finish();
  return description;
}

std::string descriptionText(const CaptureDescription& d) {
  Json json;
  json["version"] = 1;
  json["generator"] = d.generator;
  json["extent"] = {d.extent.width, d.extent.height};
  json["frame_rate"] = d.frame_rate;
  json["color"] = {{"layer", d.color_layer}, {"space", "linear-rec709"}};
  json["depth"] = {{"channel", d.depth.channel},
                   {"kind", kDepthKinds[static_cast<size_t>(d.depth.kind)]}};
  if (d.depth.kind == CaptureDepth::kDevice) {
    json["depth"]["reversed"] = d.depth.reversed;
    json["depth"]["infinite"] = d.depth.infinite;
  }
  if (d.depth.background.has_value()) json["depth"]["background"] = *d.depth.background;
  json["motion"] = {{"channels", d.motion.channels},
                    {"scale", d.motion.scale},
                    {"unit", kMotionUnits[static_cast<size_t>(d.motion.unit)]},
                    {"direction", kDirections[d.motion.from_previous ? 1 : 0]},
                    {"includes_jitter", d.motion.includes_jitter},
                    {"background", kMotionBackgrounds[d.motion.background_is_zero ? 1 : 0]}};
  json["jitter"] = {{"unit", "pixels"},
                    {"meaning", "pixel (x, y) samples (x + 0.5 - jx, y + 0.5 - jy), y down"}};
  if (!d.reactive_channel.empty()) json["reactive"] = {{"channel", d.reactive_channel}};
  if (!d.id_channel.empty()) json["id"] = {{"channel", d.id_channel}};
  if (d.reference_samples > 0) {
    json["reference"] = {{"samples", d.reference_samples}, {"filter", d.reference_filter}};
  }
  if (!d.plan.empty()) json["plan"] = d.plan;
  json["frames"] = Json::array();
  for (const CaptureFrameInfo& frame : d.frames) json["frames"].push_back(frameJson(frame));
  return json.dump(1) + "\n";
}

std::optional<RepriseCamera> libraryCamera(const CaptureCamera& camera) {
  if (!camera.view.has_value() || !camera.projection.has_value()) return std::nullopt;
  RepriseCamera columns{};
  for (size_t r = 0; r < 4; ++r) {
    const float sign = r == 1 ? -1.0f : 1.0f;  // y up to y down
    for (size_t c = 0; c < 4; ++c) {
      columns.view[4 * c + r] = (*camera.view)[4 * r + c];
      columns.projection[4 * c + r] = sign * (*camera.projection)[4 * r + c];
    }
  }
  return columns;
}

CaptureCamera captureCamera(const RepriseCamera& camera, float near_plane, float far_plane) {
  CaptureCamera rows{near_plane, far_plane, MatrixRows{}, MatrixRows{}};
  for (size_t r = 0; r < 4; ++r) {
    const float sign = r == 1 ? -1.0f : 1.0f;
    for (size_t c = 0; c < 4; ++c) {
      (*rows.view)[4 * r + c] = camera.view[4 * c + r];
      (*rows.projection)[4 * r + c] = sign * camera.projection[4 * c + r];
    }
  }
  return rows;
}

}  // namespace reprise::lab
