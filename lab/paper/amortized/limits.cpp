// SPDX-License-Identifier: MIT
//
// Section 8, the limits that the paper states: highlights and shadow edges that move fast over the
// surface. Judged apart where the reference itself changed along the motion.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lab/metrics/display_space.h"
#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"
#include "lab/paper/changed_shading.h"
#include "lab/paper/crop.h"
#include "lab/paper/masked_error.h"

namespace reprise::lab::amortized {
namespace {

constexpr uint32_t kCrop_px = 72;

void changingShading(PaperLab& lab, const Subject& subject, Outcome& outcome) {
  const std::string ours = amortizedFor(lab, subject);
  PaperScene& scene = lab.scene(subject.moving);
  const uint32_t first = std::max(PaperLab::warmUp(scene.frames()), 1u);
  const auto counts = [&](uint32_t frame) { return frame >= first && scene.isJudged(frame); };
  for (const uint32_t frame : scene.judgedFrames()) {
    if (counts(frame)) scene.addReference(frame - 1);
  }
  std::map<uint32_t, PixelMask> changed;
  uint32_t shown = 0;
  FloatImage shown_ours;
  MaskedError ours_error;
  lab.filter(subject.moving, ours, [&](const FrameDone& done) {
    const uint32_t t = done.index;
    if (!counts(t)) return;
    changed[t] = changedShading(scene.reference(t), scene.reference(t - 1),
                                download(scene.device(), *done.inputs.motion),
                                addedEvaluations(scene.device(), done.inputs));
    const FloatImage display = displayImage(done.image);
    ours_error.add(changed[t], scene.reference(t), display);
    if (shown_ours.texels.empty() || pixelsInside(changed[t]) > pixelsInside(changed[shown])) {
      shown = t;
      shown_ours = display;
    }
  });
  const std::string& run = subject.moving;
  outcome.report(run + ": pixels whose shading changed", std::nullopt,
                 100.0 * ours_error.shareInside(), "%");
  if (ours_error.pixelsInside() == 0) {
    outcome.note(run + ": no shading changed that fast");
    return;
  }
  std::vector<std::pair<std::string, FloatImage>> pictures;
  std::vector<std::vector<std::string>> lines;
  const auto line = [&](const std::string& name, const MaskedError& error) {
    lines.push_back(
        {name, fmt::format("{:.2f}", error.insideDb()), fmt::format("{:.2f}", error.outsideDb())});
    outcome.report(run + ": there, " + name, std::nullopt, error.insideDb(), "dB");
    outcome.report(run + ": elsewhere, " + name, std::nullopt, error.outsideDb(), "dB");
  };
  line(ours, ours_error);
  pictures.emplace_back(ours, shown_ours);
  MaskedError ss4_error;
  for (const char* technique : {"none", "ss:n=4"}) {
    MaskedError error;
    lab.filter(run, technique, [&](const FrameDone& done) {
      if (!counts(done.index)) return;
      const FloatImage display = displayImage(done.image);
      error.add(changed[done.index], scene.reference(done.index), display);
      if (done.index == shown) pictures.emplace_back(technique, display);
    });
    line(technique, error);
    ss4_error = error;
  }
  outcome.table(run + ", dB", {"technique", "where shading changed", "elsewhere"}, lines);
  const double loss_db = ss4_error.insideDb() - ours_error.insideDb();
  outcome.claim(run + ": loss to 4x4 where shading changed", std::nullopt, loss_db, "dB",
                "above 0, the limit that the paper states", loss_db > 0.0);
  outcome.report(run + ": loss to 4x4 elsewhere", std::nullopt,
                 ss4_error.outsideDb() - ours_error.outsideDb(), "dB");
  const CropBox box = worstSquare(scene.reference(shown), shown_ours, kCrop_px);
  pictures.emplace_back("reference", scene.reference(shown));
  for (auto& [label, image] : pictures) image = crop(image, box);
  outcome.gallery(fmt::format("{}, frame {}, where it is farthest off", run, shown), pictures);
}

}  // namespace

void limits(PaperLab& lab, Outcome& outcome) {
  for (const Subject* subject : {&teapot(), &indoor()}) {
    if (sceneIsHere(subject->scene)) {
      changingShading(lab, *subject, outcome);
    } else {
      outcome.lacks("scene " + subject->scene);
    }
  }
}

}  // namespace reprise::lab::amortized
