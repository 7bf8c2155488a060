// SPDX-License-Identifier: MIT
//
// Figures 5 and 6: what each part of the method is worth. Figure 5: the scale of the variance that
// bounds history, and silhouettes; figure 6: jitter and shading filter.
#include <fmt/format.h>

#include <map>

#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"
#include "lab/paper/crop.h"

namespace reprise::lab::cpst {
namespace {

constexpr uint32_t kCrop_px = 56;

struct Variant {
  std::string name;
  std::string technique;
};

void measureAll(PaperLab& lab, const std::string& run, const std::vector<Variant>& variants,
                const PaperView& seen) {
  std::vector<std::string> techniques;
  for (const Variant& variant : variants) techniques.push_back(variant.technique);
  lab.measureTogether(run, techniques, seen);
}

double psnrOf(PaperLab& lab, const std::string& run, const Variant& variant,
              const PaperView& seen) {
  return lab.measure(run, variant.technique, seen).meanPsnr(PaperLab::warmUp(lab.scale().frames));
}

// Where the last two of the variants differ most.
void galleryOf(PaperLab& lab, const std::string& run, const std::vector<Variant>& variants,
               const PaperView& seen, Outcome& outcome) {
  const FloatImage reference = [&] {
    PaperScene& scene = lab.scene(run, seen);
    return scene.reference(scene.frames() - 1);
  }();
  const CropBox box = worstSquare(lab.measure(run, variants.front().technique, seen).last,
                                  lab.measure(run, variants.back().technique, seen).last, kCrop_px);
  std::vector<std::pair<std::string, FloatImage>> crops;
  for (const Variant& variant : variants) {
    crops.emplace_back(variant.name, crop(lab.measure(run, variant.technique, seen).last, box));
  }
  crops.emplace_back("reference", crop(reference, box));
  outcome.gallery(fmt::format("{}, last frame, where \"{}\" and \"{}\" differ most", run,
                              variants.front().name, variants.back().name),
                  crops);
}

}  // namespace

void figure5(PaperLab& lab, Outcome& outcome) {
  PaperView seen = view();
  seen.over_time = true;
  const std::string run = "horse/gallop";
  // With the paper's own test, which leaves ghosts to the bound; and as we run it.
  for (const std::string of : {"preset=paper,", ""}) {
    const std::string base = "cpst:" + of;
    const std::string named = of.empty() ? "ours" : "as published";
    const std::vector<Variant> variants = {{"dynamic", base + "variance=dynamic"},
                                           {"LoD 0", base + "variance=fine"},
                                           {"no silhouettes", base + "silhouette=2"},
                                           {"no bound", base + "variance=none"},
                                           {"LoD 2", base + "variance=coarse"}};
    measureAll(lab, run, variants, seen);
    std::vector<std::vector<std::string>> lines;
    std::map<std::string, OverTime> figures;
    for (const Variant& variant : variants) {
      const OverTime& o = lab.measure(run, variant.technique, seen).over_time;
      figures[variant.name] = o;
      lines.push_back({variant.name, fmt::format("{:.2f}", psnrOf(lab, run, variant, seen)),
                       fmt::format("{:.2f}", o.tpsnr_db), fmt::format("{:.4f}", o.flicker),
                       fmt::format("{:.2f}", o.disoccluded_db)});
    }
    outcome.table(run + ", " + named,
                  {"variance", "PSNR, dB", "tPSNR, dB", "flicker", "disoccluded, dB"}, lines);
    const double ghosts_db = figures["dynamic"].disoccluded_db - figures["LoD 2"].disoccluded_db;
    outcome.claim(named + ": dynamic over LoD 2, disoccluded", std::nullopt, ghosts_db, "dB",
                  "less ghosting", ghosts_db > 0.0);
    const double flicker = figures["dynamic"].flicker / figures["LoD 0"].flicker;
    outcome.claim(named + ": dynamic over LoD 0, flicker", std::nullopt, flicker, "times",
                  "steadier", flicker < 1.0);
    galleryOf(lab, run, variants, seen, outcome);
  }
  outcome.note("The published figure is a picture of ghosting without figures.");
}

void figure6(PaperLab& lab, Outcome& outcome) {
  if (!sponza().note.empty()) outcome.note(sponza().note);
  const std::vector<Variant> variants = {
      {"ours: 2x Halton, filter", "cpst"},
      {"void and cluster, filter", "cpst:jitter=void-and-cluster"},
      {"void and cluster, no filter", "cpst:jitter=void-and-cluster,shading_filter=false"},
      {"Halton, filter", "cpst:jitter=halton"},
      {"Halton, no filter", "cpst:jitter=halton,shading_filter=false"}};
  for (const std::string& run : {sponza().run, std::string("brick/still")}) {
    const std::string name = run == sponza().run ? sponza().name : "brick still";
    measureAll(lab, run, variants, view());
    std::vector<std::vector<std::string>> lines;
    std::map<std::string, double> psnr_db;
    for (const Variant& variant : variants) {
      psnr_db[variant.name] = psnrOf(lab, run, variant, view());
      lines.push_back({variant.name, fmt::format("{:.2f}", psnr_db[variant.name])});
    }
    outcome.table(run, {"jitter and shading filter", "PSNR, dB"}, lines);
    const double better_db = psnr_db["void and cluster, filter"] - psnr_db["Halton, no filter"];
    outcome.claim(name + ": void and cluster with filter over Halton without", std::nullopt,
                  better_db, "dB", "better", better_db > 0.0);
    const double jitter_db =
        psnr_db["void and cluster, filter"] - psnr_db["ours: 2x Halton, filter"];
    outcome.report(name + ": void and cluster over 2x Halton", std::nullopt, jitter_db, "dB");
    galleryOf(lab, run, variants, view(), outcome);
  }
  outcome.note("The published figure is a picture of undersampled shading without figures.");
}

}  // namespace reprise::lab::cpst
