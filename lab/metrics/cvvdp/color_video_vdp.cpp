// SPDX-License-Identifier: MIT
// Constants are those of the authors' cvvdp_parameters.json, calibrated 10/01/2024.
#include "lab/metrics/cvvdp/color_video_vdp.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <thread>

#include "lab/metrics/cvvdp/pyramid.h"
#include "lab/metrics/workers.h"

namespace reprise::lab {
namespace {

using Channels =
    std::array<FloatImage, kVdpChannels>;  // one channel each; the last empty for images

constexpr float kMaskExponent = 2.264355183f;
constexpr std::array<float, 4> kMaskExponents = {1.302622676f, 2.888590813f, 3.680771351f,
                                                 3.588787317f};
// log2, [j][c]: how much channel j masks channel c.
constexpr float kCrossMasking[4][4] = {
    {-0.18950104713f, -5.96215105057f, -4.31834602356f, -1.93215870857f},
    {2.56555938721f, 0.34406712651f, -2.71964645386f, -0.49704247713f},
    {3.81184388828f, -1.00517055842f, -0.51933765411f, -0.56536477804f},
    {-7.05477142334f, -5.52715015411f, -3.51064181328f, -2.08804988861f}};
constexpr std::array<float, 4> kChannelGain = {1.0f, 1.45f, 1.0f, 1.0f};
constexpr std::array<double, 4> kChannelWeight = {1.0, 1.0, 1.0, 0.8081134557723999};
constexpr std::array<double, 4> kBaseWeight = {0.0036334486212581396, 1.6627724170684814,
                                               4.11874532699585, 25.25969886779785};
constexpr double kMaskGainLog10 = -0.7954971194267273;
constexpr double kSensitivityCorrection_db = -0.2797423303127289;
constexpr double kMaxDifferenceLog10 = 2.5642454624176025;
constexpr double kImageScale = 0.577918291091919;
constexpr float kLeastLuminance = 0.01f;
constexpr float kMaxContrast = 1000.0f;
constexpr double kBaseFrequency_cpd = 0.1;
constexpr double kLowestFrequency_cpd = 0.2;
constexpr double kDisplayReflectivity = 0.005;

// Powers of ColorVideoVDP: a slope that is finite at 0.
constexpr double kPowerGuard = 1.0e-5;
double guardedPower(double x, double exponent) {
  return std::pow(x + kPowerGuard, exponent) - std::pow(kPowerGuard, exponent);
}
struct GuardedPower {
  float exponent;
  float at_zero;
  explicit GuardedPower(float e)
      : exponent(e), at_zero(std::pow(static_cast<float>(kPowerGuard), e)) {}
  float operator()(float x) const {
    return std::pow(x + static_cast<float>(kPowerGuard), exponent) - at_zero;
  }
};

struct Bands {
  size_t count;  // with the base band
  std::vector<CsfTable::Curve> curves;
};

Bands bandsOf(const CsfTable& table, double pixels_per_degree, uint32_t width, uint32_t height) {
  const auto frequency = [&](size_t band) {
    if (band == 0) return 0.5 * pixels_per_degree;
    return 0.5 * pixels_per_degree * 0.3228 * std::pow(0.5, static_cast<double>(band - 1));
  };
  size_t lowest = 0;
  while (frequency(lowest) > kLowestFrequency_cpd) ++lowest;
  size_t log_side = 0;
  for (uint32_t side = std::min(width, height); side > 1; side /= 2) ++log_side;
  Bands bands;
  bands.count = std::min(lowest + 1, log_side - 1) + 1;
  for (size_t i = 0; i + 1 < bands.count; ++i) bands.curves.push_back(table.at(frequency(i)));
  bands.curves.push_back(table.at(kBaseFrequency_cpd));
  return bands;
}

double correction() {
  static const double kFactor = std::pow(10.0, kSensitivityCorrection_db / 20.0);
  return kFactor;
}

// Contrast of the channels of one image in one band, and the luminance that it is relative to.
struct Contrast {
  Channels channels;
  FloatImage luminance;
};

// Takes `level` apart: what is left is the next level.
Contrast takeBand(Channels& level, size_t channels, bool first) {
  Contrast contrast;
  Channels next;
  const uint32_t width = level[0].width;
  const uint32_t height = level[0].height;
  const float gain = first ? 1.0f : 2.0f;
  for (size_t c = 0; c < channels; ++c) {
    next[c] = reduced(level[c]);
    FloatImage low = expanded(next[c], width, height);
    if (c == 0) {
      contrast.luminance = low;
      for (float& l : contrast.luminance.texels) l = std::max(l, kLeastLuminance);
    }
    for (size_t i = 0; i < low.texels.size(); ++i) {
      const float difference = level[c].texels[i] - low.texels[i];
      low.texels[i] = gain * std::min(difference / contrast.luminance.texels[i], kMaxContrast);
    }
    contrast.channels[c] = std::move(low);
  }
  level = std::move(next);
  return contrast;
}

Contrast baseBand(const Channels& level, size_t channels) {
  Contrast contrast;
  double sum = 0.0;
  for (float l : level[0].texels) sum += std::max(l, kLeastLuminance);
  const auto mean = static_cast<float>(sum / static_cast<double>(level[0].texels.size()));
  contrast.luminance = FloatImage(level[0].width, level[0].height, 1);
  std::fill(contrast.luminance.texels.begin(), contrast.luminance.texels.end(), mean);
  for (size_t c = 0; c < channels; ++c) {
    contrast.channels[c] = level[c];
    for (float& v : contrast.channels[c].texels) v = std::min(v / mean, kMaxContrast);
  }
  return contrast;
}

// Multiplies both images by the sensitivity at the reference's luminance.
void weigh(Contrast& reference, Contrast& test, const CsfTable::Curve& curve, size_t channels,
           bool base) {
  const auto factor = static_cast<float>(correction());
  for (size_t i = 0; i < reference.luminance.texels.size(); ++i) {
    const auto s = curve.sensitivity(reference.luminance.texels[i]);
    for (size_t c = 0; c < channels; ++c) {
      const float weight = s[c] * factor * (base ? 1.0f : kChannelGain[c]);
      reference.channels[c].texels[i] *= weight;
      test.channels[c].texels[i] *= weight;
    }
  }
}

// Root of the mean square over pixels.
double pooledOverPixels(const FloatImage& difference) {
  double sum = 0.0;
  for (float d : difference.texels) {
    // (d + guard)^2 - guard^2
    sum += double{d} * (double{d} + 2.0 * kPowerGuard);
  }
  return guardedPower(sum / static_cast<double>(difference.texels.size()), 0.5);
}

// Differences after masking by all channels of both images, in place of the test.
void mask(const Contrast& reference, Contrast& test, size_t channels) {
  static const auto kGain = static_cast<float>(std::pow(10.0, kMaskGainLog10));
  static const auto kMost = static_cast<float>(std::pow(10.0, kMaxDifferenceLog10));
  static const GuardedPower kDifferencePower(kMaskExponent);
  Channels masks;
  const size_t count = reference.channels[0].texels.size();
  for (size_t j = 0; j < channels; ++j) {
    const FloatImage& r = reference.channels[j];
    FloatImage both(r.width, r.height, 1);
    for (size_t i = 0; i < count; ++i) {
      both.texels[i] = std::min(std::abs(r.texels[i]), std::abs(test.channels[j].texels[i]));
    }
    if (both.width > 6 && both.height > 6) both = maskingBlur(both);
    const GuardedPower power(kMaskExponents[j]);
    for (float& m : both.texels) m = power(m * kGain);
    masks[j] = std::move(both);
  }
  float cross[4][4];
  for (size_t j = 0; j < 4; ++j) {
    for (size_t c = 0; c < 4; ++c) cross[j][c] = std::exp2(kCrossMasking[j][c]);
  }
  for (size_t c = 0; c < channels; ++c) {
    for (size_t i = 0; i < count; ++i) {
      float masking = 0.0f;
      for (size_t j = 0; j < channels; ++j) masking += cross[j][c] * masks[j].texels[i];
      float& t = test.channels[c].texels[i];
      const float difference =
          kDifferencePower(std::abs(t - reference.channels[c].texels[i])) / (1.0f + masking);
      t = kMost * difference / (kMost + difference);
    }
  }
}

double qualityOf(const CsfTable& table, double pixels_per_degree, Channels reference, Channels test,
                 size_t channels) {
  const Bands bands = bandsOf(table, pixels_per_degree, reference[0].width, reference[0].height);
  std::array<double, kVdpChannels> fourth_powers{};
  for (size_t b = 0; b < bands.count; ++b) {
    const bool base = b + 1 == bands.count;
    Contrast r = base ? baseBand(reference, channels) : takeBand(reference, channels, b == 0);
    Contrast t = base ? baseBand(test, channels) : takeBand(test, channels, b == 0);
    weigh(r, t, bands.curves[b], channels, base);
    if (base) {
      for (size_t c = 0; c < channels; ++c) {
        for (size_t i = 0; i < t.channels[c].texels.size(); ++i) {
          float& d = t.channels[c].texels[i];
          d = std::abs(d - r.channels[c].texels[i]);
        }
      }
    } else {
      mask(r, t, channels);
    }
    for (size_t c = 0; c < channels; ++c) {
      const double weight = kChannelWeight[c] * (base ? kBaseWeight[c] : 1.0);
      fourth_powers[c] += guardedPower(weight * pooledOverPixels(t.channels[c]), 4.0);
    }
  }
  double sum = 0.0;
  for (size_t c = 0; c < channels; ++c) {
    sum += guardedPower(guardedPower(fourth_powers[c], 0.25), 4.0);
  }
  return guardedPower(sum, 0.25);
}

Channels planes(const FloatImage& opponent) {
  Channels result;
  for (size_t c = 0; c < 3; ++c) {
    result[c] = FloatImage(opponent.width, opponent.height, 1);
    for (size_t i = 0; i < result[c].texels.size(); ++i) {
      result[c].texels[i] = opponent.texels[3 * i + c];
    }
  }
  return result;
}

// The last frames of a video as opponent planes, oldest first.
class Window {
 public:
  Window(size_t length, const ColorVideoVdp::Frames& frames, const VdpDisplay& display)
      : length_(length), frames_(frames), display_(display) {}

  // Frames before the first repeat it.
  Channels filtered(size_t frame, const std::array<std::vector<float>, kVdpChannels>& taps) {
    if (planes_.empty()) {
      for (size_t age = length_; age-- > 0;) {
        const size_t wanted = frame - std::min(frame, age);
        if (!planes_.empty() && wanted == last_) {
          planes_.push_back(planes_.back());
        } else {
          push(wanted);
        }
      }
    } else {
      planes_.pop_front();
      push(frame);
    }
    Channels result;
    for (size_t c = 0; c < kVdpChannels; ++c) {
      const size_t plane = c == 3 ? 0 : c;
      FloatImage sum(planes_[0][0].width, planes_[0][0].height, 1);
      for (size_t k = 0; k < length_; ++k) {
        const float tap = taps[c][k];
        const float* from = planes_[k][plane].texels.data();
        for (size_t i = 0; i < sum.texels.size(); ++i) sum.texels[i] += tap * from[i];
      }
      result[c] = std::move(sum);
    }
    return result;
  }

 private:
  void push(size_t frame) {
    planes_.push_back(planes(opponentImage(frames_(frame), display_)));
    last_ = frame;
  }

  size_t length_;
  const ColorVideoVdp::Frames& frames_;
  const VdpDisplay& display_;
  std::deque<Channels> planes_;
  size_t last_ = 0;
};

}  // namespace

FloatImage opponentImage(const FloatImage& light, const VdpDisplay& display) {
  // sRGB to XYZ, XYZ to the cones of CIE 2006 (LMS), LMS to DKL around D65, multiplied out.
  static constexpr double kXyz[3][3] = {{0.4124564, 0.3575761, 0.1804375},
                                        {0.2126729, 0.7151522, 0.0721750},
                                        {0.0193339, 0.1191920, 0.9503041}};
  static constexpr double kLms[3][3] = {{0.187596268556126, 0.585168649077728, -0.026384263306304},
                                        {-0.133397430663221, 0.405505777260049, 0.034502127690364},
                                        {0.000244379021663, -0.000542995890619, 0.019406849066323}};
  static constexpr double kDkl[3][3] = {
      {1.0, 1.0, 0.0}, {1.0, -2.311130179947035, 0.0}, {-1.0, -1.0, 50.977571328718781}};
  float matrix[3][3];
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      double sum = 0.0;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) sum += kDkl[row][i] * kLms[i][j] * kXyz[j][column];
      }
      matrix[row][column] = static_cast<float>(sum);
    }
  }
  const double black = display.peak_cd_m2 / display.contrast;
  const double reflected = display.ambient_lux / std::numbers::pi * kDisplayReflectivity;
  const auto scale = static_cast<float>(display.peak_cd_m2 - black);
  const auto offset = static_cast<float>(black + reflected);
  FloatImage result(light.width, light.height, 3);
  for (size_t i = 0; i < light.texelCount(); ++i) {
    float rgb[3];
    for (size_t c = 0; c < 3; ++c) {
      rgb[c] = scale * std::clamp(light.texels[light.channels * i + c], 0.0f, 1.0f) + offset;
    }
    for (size_t row = 0; row < 3; ++row) {
      result.texels[3 * i + row] =
          matrix[row][0] * rgb[0] + matrix[row][1] * rgb[1] + matrix[row][2] * rgb[2];
    }
  }
  return result;
}

std::array<std::vector<float>, kVdpChannels> temporalTaps(double frame_rate) {
  constexpr double kFilter_s = 0.25;
  constexpr double kBeta[4] = {1.3314, 1.1196, 0.947901, 0.1898};
  constexpr double kSigma[4] = {5.79336, 14.1255, 6.63661, 0.12314};
  constexpr double kTransientPeak_hz = 5.0;
  const auto half = static_cast<size_t>(std::ceil(0.5 * kFilter_s * frame_rate));
  const size_t length = 2 * half + 1;
  std::array<std::vector<float>, kVdpChannels> taps;
  for (size_t c = 0; c < kVdpChannels; ++c) {
    std::vector<double> response(half + 1);
    for (size_t k = 0; k <= half; ++k) {
      const double hz = 0.5 * frame_rate * static_cast<double>(k) / static_cast<double>(half);
      const double warped = std::pow(hz, kBeta[c]);
      const double from_peak = c == 3 ? warped - std::pow(kTransientPeak_hz, kBeta[c]) : 0.0;
      response[k] = std::exp(-(c == 3 ? from_peak * from_peak : warped) / kSigma[c]);
    }
    for (size_t m = 0; m < length; ++m) {
      const double offset = static_cast<double>(m) - static_cast<double>(half);
      double sum = response[0];
      for (size_t k = 1; k <= half; ++k) {
        sum += 2.0 * response[k] *
               std::cos(2.0 * std::numbers::pi * static_cast<double>(k) * offset /
                        static_cast<double>(length));
      }
      taps[c].push_back(static_cast<float>(sum / static_cast<double>(length)));
    }
  }
  return taps;
}

std::vector<double> ColorVideoVdp::videoQuality(size_t frames, double frame_rate,
                                                const Frames& reference, const Frames& test) const {
  const auto taps = temporalTaps(frame_rate);
  std::vector<double> quality(frames);
  // Each part of the video has a window of its own that moves through it: of a frame's opponent
  // planes only the window's length is ever held, and few are made twice.
  const size_t parts = std::min<size_t>(frames, std::max(1u, std::thread::hardware_concurrency()));
  onWorkers(parts, [&](size_t part) {
    Window reference_window(taps[0].size(), reference, display_);
    Window test_window(taps[0].size(), test, display_);
    for (size_t n = part * frames / parts; n < (part + 1) * frames / parts; ++n) {
      quality[n] = qualityOf(table_, display_.pixels_per_degree, reference_window.filtered(n, taps),
                             test_window.filtered(n, taps), kVdpChannels);
    }
  });
  return quality;
}

double ColorVideoVdp::imageQuality(const FloatImage& reference, const FloatImage& test) const {
  return kImageScale * qualityOf(table_, display_.pixels_per_degree,
                                 planes(opponentImage(reference, display_)),
                                 planes(opponentImage(test, display_)), 3);
}

double pooledQuality(std::span<const double> quality) {
  double sum = 0.0;
  for (double q : quality) sum += guardedPower(q, 2.0);
  return quality.empty() ? 0.0 : guardedPower(sum / static_cast<double>(quality.size()), 0.5);
}

double jodFromQuality(double quality) {
  constexpr double kScale = 0.0439569391310215;
  constexpr double kExponent = 0.9302042722702026;
  constexpr double kLinearBelow = 0.1;
  if (quality > kLinearBelow) return 10.0 - kScale * std::pow(quality, kExponent);
  return 10.0 - kScale * std::pow(kLinearBelow, kExponent - 1.0) * quality;
}

}  // namespace reprise::lab
