// SPDX-License-Identifier: MIT
#include "lab/metrics/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace reprise::lab {
namespace {

using Plane = std::vector<float>;

constexpr double kPi = std::numbers::pi;

struct Shape {
  int width;
  int height;
};

// Symmetric or antisymmetric taps from -radius to radius.
struct Kernel {
  int radius = 0;
  std::vector<float> taps;
};

template <typename Function>
Kernel sampledKernel(int radius, const Function& value) {
  Kernel kernel{radius, {}};
  for (int i = -radius; i <= radius; ++i) kernel.taps.push_back(static_cast<float>(value(i)));
  return kernel;
}

// Edge texels are repeated outside.
Plane alongX(const Plane& in, const Kernel& kernel, Shape shape) {
  Plane out(in.size());
  std::vector<float> line(static_cast<size_t>(shape.width + 2 * kernel.radius));
  for (int y = 0; y < shape.height; ++y) {
    const float* row = &in[static_cast<size_t>(y) * shape.width];
    for (int x = 0; x < static_cast<int>(line.size()); ++x) {
      line[x] = row[std::clamp(x - kernel.radius, 0, shape.width - 1)];
    }
    float* to = &out[static_cast<size_t>(y) * shape.width];
    std::fill(to, to + shape.width, 0.0f);
    for (int k = 0; k <= 2 * kernel.radius; ++k) {
      const float tap = kernel.taps[k];
      for (int x = 0; x < shape.width; ++x) to[x] += tap * line[x + k];
    }
  }
  return out;
}

Plane alongY(const Plane& in, const Kernel& kernel, Shape shape) {
  Plane out(in.size(), 0.0f);
  for (int y = 0; y < shape.height; ++y) {
    float* to = &out[static_cast<size_t>(y) * shape.width];
    for (int k = 0; k <= 2 * kernel.radius; ++k) {
      const int from_y = std::clamp(y + k - kernel.radius, 0, shape.height - 1);
      const float* from = &in[static_cast<size_t>(from_y) * shape.width];
      const float tap = kernel.taps[k];
      for (int x = 0; x < shape.width; ++x) to[x] += tap * from[x];
    }
  }
  return out;
}

Plane separable(const Plane& in, const Kernel& x, const Kernel& y, Shape shape) {
  return alongY(alongX(in, x, shape), y, shape);
}

struct Triple {
  float a, b, c;
};

// Of the FLIP paper's code: sRGB primaries and white as fractions, and their inverse in decimals;
// rows.
Triple xyzFromLinear(float r, float g, float b) {
  return {
      10135552.0f / 24577794.0f * r + 8788810.0f / 24577794.0f * g + 4435075.0f / 24577794.0f * b,
      2613072.0f / 12288897.0f * r + 8788810.0f / 12288897.0f * g + 887015.0f / 12288897.0f * b,
      1425312.0f / 73733382.0f * r + 8788810.0f / 73733382.0f * g + 70074185.0f / 73733382.0f * b};
}
Triple linearFromXyz(float x, float y, float z) {
  return {3.241003275f * x - 1.537398934f * y - 0.498615861f * z,
          -0.969224334f * x + 1.875930071f * y + 0.041554224f * z,
          0.055639423f * x - 0.204011202f * y + 1.057148933f * z};
}
constexpr Triple kWhite{0.950428545f, 1.0f, 1.088900371f};

float labCurve(float t) {
  constexpr float kDelta = 6.0f / 29.0f;
  return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

// CIELab with the Hunt effect: chroma scaled by lightness.
Triple huntLab(float r, float g, float b) {
  const Triple xyz = xyzFromLinear(r, g, b);
  const float x = labCurve(xyz.a / kWhite.a);
  const float y = labCurve(xyz.b / kWhite.b);
  const float z = labCurve(xyz.c / kWhite.c);
  const float lightness = 116.0f * y - 16.0f;
  return {lightness, 0.01f * lightness * 500.0f * (x - y), 0.01f * lightness * 200.0f * (y - z)};
}

constexpr float kColorExponent = 0.7f;

// HyAB distance to the power of 0.7.
float colorDistance(const Triple& p, const Triple& q) {
  return std::pow(std::abs(p.a - q.a) + std::hypot(p.b - q.b, p.c - q.c), kColorExponent);
}

// Distances up to pccmax = 0.4 cmax use 0.95 of the range.
float redistributed(float distance) {
  static const float largest = colorDistance(huntLab(0.0f, 1.0f, 0.0f), huntLab(0.0f, 0.0f, 1.0f));
  const float knee = 0.4f * largest;
  if (distance < knee) return distance * 0.95f / knee;
  return 0.95f + 0.05f * (distance - knee) / (largest - knee);
}

struct ContrastKernels {
  Kernel achromatic, red_green, blue_yellow[2];
};

ContrastKernels contrastKernels(float pixels_per_degree) {
  const double ppd = pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * ppd));
  const auto gaussian = [&](double a, double b) {
    const double amplitude = std::sqrt(a * std::sqrt(kPi / b));
    return sampledKernel(radius, [=](int i) {
      const double degrees = i / ppd;
      return amplitude * std::exp(-kPi * kPi * degrees * degrees / b);
    });
  };
  const auto sum = [](const Kernel& kernel) {
    double total = 0.0;
    for (float tap : kernel.taps) total += tap;
    return total;
  };
  const auto scale = [](Kernel& kernel, double factor) {
    for (float& tap : kernel.taps) tap = static_cast<float>(tap * factor);
  };
  ContrastKernels kernels{
      gaussian(1.0, 0.0047), gaussian(1.0, 0.0053), {gaussian(34.1, 0.04), gaussian(13.5, 0.025)}};
  scale(kernels.achromatic, 1.0 / sum(kernels.achromatic));
  scale(kernels.red_green, 1.0 / sum(kernels.red_green));
  const double both = 1.0 / std::hypot(sum(kernels.blue_yellow[0]), sum(kernels.blue_yellow[1]));
  for (Kernel& kernel : kernels.blue_yellow) scale(kernel, both);
  return kernels;
}

// An image as the eye resolves it (Hunt-adjusted Lab), and its unfiltered grey.
struct Seen {
  std::vector<Triple> lab;
  Plane grey;
};

Seen seen(const FloatImage& image, const ContrastKernels& kernels, Shape shape) {
  const size_t count = image.texelCount();
  Plane luma(count), red_green(count), blue_yellow(count);
  Seen result{std::vector<Triple>(count), Plane(count)};
  for (size_t i = 0; i < count; ++i) {
    const float* rgb = &image.texels[image.channels * i];
    const Triple xyz = xyzFromLinear(std::clamp(rgb[0], 0.0f, 1.0f), std::clamp(rgb[1], 0.0f, 1.0f),
                                     std::clamp(rgb[2], 0.0f, 1.0f));
    const float x = xyz.a / kWhite.a;
    const float y = xyz.b / kWhite.b;
    const float z = xyz.c / kWhite.c;
    luma[i] = 116.0f * y - 16.0f;
    red_green[i] = 500.0f * (x - y);
    blue_yellow[i] = 200.0f * (y - z);
    result.grey[i] = y;
  }
  luma = separable(luma, kernels.achromatic, kernels.achromatic, shape);
  red_green = separable(red_green, kernels.red_green, kernels.red_green, shape);
  const Plane wide = separable(blue_yellow, kernels.blue_yellow[0], kernels.blue_yellow[0], shape);
  const Plane narrow =
      separable(blue_yellow, kernels.blue_yellow[1], kernels.blue_yellow[1], shape);
  for (size_t i = 0; i < count; ++i) {
    const float y = (luma[i] + 16.0f) / 116.0f;
    const float x = y + red_green[i] / 500.0f;
    const float z = y - (wide[i] + narrow[i]) / 200.0f;
    const Triple rgb = linearFromXyz(x * kWhite.a, y * kWhite.b, z * kWhite.c);
    result.lab[i] = huntLab(std::clamp(rgb.a, 0.0f, 1.0f), std::clamp(rgb.b, 0.0f, 1.0f),
                            std::clamp(rgb.c, 0.0f, 1.0f));
  }
  return result;
}

struct FeatureKernels {
  Kernel smooth, first, second;
};

FeatureKernels featureKernels(float pixels_per_degree) {
  const double sigma = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  const auto gaussian = [&](int i) { return std::exp(-0.5 * i * i / (sigma * sigma)); };
  FeatureKernels kernels{
      sampledKernel(radius, gaussian),
      sampledKernel(radius, [&](int i) { return -i * gaussian(i); }),
      sampledKernel(radius, [&](int i) { return (i * i / (sigma * sigma) - 1.0) * gaussian(i); })};
  // Each lobe is scaled to an area of one, so that an ideal edge or point answers 1.
  for (Kernel* kernel : {&kernels.smooth, &kernels.first, &kernels.second}) {
    double positive = 0.0;
    double negative = 0.0;
    for (float tap : kernel->taps) (tap > 0.0f ? positive : negative) += std::abs(tap);
    for (float& tap : kernel->taps) {
      const double area = tap > 0.0f ? positive : negative;
      if (area > 0.0) tap = static_cast<float>(tap / area);
    }
  }
  return kernels;
}

struct Features {
  Plane edge, point;  // magnitudes
};

Features features(const Plane& grey, const FeatureKernels& kernels, Shape shape) {
  const auto magnitude = [&](const Kernel& derivative) {
    const Plane x = separable(grey, derivative, kernels.smooth, shape);
    const Plane y = separable(grey, kernels.smooth, derivative, shape);
    Plane length(grey.size());
    for (size_t i = 0; i < length.size(); ++i) length[i] = std::hypot(x[i], y[i]);
    return length;
  };
  return {magnitude(kernels.first), magnitude(kernels.second)};
}

}  // namespace

FloatImage flipErrorMap(const FloatImage& reference, const FloatImage& test,
                        float pixels_per_degree) {
  const Shape shape{static_cast<int>(reference.width), static_cast<int>(reference.height)};
  const ContrastKernels contrast = contrastKernels(pixels_per_degree);
  const FeatureKernels feature = featureKernels(pixels_per_degree);
  const Seen seen_reference = seen(reference, contrast, shape);
  const Seen seen_test = seen(test, contrast, shape);
  const Features reference_features = features(seen_reference.grey, feature, shape);
  const Features test_features = features(seen_test.grey, feature, shape);
  FloatImage error(reference.width, reference.height, 1);
  for (size_t i = 0; i < error.texels.size(); ++i) {
    const float color = redistributed(colorDistance(seen_reference.lab[i], seen_test.lab[i]));
    const float edge = std::abs(reference_features.edge[i] - test_features.edge[i]);
    const float point = std::abs(reference_features.point[i] - test_features.point[i]);
    const float shape_error = std::sqrt(std::max(edge, point) / std::numbers::sqrt2_v<float>);
    error.texels[i] = std::pow(color, 1.0f - std::min(shape_error, 1.0f));
  }
  return error;
}

double meanOf(const FloatImage& one_channel) {
  double sum = 0.0;
  for (float value : one_channel.texels) sum += value;
  return sum / static_cast<double>(std::max<size_t>(one_channel.texels.size(), 1));
}

}  // namespace reprise::lab
