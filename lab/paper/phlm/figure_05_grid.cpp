// SPDX-License-Identifier: MIT
//
// Figure 5: one and four samples a pixel, with mip levels and without; the paper shows pictures and
// claims that PHLM makes all of them steadier.
#include <fmt/format.h>

#include "lab/paper/crop.h"
#include "lab/paper/phlm/experiments.h"
#include "lab/paper/phlm/sequences.h"

namespace reprise::lab::phlm {
namespace {

constexpr uint32_t kInset_px = 56;

struct Strategy {
  TextureFilter filter;
  const char* name;
};

void gridOf(PaperLab& lab, const std::string& run, const std::vector<Strategy>& strategies,
            Outcome& outcome) {
  std::vector<std::vector<std::string>> cells;
  std::vector<std::pair<std::string, FloatImage>> insets;
  for (const Strategy& strategy : strategies) {
    for (const uint32_t samples : {1u, 4u}) {
      PaperView seen = view();
      seen.texture_filter = strategy.filter;
      seen.samples = samples;
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
      outcome.claim(run + ", " + what + ": PHLM's flicker over the input's", std::nullopt,
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
  outcome.table(run + ": input and PHLM",
                {"strategy", "input, dB", "PHLM, dB", "flicker of the input", "of PHLM",
                 "sharpness of the input", "of PHLM"},
                cells);
  outcome.gallery(run + ", where each input is worst", insets);
}

}  // namespace

void figure5(PaperLab& lab, Outcome& outcome) {
  gridOf(lab, openWorld().run,
         {{TextureFilter::kAniso16, "aniso16"}, {TextureFilter::kNone, "no mip levels"}}, outcome);
  gridOf(lab, spaceLand().run, {{TextureFilter::kAniso16, "procedural patterns"}}, outcome);
  outcome.note(
      "References see the textures through the same filter. The hangar has no textures, so that "
      "the filter is no switch there. The published figure is of the San Miguel model, which is "
      "not here; captures and glTF scenes are compared by `reprise compare`.");
}

}  // namespace reprise::lab::phlm
