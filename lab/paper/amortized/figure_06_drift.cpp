// SPDX-License-Identifier: MIT
//
// Figure 6: round robin lets the image drift, the irregular order does not. The displacement of
// the panning chart is measured and set beside the mean of the sample distribution.
#include <fmt/format.h>

#include <cmath>

#include "lab/metrics/display_space.h"
#include "lab/metrics/workers.h"
#include "lab/paper/amortized/chart_pan.h"
#include "lab/paper/amortized/experiments.h"
#include "lab/run/interrupt.h"
#include "lab/run/progress.h"
#include "techniques/amortized/blur_moments.h"

namespace reprise::lab::amortized {
namespace {

using reprise::amortized::kPeriod;
using reprise::amortized::PanningGathers;

// A buffer that keeps three quarters of its past drifts visibly, and settles within the run.
constexpr double kAlpha = 0.25;
constexpr double kVelocityY = 0.2;
constexpr const char* kOrders[] = {"round-robin", "irregular"};

std::array<uint32_t, kPeriod> orderOf(size_t kind) {
  std::array<uint32_t, kPeriod> order{};
  for (uint32_t n = 0; n < kPeriod; ++n) {
    order[n] = kind == 0 ? n % 4 : reprise::amortized::bufferOfFrame(4, n);
  }
  return order;
}

double predictedDrift(size_t kind, double vx, double vy) {
  // Content that moves by (vx, vy) lay at the opposite before.
  const PanningGathers gathers(reprise::amortized::bufferLayout(4), orderOf(kind), -vx, -vy);
  const auto moments = gathers.moments(kAlpha, 0.0);
  return std::hypot(moments.first_x, moments.first_y);
}

FloatImage displayed(const FloatImage& red) {
  FloatImage rgb(red.width, red.height, 3);
  for (size_t i = 0; i < rgb.texels.size(); ++i) rgb.texels[i] = red.texels[i / 3];
  return displayImage(rgb);
}

FloatImage inside(const FloatImage& image) {
  const uint32_t margin = ChartPan::kMargin_px;
  FloatImage part(image.width - 2 * margin, image.height - 2 * margin, 1);
  for (uint32_t y = 0; y < part.height; ++y) {
    for (uint32_t x = 0; x < part.width; ++x) {
      *part.at(x, y) = *image.at(x + margin, y + margin);
    }
  }
  return part;
}

}  // namespace

void figure6(PaperLab& lab, Outcome& outcome) {
  const uint32_t points = 2 * lab.scale().grid + 1;
  const auto device = lab.openDevice();
  std::vector<Series> series;
  for (const char* order : kOrders) {
    series.push_back({std::string(order) + ", measured", {}, {}, true});
    series.push_back({std::string(order) + ", first moment", {}, {}, false});
  }
  std::vector<std::pair<std::string, FloatImage>> worst_pictures;
  double worst[2] = {0.0, 0.0};
  double sum[2] = {0.0, 0.0};
  Progress progress("drift of the panning chart", points, lab.quiet());
  for (uint32_t i = 0; i < points; ++i) {
    throwIfInterrupted();
    const double vx = i / double(points - 1);
    ChartPan pan(*device, vx, kVelocityY);
    FloatImage results[2];
    BlurMatch matches[2];
    for (size_t kind = 0; kind < 2; ++kind) {
      results[kind] = pan.run(
          fmt::format("amortized:requests=false,fixed_alpha={},order={}", kAlpha, kOrders[kind]));
    }
    onWorkers(2, [&](size_t kind) { matches[kind] = pan.fit().bestShift(results[kind]); });
    const double before = worst[0];
    for (size_t kind = 0; kind < 2; ++kind) {
      const double drift = std::hypot(matches[kind].shift_x_px, matches[kind].shift_y_px);
      worst[kind] = std::max(worst[kind], drift);
      sum[kind] += drift;
      series[2 * kind].x.push_back(vx);
      series[2 * kind].y.push_back(drift);
      series[2 * kind + 1].x.push_back(vx);
      series[2 * kind + 1].y.push_back(predictedDrift(kind, vx, kVelocityY));
    }
    if (worst[0] > before) {
      worst_pictures.clear();
      for (size_t kind = 0; kind < 2; ++kind) {
        worst_pictures.emplace_back(
            fmt::format("{}: drift {:.2f} px", kOrders[kind],
                        std::hypot(matches[kind].shift_x_px, matches[kind].shift_y_px)),
            displayed(inside(results[kind])));
      }
      worst_pictures.emplace_back("where it should be",
                                  displayed(pan.fit().blurred(0.4737, 0.0, 0.0)));
    }
    progress.step();
  }
  outcome.report("mean drift, round robin", std::nullopt, sum[0] / points, "px");
  outcome.claim("mean drift, irregular order", std::nullopt, sum[1] / points, "px",
                "below half of round robin's", sum[1] < 0.5 * sum[0]);
  outcome.report("largest drift, round robin", std::nullopt, worst[0], "px");
  outcome.claim("largest drift, irregular order", std::nullopt, worst[1], "px",
                "below round robin's", worst[1] < worst[0]);
  outcome.linePlot({fmt::format("Drift at alpha {}, vy {} px a frame", kAlpha, kVelocityY),
                    "vx, px a frame", "displacement, px"},
                   series);
  outcome.gallery("At round robin's largest drift", worst_pictures);
}

}  // namespace reprise::lab::amortized
