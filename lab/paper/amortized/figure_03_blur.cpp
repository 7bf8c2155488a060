// SPDX-License-Identifier: MIT
//
// Figure 3: is the blur of bilinear reprojection what (11) says? A resolution chart pans at each
// velocity until converged; the Gaussian that comes nearest to the result is its blur.
#include <fmt/format.h>

#include <cmath>

#include "equations/amortized.h"
#include "lab/metrics/workers.h"
#include "lab/paper/amortized/chart_pan.h"
#include "lab/paper/amortized/experiments.h"
#include "lab/run/interrupt.h"
#include "lab/run/progress.h"
#include "techniques/amortized/buffer_layout.h"

namespace reprise::lab::amortized {
namespace {

constexpr double kAlphas[] = {0.1, 0.2, 0.4, 0.8};
constexpr double kPublishedRmse_px = 0.0382;
constexpr double kLeastWeight = 1.0e-4;

std::vector<double> velocities(uint32_t count) {
  std::vector<double> values;
  for (uint32_t i = 0; i < count; ++i) values.push_back(i / double(std::max(count, 2u) - 1));
  return values;
}

double predictedSigma_px(double alpha, double vx, double vy) {
  constexpr float kVariance =
      reprise::amortized::kPixelSigma_px * reprise::amortized::kPixelSigma_px;
  return std::sqrt(eq::bilinearBlurVariance(kVariance, static_cast<float>(alpha),
                                            static_cast<float>(vx), static_cast<float>(vy)));
}

// Where the samples lie after n bilinear fetches at the fraction f: each moves them by -f with
// weight 1 - f, or by 1 - f with weight f (35, 36).
std::vector<Displacement> afterFetches(uint32_t n, double f) {
  std::vector<Displacement> places;
  double weight = std::pow(1.0 - f, n);  // binomial
  for (uint32_t j = 0; j <= n; ++j) {
    if (f <= 0.0 || f >= 1.0) return {{0.0, 1.0}};
    if (weight > kLeastWeight) places.push_back({j - n * f, weight});
    weight *= static_cast<double>(n - j) / (j + 1) * f / (1.0 - f);
  }
  return places;
}

// The chart under the distribution of (35): what a converged history shows, without noise.
FloatImage expectedImage(const BlurFit& fit, double alpha, double vx, double vy) {
  FloatImage sum;
  double left = 1.0;
  for (uint32_t n = 0; n < ChartPan::kFrames; ++n) {
    // The first frame has no history: it holds all that is left.
    const double share = n + 1 < ChartPan::kFrames ? left * alpha : left;
    left -= share;
    if (share < kLeastWeight) continue;
    const FloatImage part = fit.spread(reprise::amortized::kPixelSigma_px,
                                       afterFetches(n, 1.0 - vx), afterFetches(n, 1.0 - vy));
    if (sum.texels.empty()) sum = FloatImage(part.width, part.height, 1);
    for (size_t i = 0; i < sum.texels.size(); ++i) {
      sum.texels[i] += static_cast<float>(share) * part.texels[i];
    }
  }
  return sum;
}

double rmse(const std::vector<Surface>& measured, const std::vector<Surface>& predicted) {
  double sum = 0.0;
  size_t count = 0;
  for (size_t i = 0; i < measured.size(); ++i) {
    for (size_t cell = 0; cell < measured[i].z.size(); ++cell, ++count) {
      const double d = measured[i].z[cell] - predicted[i].z[cell];
      sum += d * d;
    }
  }
  return std::sqrt(sum / static_cast<double>(std::max<size_t>(count, 1)));
}

}  // namespace

void figure3(PaperLab& lab, Outcome& outcome) {
  const std::vector<double> grid = velocities(lab.scale().grid);
  // A panel each: as the paper measures it, by the second moment, (11).
  std::vector<std::pair<std::string, std::vector<Surface>>> panels = {
      {"best matching Gaussian", {}},
      {"the same of the distribution behind (11)", {}},
      {"equation (11)", {}}};
  for (auto& [name, surfaces] : panels) {
    for (const double alpha : kAlphas) {
      surfaces.push_back({fmt::format("alpha {}", alpha), grid, grid,
                          std::vector<double>(grid.size() * grid.size())});
    }
  }
  const auto device = lab.openDevice();
  Progress progress("blur of the panning chart", grid.size() * grid.size(), lab.quiet());
  for (size_t cell = 0; cell < grid.size() * grid.size(); ++cell) {
    throwIfInterrupted();
    const double vx = grid[cell % grid.size()];
    const double vy = grid[cell / grid.size()];
    ChartPan pan(*device, vx, vy);
    std::vector<FloatImage> results;
    for (const double alpha : kAlphas) {
      results.push_back(
          pan.run(fmt::format("amortized:buffers=1,requests=false,fixed_alpha={}", alpha)));
    }
    onWorkers(2 * results.size(), [&](size_t i) {
      const size_t which = i / 2;
      const FloatImage image =
          i % 2 == 0 ? results[which] : expectedImage(pan.fit(), kAlphas[which], vx, vy);
      panels[i % 2].second[which].z[cell] = pan.fit().bestSigma(image).sigma_px;
    });
    for (size_t i = 0; i < results.size(); ++i) {
      panels[2].second[i].z[cell] = predictedSigma_px(kAlphas[i], vx, vy);
    }
    progress.step();
  }
  for (size_t i = 0; i < std::size(kAlphas); ++i) {
    outcome.report(fmt::format("RMSE at alpha {}", kAlphas[i]), std::nullopt,
                   rmse({panels[0].second[i]}, {panels[2].second[i]}), "px");
  }
  const double rmse_px = rmse(panels[0].second, panels[2].second);
  const double distribution_rmse_px = rmse(panels[0].second, panels[1].second);
  outcome.claim("RMSE of the best matching Gaussian", kPublishedRmse_px, rmse_px, "px",
                "not above the published", rmse_px <= kPublishedRmse_px);
  outcome.claim("RMSE against the best match of the distribution that (11) is of",
                kPublishedRmse_px, distribution_rmse_px, "px", "not above the published",
                distribution_rmse_px <= kPublishedRmse_px);
  outcome.surfacePlot({"Deviation of the blur, px, over the velocity; one surface for each alpha",
                       "vx, px a frame", "vy, px a frame", "sigma, px"},
                      panels);
  outcome.note(fmt::format(
      "Velocities {} x {} over [0, 1] px a frame, {} frames of {} x {} px, the last compared with "
      "the chart at {} times the resolution under Gaussians of every deviation.",
      grid.size(), grid.size(), ChartPan::kFrames, ChartPan::kSide_px, ChartPan::kSide_px,
      ChartPan::kFineScale));
  outcome.note(
      "The samples' distribution is a geometric mixture of ever wider ones, with longer tails than "
      "a Gaussian: the Gaussian that looks most like it on fine detail is narrower than its "
      "deviation, which is what (11) states, the more so the smaller alpha. The middle surface "
      "is the same fit to the chart under that very distribution, sample by sample and without "
      "noise.");
}

}  // namespace reprise::lab::amortized
