// SPDX-License-Identifier: MIT
//
// Figures 2 and 4: where a cycle of frames shades and sees, and the power spectra of both sets.
// Positions are taken from the technique's own plans.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "equations/coarse.h"
#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"
#include "lab/run/resolver.h"

namespace reprise::lab::cpst {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kShadingPeriod_px = 2.0;  // the torus of a coarse pixel
constexpr double kVisibilityPeriod_px = 1.0;

struct Set {
  std::vector<double> x, y;  // px, within the period
  double period_px;
};

struct Sequence {
  std::string name;
  Set shading{{}, {}, kShadingPeriod_px};
  Set visibility{{}, {}, kVisibilityPeriod_px};
};

double within(double position_px, double period_px) {
  return position_px - period_px * std::floor(position_px / period_px);
}

void append(Set& set, double x_px, double y_px) {
  set.x.push_back(within(x_px, set.period_px));
  set.y.push_back(within(y_px, set.period_px));
}

Sequence sequenceOf(BareScene& scene, const std::string& name, const std::string& technique) {
  Sequence sequence;
  sequence.name = name;
  Resolver resolver(scene.device(), parseTechnique(technique), scene.source().info());
  const uint32_t period = resolver.plan(0).library.period;
  for (uint32_t frame = 0; frame < period; ++frame) {
    const RepriseSamplePlan plan = resolver.plan(frame).library;
    const int size = static_cast<int>(plan.coarse_size);
    append(sequence.shading,
           eq::coarseCentre(0, size, plan.coarse_origin_px[0]) - plan.jitter_px[0],
           eq::coarseCentre(0, size, plan.coarse_origin_px[1]) - plan.jitter_px[1]);
    append(sequence.visibility, 0.5 - plan.jitter_px[0], 0.5 - plan.jitter_px[1]);
  }
  return sequence;
}

// Of wave (i, j) of the torus; 1 for points at random.
double power(const Set& set, int i, int j) {
  double real = 0.0;
  double imaginary = 0.0;
  for (size_t k = 0; k < set.x.size(); ++k) {
    const double phase = kTurn * (i * set.x[k] + j * set.y[k]) / set.period_px;
    real += std::cos(phase);
    imaginary += std::sin(phase);
  }
  return (real * real + imaginary * imaginary) / static_cast<double>(set.x.size());
}

// Waves on a side at which points of a lattice of as many would repeat.
double principal(const Set& set) {
  return std::sqrt(static_cast<double>(set.x.size()));
}

// Mean power over rings of whole wave numbers; x in principal waves.
Series spectrum(const std::string& name, const Set& set) {
  const int last = static_cast<int>(3.0 * principal(set));
  std::vector<double> sums(last + 1);
  std::vector<double> counts(last + 1);
  for (int i = -last; i <= last; ++i) {
    for (int j = -last; j <= last; ++j) {
      const auto ring = static_cast<int>(std::lround(std::hypot(i, j)));
      if (ring == 0 || ring > last) continue;
      sums[ring] += power(set, i, j);
      counts[ring] += 1.0;
    }
  }
  Series series{name, {}, {}, false};
  for (int ring = 1; ring <= last; ++ring) {
    series.x.push_back(ring / principal(set));
    series.y.push_back(sums[ring] / counts[ring]);
  }
  return series;
}

// Mean power below half of the principal wave: what is left of unevenness that is seen.
double lowPower(const Set& set) {
  const double limit = 0.5 * principal(set);
  double sum = 0.0;
  double count = 0.0;
  for (int i = -static_cast<int>(limit); i <= limit; ++i) {
    for (int j = -static_cast<int>(limit); j <= limit; ++j) {
      const double wave = std::hypot(i, j);
      if (wave < 0.5 || wave > limit) continue;
      sum += power(set, i, j);
      count += 1.0;
    }
  }
  return sum / std::max(count, 1.0);
}

// Smallest distance of two points on the torus, of a lattice's; points that fall together: 0.
double closest(const Set& set) {
  double least = std::numeric_limits<double>::infinity();
  const auto along = [&](double a, double b) {
    const double d = std::abs(a - b);
    return std::min(d, set.period_px - d);
  };
  for (size_t i = 0; i < set.x.size(); ++i) {
    for (size_t j = i + 1; j < set.x.size(); ++j) {
      least = std::min(least, std::hypot(along(set.x[i], set.x[j]), along(set.y[i], set.y[j])));
    }
  }
  return least * principal(set) / set.period_px;
}

}  // namespace

void pointSets(PaperLab& lab, Outcome& outcome) {
  BareScene scene(lab, "brick/still", {16, 16}, 1, std::nullopt);
  const std::vector<Sequence> sequences = {
      sequenceOf(scene, "Halton (2, 3)", "cpst:jitter=halton"),
      sequenceOf(scene, "2x Halton", "cpst:jitter=halton-2x"),
      sequenceOf(scene, "void and cluster", "cpst:jitter=void-and-cluster")};
  for (const bool shading : {true, false}) {
    const std::string what = shading ? "shading" : "visibility";
    std::vector<Series> spectra;
    for (const Sequence& sequence : sequences) {
      const Set& set = shading ? sequence.shading : sequence.visibility;
      outcome.linePlot(
          {.title = fmt::format("{}: {} samples of {} frames", sequence.name, what, set.x.size()),
           .x = "x, px",
           .y = "y, px",
           .square = set.period_px},
          {{sequence.name, set.x, set.y, true}});
      spectra.push_back(spectrum(sequence.name, set));
      outcome.report(
          fmt::format("{}, {}: power below half the principal wave", sequence.name, what),
          std::nullopt, lowPower(set), "of random");
      outcome.report(fmt::format("{}, {}: closest pair", sequence.name, what), std::nullopt,
                     closest(set), "of a lattice");
    }
    outcome.linePlot({.title = "Power of " + what + " samples, mean over rings",
                      .x = "wave, of a lattice's of as many points",
                      .y = "power, of random points",
                      .log_y = true},
                     spectra);
  }
  // Figure 2: each Halton sequence spoils one of the two sets.
  const auto claim = [&](const std::string& what, const Set& ours, const Set& theirs) {
    outcome.claim(what, std::nullopt, lowPower(ours) / lowPower(theirs), "times", "more even",
                  lowPower(ours) < lowPower(theirs));
  };
  claim("void and cluster over Halton, shading", sequences[2].shading, sequences[0].shading);
  claim("void and cluster over 2x Halton, visibility", sequences[2].visibility,
        sequences[1].visibility);
  outcome.note(
      "Shading samples on the torus of a coarse pixel (2 px), visibility samples on that of a "
      "pixel. "
      "A scaled Halton sequence wraps twice each way in visibility.");
}

}  // namespace reprise::lab::cpst
