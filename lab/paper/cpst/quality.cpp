// SPDX-License-Identifier: MIT
//
// CPS, CBR and CPS-T against PS with TAA, the paper's ground truth, and against the reference; thin
// geometry, where checkerboard's holes show, apart from the rest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/metrics/psnr.h"
#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"
#include "lab/paper/masked_error.h"

namespace reprise::lab::cpst {
namespace {

// What is asked: on Sponza in motion CPS-T may lose this much to checkerboard, and is this far
// above CPS.
constexpr double kMostLoss_db = 0.3;
constexpr double kFarAbove_db = 1.0;
// A surface is thin where, within this many pixels on both sides, what is seen is farther by more
// than a share of its depth.
constexpr int kThin_px = 3;
constexpr float kBehind = 0.05f;
// Below this share of pixels there is no thin geometry to speak of.
constexpr double kLeastThin = 0.005;

// Thin surfaces and the pixels beside them, where they are antialiased.
PixelMask thinGeometry(const FloatImage& view_depth) {
  const auto width = static_cast<int>(view_depth.width);
  const auto height = static_cast<int>(view_depth.height);
  const auto at = [&](int x, int y) {
    return *view_depth.at(static_cast<uint32_t>(std::clamp(x, 0, width - 1)),
                          static_cast<uint32_t>(std::clamp(y, 0, height - 1)));
  };
  PixelMask mask(view_depth.texelCount());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float behind = at(x, y) * (1.0f + kBehind);
      bool thin = false;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
        bool before = false;
        bool after = false;
        for (int i = 1; i <= kThin_px; ++i) {
          before = before || at(x - i * dx, y - i * dy) > behind;
          after = after || at(x + i * dx, y + i * dy) > behind;
        }
        thin = thin || (before && after);
      }
      if (!thin) continue;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
          mask[static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(u)] = 1;
        }
      }
    }
  }
  return mask;
}

struct Judgement {
  double psnr_db = 0.0;        // against the reference, mean over the frames that count
  double against_ps_db = 0.0;  // last frame
  double thin_db = 0.0;        // last frame, against the reference
  double rest_db = 0.0;
  double evaluations = 0.0;
};

void qualityOf(PaperLab& lab, const std::string& name, const std::string& run, bool asked,
               Outcome& outcome) {
  PaperScene& scene = lab.scene(run, view());
  const uint32_t last = scene.frames() - 1;
  const PixelMask thin = thinGeometry(scene.source().geometry(last).view_depth);
  std::vector<Judgement> judgements;
  std::vector<std::vector<std::string>> lines;
  double thin_share = 0.0;
  for (const Contender& contender : judged()) {
    const Measured& measured = lab.measure(run, contender.technique, view());
    MaskedError error;
    error.add(thin, lab.scene(run, view()).reference(last), measured.last);
    thin_share = error.shareInside();
    const FloatImage& ps = lab.measure(run, kPs, view()).last;
    const Judgement j{measured.meanPsnr(PaperLab::warmUp(lab.scale().frames)),
                      psnrDb(meanSquaredError(ps, measured.last)), error.insideDb(),
                      error.outsideDb(), measured.evaluations_per_pixel};
    judgements.push_back(j);
    outcome.report(fmt::format("{}, {}", name, contender.name), std::nullopt, j.psnr_db, "dB");
    const bool itself = contender.technique == kPs;
    lines.push_back({contender.name, fmt::format("{:.2f}", j.psnr_db),
                     itself ? std::string("-") : fmt::format("{:.2f}", j.against_ps_db),
                     fmt::format("{:.2f}", j.thin_db), fmt::format("{:.2f}", j.rest_db),
                     fmt::format("{:.3f}", j.evaluations)});
  }
  outcome.table(
      fmt::format("{} ({}); thin geometry: {:.1f} % of the pixels", name, run, 100.0 * thin_share),
      {"", "PSNR, dB", "against PS, last frame, dB", "thin geometry, last frame, dB",
       "elsewhere, last frame, dB", "evaluations a pixel"},
      lines);
  const Judgement& cps = judgements[1];
  const Judgement& cbr = judgements[2];
  const Judgement& ours = judgements[3];
  const double over_cbr_db = ours.psnr_db - cbr.psnr_db;
  const double over_cps_db = ours.psnr_db - cps.psnr_db;
  if (asked) {
    outcome.claim(name + ", CPS-T over CBR", std::nullopt, over_cbr_db, "dB",
                  fmt::format("not below -{}", kMostLoss_db), over_cbr_db >= -kMostLoss_db);
  } else {
    outcome.report(name + ", CPS-T over CBR", std::nullopt, over_cbr_db, "dB");
  }
  outcome.claim(name + ", CPS-T over CPS", std::nullopt, over_cps_db, "dB",
                fmt::format("far above: {} dB", kFarAbove_db), over_cps_db >= kFarAbove_db);
  if (thin_share >= kLeastThin) {
    const double thin_db = ours.thin_db - cbr.thin_db;
    outcome.claim(name + ", thin geometry, CPS-T over CBR", std::nullopt, thin_db, "dB", "above",
                  thin_db > 0.0);
  }
}

}  // namespace

void quality(PaperLab& lab, Outcome& outcome) {
  for (const Subject& subject : subjects()) {
    if (!subject.note.empty()) outcome.note(subject.note);
    qualityOf(lab, subject.name, subject.run, &subject == &sponza(), outcome);
  }
  for (const std::string scene : {"lights/dolly", "foliage/walk", "indoor/fly", "horse/gallop"}) {
    // Where it stands for a model it was judged above.
    const bool known = std::any_of(subjects().begin(), subjects().end(),
                                   [&](const Subject& subject) { return subject.run == scene; });
    if (!known) qualityOf(lab, scene.substr(0, scene.find('/')), scene, false, outcome);
  }
  outcome.note(
      "Sun alone on the models. dB against the reference: mean over the judged frames that count. "
      "Thin: surfaces with something farther within 3 px on both sides, and the pixels beside "
      "them. The published comparison is of pictures and names no figures.");
}

}  // namespace reprise::lab::cpst
