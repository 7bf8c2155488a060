// SPDX-License-Identifier: MIT
#include "open_source.h"

#include <spdlog/spdlog.h>

#include "lab/capture/capture_source.h"
#include "lab/run/technique_choice.h"

namespace reprise::app {

void SceneFlags::addTo(CLI::App& verb, bool with_reference) {
  verb.add_option("--size", extent, "extent of scenes, WIDTHxHEIGHT in [1, 16384]")
      ->capture_default_str();
  verb.add_option("--frames", frames, "frames; of a capture, at most as many as it has")
      ->check(CLI::Range(1u, 1000000u))
      ->capture_default_str();
  verb.add_option("--fps", frame_rate, "frames a second of scenes")
      ->check(CLI::Range(0.001, 100000.0))
      ->capture_default_str();
  verb.add_option("--shade-by", shade_by,
                  "scenes: what shades, a compute pass, or the rasterizer's fragments (raster), "
                  "coarse ones where the device has VK_KHR_fragment_shading_rate")
      ->check(CLI::IsMember({"compute", "raster"}))
      ->capture_default_str();
  verb.add_flag(
      "--unjitter-textures", unjitter_textures,
      "scenes: textures are looked up at the pixel centre although visibility is jittered");
  verb.add_flag("--shading-only", shading_only,
                "scenes: visibility stays at the pixel centre, jitter and grid move the shading "
                "alone; compare with --reference-coverage centre");
  verb.add_option("--mip-bias", mip_bias, "scenes: levels added to what the technique asks for")
      ->check(CLI::Range(-8.0f, 8.0f))
      ->capture_default_str();
  verb.add_flag("--defer-lights", defer_lights,
                "scenes: lights of the deferred layer are kept from the technique, shaded in every "
                "frame at --late-positions of each pixel, and added to its result");
  verb.add_option("--late-positions", late_positions,
                  "scenes: at how many places of a pixel deferred lights are shaded")
      ->check(CLI::IsMember({1u, 4u}))
      ->capture_default_str();
  verb.add_option("--texture-filter", texture_filter,
                  "scenes: aniso16, trilinear, or none (no mip levels, bilinear)")
      ->check(CLI::IsMember({"aniso16", "trilinear", "none"}))
      ->capture_default_str();
  verb.add_option("--spp", samples_a_pixel,
                  "scenes: samples a pixel about the jitter, each with visibility and shading; the "
                  "technique gets their mean")
      ->check(CLI::IsMember({1u, 2u, 4u}))
      ->capture_default_str();
  verb.add_option("--lights", lamps,
                  "scenes: point and cone lights scattered over them (Forward+), instead of their "
                  "own number")
      ->check(CLI::Range(0u, lab::kMaxLamps));
  if (!with_reference) return;
  verb.add_option("--samples", reference_samples, "reference samples a pixel, even")
      ->check(CLI::Range(2u, 65536u))
      ->capture_default_str();
  verb.add_option("--reference-filter", reference_filter,
                  "box (1 px) or gaussian (0.4737 px, not truncated)")
      ->check(CLI::IsMember({"box", "gaussian"}))
      ->capture_default_str();
  verb.add_option("--reference-shutter", reference_shutter,
                  "frames that the reference's shutter is open: motion blur; 0: none")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb.add_option("--reference-coverage", reference_coverage,
                  "what a reference sample sees: what lies under it (pixel), or the surface at the "
                  "pixel's centre, shaded at the sample (centre)")
      ->check(CLI::IsMember({"pixel", "centre"}))
      ->capture_default_str();
  verb.add_option("--cache", cache,
                  "directory of rendered references, or none (default: $REPRISE_CACHE, "
                  "$XDG_CACHE_HOME/reprise, ~/.cache/reprise)");
}

lab::SceneSourceOptions SceneFlags::options() const {
  if (reference_samples % 2 != 0) throw lab::UsageError("--samples must be even");
  lab::SceneSourceOptions options;
  options.extent = parseExtent(extent);
  options.frames = frames;
  options.frame_rate = frame_rate;
  options.switches.shade_by = shade_by == "raster" ? lab::ShadeBy::kRaster : lab::ShadeBy::kCompute;
  options.switches.unjitter_textures = unjitter_textures;
  options.switches.mip_bias = mip_bias;
  options.switches.defer_lights = defer_lights;
  options.switches.late_positions = late_positions;
  options.switches.samples = samples_a_pixel;
  options.switches.texture_filter = texture_filter == "none"        ? lab::TextureFilter::kNone
                                    : texture_filter == "trilinear" ? lab::TextureFilter::kTrilinear
                                                                    : lab::TextureFilter::kAniso16;
  options.switches.shading_only = shading_only;
  options.switches.lamps = lamps;
  options.switches.view_extent = view_extent;
  options.reference.samples = reference_samples;
  options.reference.filter =
      reference_filter == "box" ? lab::ReferenceFilter::kBox : lab::ReferenceFilter::kGaussian;
  options.reference.shutter = reference_shutter;
  options.reference.coverage = reference_coverage == "pixel" ? lab::ReferenceCoverage::kPixel
                                                             : lab::ReferenceCoverage::kCentre;
  options.reference.cache = cache;
  return options;
}

std::unique_ptr<lab::FrameSource> openSource(lab::Device& device, const std::string& text,
                                             const SceneFlags& flags, lab::CaptureLayout layout) {
  std::unique_ptr<lab::FrameSource> source;
  if (lab::namesScene(text)) {
    auto scene =
        std::make_unique<lab::SceneSource>(device, lab::parseSceneRun(text), flags.options());
    for (const std::string& line : scene->renderer().scene().warnings()) {
      spdlog::warn("{}: {}", text, line);
    }
    scene->references().setWarning([](const std::string& line) { spdlog::warn("{}", line); });
    source = std::move(scene);
  } else {
    source = std::make_unique<lab::CaptureSource>(device, text, layout);
  }
  reportCapture(*source, false);
  return source;
}

void reportCapture(const lab::FrameSource& source, bool finished) {
  const auto* capture = dynamic_cast<const lab::CaptureSource*>(&source);
  if (capture == nullptr) return;
  if (!finished) {
    for (const std::string& warning : capture->warnings()) spdlog::warn("{}", warning);
    return;
  }
  const lab::Repairs& repairs = capture->repairs();
  if (repairs.total() == 0) return;
  spdlog::warn("{}: NaN or infinite pixels replaced: colour {}, depth {}, motion {}",
               capture->info().name, repairs.color, repairs.depth, repairs.motion);
}

}  // namespace reprise::app
