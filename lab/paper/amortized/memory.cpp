// SPDX-License-Identifier: MIT
//
// Memory: what the technique keeps at the paper's resolution, image by image.
#include <fmt/format.h>

#include "lab/paper/amortized/experiments.h"

namespace reprise::lab::amortized {
namespace {

constexpr VkExtent2D kPaperExtent{1024, 768};
constexpr double kMegabyte = 1.0e6;  // as the paper counts: 27 MB are 4 RGBA16F and 2 R8
constexpr double kPublished_mb = 27.0;
constexpr double kPixels = 1024.0 * 768.0;
constexpr double kPublishedBuffers_mb = 4.0 * 8.0 * kPixels / kMegabyte;
constexpr double kPublishedCounts_mb = 2.0 * kPixels / kMegabyte;

struct Variant {
  const char* technique;
  const char* why;
};

constexpr Variant kVariants[] = {
    {"amortized:requests=false,motion=exact",
     "the paper's own needs: a fifth buffer, since a compute gather reads neighbours of the one "
     "that is written, and halves that count beyond 255 samples"},
    {"amortized",
     "motion chained from frame to frame, which the paper's vertex shader recomputes, "
     "and the list of requests"},
    {"amortized:residual=0.1", "residuals, ping-pong, and the two steps of their box filter"}};

}  // namespace

void memory(PaperLab& lab, Outcome& outcome) {
  const auto device = lab.openDevice();
  SourceInfo info;
  info.name = "memory";
  info.extent = kPaperExtent;
  info.plan_is_honoured = true;
  std::vector<std::vector<std::string>> lines;
  double paper_like_mb = 0.0;
  for (const Variant& variant : kVariants) {
    const Resolver resolver(*device, parseTechnique(variant.technique), info);
    double sum_mb = 0.0;
    for (const RepriseMemoryItem& item : resolver.memory()) {
      const double mb = static_cast<double>(item.bytes) / kMegabyte;
      sum_mb += mb;
      lines.push_back({variant.technique, item.name, fmt::format("{:.2f}", mb)});
      std::optional<double> published;
      const std::string name = item.name;
      if (name.starts_with("subpixel buffers")) published = kPublishedBuffers_mb;
      if (name.starts_with("effective samples")) published = kPublishedCounts_mb;
      if (&variant == kVariants) outcome.report(name, published, mb, "MB");
    }
    lines.push_back({variant.technique, "all", fmt::format("{:.2f}", sum_mb)});
    if (&variant == kVariants) paper_like_mb = sum_mb;
    outcome.report(std::string("all of ") + variant.technique, kPublished_mb, sum_mb, "MB");
    outcome.note(fmt::format("{}: {}", variant.technique, variant.why));
  }
  const double expected_mb = kPublishedBuffers_mb * 5.0 / 4.0 + 2.0 * kPublishedCounts_mb;
  outcome.claim("with exact motion, without requests", kPublished_mb, paper_like_mb, "MB",
                "the paper's, a fifth buffer and 16-bit counts, no more",
                paper_like_mb <= expected_mb * 1.001);
  outcome.table("Bytes at 1024 x 768, MB", {"settings", "image", "MB"}, lines);
}

}  // namespace reprise::lab::amortized
