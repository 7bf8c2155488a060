// SPDX-License-Identifier: MIT
#include "lab/metrics/jitter_residue.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "lab/metrics/workers.h"

namespace reprise::lab {
namespace {

// Of one row: its pixels' figures, and power by frequency summed over them.
struct Row {
  std::vector<float> sigma;
  std::vector<float> peak;
  std::vector<double> power;  // [k]: frequency k / frames of the frame rate
};

Row measureRow(const std::vector<FloatImage>& differences, const std::vector<uint8_t>& at_rest,
               uint32_t y) {
  const size_t frames = differences.size();
  const size_t width = differences[0].width;
  Row row;
  row.power.assign(frames / 2 + 1, 0.0);
  std::vector<uint32_t> columns;
  for (uint32_t x = 0; x < width; ++x) {
    if (at_rest[y * width + x] != 0) columns.push_back(x);
  }
  if (columns.empty()) return row;
  const size_t count = columns.size();
  // values[frame * count + i], their mean over frames taken out.
  std::vector<float> values(frames * count);
  row.sigma.assign(count, 0.0f);
  row.peak.assign(count, 0.0f);
  for (size_t i = 0; i < count; ++i) {
    double sum = 0.0;
    float least = differences[0].at(columns[i], y)[0];
    float most = least;
    for (size_t f = 0; f < frames; ++f) {
      const float v = differences[f].at(columns[i], y)[0];
      values[f * count + i] = v;
      sum += v;
      least = std::min(least, v);
      most = std::max(most, v);
    }
    const auto mean = static_cast<float>(sum / static_cast<double>(frames));
    double variance = 0.0;
    for (size_t f = 0; f < frames; ++f) {
      float& v = values[f * count + i];
      v -= mean;
      variance += double{v} * v;
    }
    row.sigma[i] = static_cast<float>(std::sqrt(variance / static_cast<double>(frames)));
    row.peak[i] = most - least;
  }
  std::vector<float> real(count);
  std::vector<float> imaginary(count);
  for (size_t k = 1; k < row.power.size(); ++k) {
    std::fill(real.begin(), real.end(), 0.0f);
    std::fill(imaginary.begin(), imaginary.end(), 0.0f);
    for (size_t f = 0; f < frames; ++f) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k * f % frames) /
                           static_cast<double>(frames);
      const auto c = static_cast<float>(std::cos(angle));
      const auto s = static_cast<float>(std::sin(angle));
      const float* v = &values[f * count];
      for (size_t i = 0; i < count; ++i) {
        real[i] += c * v[i];
        imaginary[i] += s * v[i];
      }
    }
    // Parseval: the variance of a pixel is the sum over k of this; the frequency of half the frame
    // rate stands alone, every other one for its negative too.
    const double both = 2 * k == frames ? 1.0 : 2.0;
    const double scale = both / (static_cast<double>(frames) * static_cast<double>(frames));
    for (size_t i = 0; i < count; ++i) {
      row.power[k] += scale * (double{real[i]} * real[i] + double{imaginary[i]} * imaginary[i]);
    }
  }
  return row;
}

double meanOfAll(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double percentile99(std::vector<float>& values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 99 / 100);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

std::optional<JitterResidue> jitterResidue(const std::vector<FloatImage>& differences,
                                           const std::vector<uint8_t>& at_rest, double frame_rate) {
  const size_t frames = differences.size();
  if (frames < kLeastResidueFrames) return std::nullopt;
  std::vector<Row> rows(differences[0].height);
  onWorkers(rows.size(), [&](size_t y) {
    rows[y] = measureRow(differences, at_rest, static_cast<uint32_t>(y));
  });
  std::vector<float> sigma;
  std::vector<float> peak;
  std::vector<double> power(frames / 2 + 1, 0.0);
  for (const Row& row : rows) {
    sigma.insert(sigma.end(), row.sigma.begin(), row.sigma.end());
    peak.insert(peak.end(), row.peak.begin(), row.peak.end());
    for (size_t k = 0; k < power.size(); ++k) power[k] += row.power[k];
  }
  if (sigma.empty()) return std::nullopt;
  JitterResidue residue{.frames = static_cast<uint32_t>(frames), .pixels = sigma.size()};
  residue.sigma_mean = meanOfAll(sigma);
  residue.peak_mean = meanOfAll(peak);
  residue.sigma_p99 = percentile99(sigma);
  residue.peak_p99 = percentile99(peak);
  double band = 0.0;
  size_t strongest = 0;
  for (size_t k = 1; k < power.size(); ++k) {
    const double hz = frame_rate * static_cast<double>(k) / static_cast<double>(frames);
    if (hz >= kEyeBandFrom_hz && hz <= kEyeBandTo_hz) band += power[k];
    if (power[k] > power[strongest]) strongest = k;
  }
  residue.eye_band_rms = std::sqrt(band / static_cast<double>(sigma.size()));
  residue.strongest_hz = frame_rate * static_cast<double>(strongest) / static_cast<double>(frames);
  return residue;
}

}  // namespace reprise::lab
