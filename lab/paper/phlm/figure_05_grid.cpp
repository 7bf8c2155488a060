// SPDX-License-Identifier: MIT
//
// Figure 5: one and four samples a pixel, with mip levels and without; the paper shows pictures and
// claims that PHLM makes all of them steadier.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "lab/paper/crop.h"
#include "lab/paper/phlm/experiments.h"
#include "lab/paper/phlm/sequences.h"

namespace reprise::lab::phlm {
namespace {

constexpr uint32_t kInset_px = 56;
constexpr VkExtent2D kPublishedExtent{1024, 576};

struct Strategy {
  TextureFilter filter;
  const char* name;
};
const std::vector<Strategy>& strategies() {
  static const std::vector<Strategy> list = {{TextureFilter::kAniso16, "aniso16"},
                                             {TextureFilter::kNone, "no mip levels"}};
  return list;
}

// A model in the user's folder of data, in the place of San Miguel.
struct Model {
  const char* name;
  const char* file;
};
constexpr Model kModels[] = {{"vegetation", "vegetation/vegetation.gltf"},
                             {"bistro", "bistro/bistro.gltf"}};

std::string pathThrough(const Model& model) {
  const char* root = std::getenv("REPRISE_DATA");
  if (root == nullptr) return {};
  const std::filesystem::path file = std::filesystem::path(root) / model.file;
  return std::filesystem::exists(file) ? fmt::format("gltf:{}/path", file.string()) : "";
}

void gridOf(PaperLab& lab, const std::string& name, const std::string& run,
            const std::vector<Strategy>& filters, Outcome& outcome) {
  std::vector<std::vector<std::string>> cells;
  std::vector<std::pair<std::string, FloatImage>> insets;
  for (const Strategy& strategy : filters) {
    for (const uint32_t samples : {1u, 4u}) {
      PaperView seen = view();
      seen.texture_filter = strategy.filter;
      seen.samples = samples;
      seen.published_extent = kPublishedExtent;
      const Measured& input = lab.measure(run, "none", seen);
      const Measured& ours = lab.measure(run, "phlm", seen);
      const std::string what =
          fmt::format("{}, {} sample{} a pixel", strategy.name, samples, samples > 1 ? "s" : "");
      cells.push_back({what, fmt::format("{:.2f}", psnrOf(lab, run, "none", seen)),
                       fmt::format("{:.2f}", psnrOf(lab, run, "phlm", seen)),
                       fmt::format("{:.4f}", input.over_time.flicker),
                       fmt::format("{:.4f}", ours.over_time.flicker),
                       fmt::format("{:.3f}", input.over_time.sharpness),
                       fmt::format("{:.3f}", ours.over_time.sharpness)});
      outcome.claim(name + ", " + what + ": PHLM's flicker over the input's", std::nullopt,
                    ours.over_time.flicker / input.over_time.flicker, "times", "steadier",
                    ours.over_time.flicker < input.over_time.flicker);
      PaperScene& scene = lab.scene(run, seen);
      const FloatImage& reference = scene.reference(scene.frames() - 1);
      const CropBox box = worstSquare(reference, input.last, kInset_px);
      insets.emplace_back(what + ", input", crop(input.last, box));
      insets.emplace_back(what + ", PHLM", crop(ours.last, box));
      insets.emplace_back(what + ", reference", crop(reference, box));
    }
  }
  outcome.table(name + ": input and PHLM",
                {"strategy", "input, dB", "PHLM, dB", "flicker of the input", "of PHLM",
                 "sharpness of the input", "of PHLM"},
                cells);
  outcome.gallery(name + ", where each input is worst", insets);
}

}  // namespace

void figure5(PaperLab& lab, Outcome& outcome) {
  gridOf(lab, openWorld().run, openWorld().run, strategies(), outcome);
  gridOf(lab, spaceLand().run, spaceLand().run, {{TextureFilter::kAniso16, "procedural patterns"}},
         outcome);
  for (const Model& model : kModels) {
    const std::string run = pathThrough(model);
    if (run.empty()) {
      outcome.note(
          fmt::format("{}: left out, REPRISE_DATA leads to no {}.", model.name, model.file));
    } else if (!lab.scale().whole) {
      outcome.note(fmt::format("{}: left out of a reduced run for time.", model.name));
    } else {
      gridOf(lab, model.name, run, strategies(), outcome);
    }
  }
  outcome.note(fmt::format(
      "References see the textures through the same filter. The hangar has no textures, so that "
      "the filter is no switch there. The published figure is of the San Miguel model, {} x {}, "
      "which is not here.",
      kPublishedExtent.width, kPublishedExtent.height));
}

}  // namespace reprise::lab::phlm
