// SPDX-License-Identifier: MIT
//
// Figure 9: more evaluations where reprojection fails. How many, where, and what they are worth.
#include <fmt/format.h>

#include <map>

#include "lab/metrics/display_space.h"
#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"
#include "lab/paper/crop.h"
#include "lab/paper/masked_error.h"

namespace reprise::lab::amortized {
namespace {

constexpr uint32_t kCrop_px = 96;

// Shades of red, as the paper has them; where nothing was added the image, dark.
FloatImage mapImage(const PixelMask& added, const FloatImage& shown) {
  FloatImage image = shown;
  for (size_t i = 0; i < added.size(); ++i) {
    float* rgb = &image.texels[3 * i];
    for (size_t c = 0; c < 3; ++c) rgb[c] *= 0.35f;
    if (added[i] == 0) continue;
    rgb[0] = 0.4f + 0.15f * static_cast<float>(added[i]);
    rgb[1] = rgb[2] = 0.1f;
  }
  return image;
}

void adaptive(PaperLab& lab, const Subject& subject, Outcome& outcome) {
  const PaperView view = subject.view();
  PaperScene& scene = lab.scene(subject.moving, view);
  const uint32_t first = PaperLab::warmUp(scene.frames());
  const auto counts = [&](uint32_t frame) { return frame >= first && scene.isJudged(frame); };
  std::map<uint32_t, PixelMask> added;  // evaluations beyond the first, by frame
  MaskedError adaptive_error;
  MaskedError single_error;
  double evaluations = 0.0;
  uint32_t shown = 0;
  FloatImage shown_adaptive;
  FloatImage shown_single;
  lab.filter(
      subject.moving, amortizedWith(0.0),
      [&](const FrameDone& done) {
        if (!counts(done.index)) return;
        const PixelMask& here = added[done.index] = addedEvaluations(scene.device(), done.inputs);
        const FloatImage display = displayImage(done.image);
        adaptive_error.add(here, scene.reference(done.index), display);
        for (const uint8_t n : here) evaluations += n;
        if (shown_adaptive.texels.empty() || pixelsInside(here) > pixelsInside(added[shown])) {
          shown = done.index;
          shown_adaptive = display;
        }
      },
      view);
  lab.filter(
      subject.moving, amortizedWith(0.0) + ",requests=false",
      [&](const FrameDone& done) {
        if (!counts(done.index)) return;
        const FloatImage display = displayImage(done.image);
        single_error.add(added[done.index], scene.reference(done.index), display);
        if (done.index == shown) shown_single = display;
      },
      view);
  const std::string& run = subject.moving;
  const double pixels =
      static_cast<double>(shown_adaptive.texelCount()) * static_cast<double>(added.size());
  outcome.report(run + ": pixels whose reprojection fails", std::nullopt,
                 100.0 * adaptive_error.shareInside(), "%");
  outcome.report(run + ": evaluations a pixel", std::nullopt, 1.0 + evaluations / pixels, "");
  if (adaptive_error.pixelsInside() == 0) {
    outcome.note(run + ": no reprojection failed");
    return;
  }
  outcome.report(run + ": those pixels with one evaluation", std::nullopt, single_error.insideDb(),
                 "dB");
  outcome.claim(run + ": those pixels with adaptive evaluation", std::nullopt,
                adaptive_error.insideDb(), "dB", "above one evaluation",
                adaptive_error.insideDb() > single_error.insideDb());
  // Where the two differ most.
  const FloatImage map = mapImage(added[shown], shown_adaptive);
  const CropBox box = worstSquare(shown_adaptive, shown_single, kCrop_px);
  outcome.gallery(fmt::format("{}, frame {}", run, shown),
                  {{"added evaluations", crop(map, box)},
                   {"one evaluation", crop(shown_single, box)},
                   {"adaptive", crop(shown_adaptive, box)},
                   {"reference", crop(scene.reference(shown), box)}});
  outcome.gallery(run + ", added evaluations of the whole frame", {{"added evaluations", map}});
}

}  // namespace

void figure9(PaperLab& lab, Outcome& outcome) {
  for (const Subject* subject : {&horse(), &indoor()}) {
    if (sceneIsHere(subject->scene)) {
      adaptive(lab, *subject, outcome);
    } else {
      outcome.lacks("scene " + subject->scene);
    }
  }
  // Nothing is hidden in the brick scene: content enters at the border alone.
  adaptive(lab, brick(), outcome);
}

}  // namespace reprise::lab::amortized
