// SPDX-License-Identifier: MIT
//
// Figure 6: reflections that move over the ship's hull, which no motion vector follows.
#include <fmt/format.h>

#include <algorithm>

#include "lab/metrics/psnr.h"
#include "lab/paper/crop.h"
#include "lab/paper/phlm/experiments.h"
#include "lab/paper/phlm/sequences.h"

namespace reprise::lab::phlm {
namespace {

// Where the camera of hangar/fly has the middle of the hull: of the picture's width and height.
constexpr float kHull_of_width = 0.36f;
constexpr float kHull_of_height = 0.42f;
constexpr float kHull_width = 0.24f;
constexpr float kHull_height = 0.22f;

}  // namespace

void figure6(PaperLab& lab, Outcome& outcome) {
  const Sequence& sequence = spaceLand();
  PaperScene& scene = lab.scene(sequence.run, view());
  const FloatImage& reference = scene.reference(scene.frames() - 1);
  const auto width = static_cast<float>(reference.width);
  const auto height = static_cast<float>(reference.height);
  const CropBox hull{static_cast<uint32_t>(kHull_of_width * width),
                     static_cast<uint32_t>(kHull_of_height * height),
                     std::max(static_cast<uint32_t>(kHull_width * width), 1u),
                     std::max(static_cast<uint32_t>(kHull_height * height), 1u)};
  const FloatImage truth = crop(reference, hull);
  std::vector<std::pair<std::string, FloatImage>> crops;
  double input_db = 0.0;
  double ours_db = 0.0;
  for (const Contender& contender : contenders()) {
    FloatImage part = crop(lab.measure(sequence.run, contender.technique, view()).last, hull);
    const double db = psnrDb(meanSquaredError(truth, part));
    outcome.report("hull, last frame, " + contender.name, std::nullopt, db, "dB");
    if (contender.technique == "none") input_db = db;
    if (contender.technique == "phlm") ours_db = db;
    crops.emplace_back(fmt::format("{}: {:.2f} dB", contender.name, db), std::move(part));
  }
  crops.emplace_back("reference", truth);
  outcome.gallery("the hull in the last frame; dB of what is shown", crops);
  outcome.claim("hull, PHLM over the input", std::nullopt, ours_db - input_db, "dB",
                "closer to the reference", ours_db > input_db);
}

}  // namespace reprise::lab::phlm
