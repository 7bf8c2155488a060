// SPDX-License-Identifier: MIT
#include "lab/post/show_sequence.h"

#include "equations/color_space.h"

namespace reprise::lab {
namespace {

FloatImage withAlpha(const FloatImage& picture) {
  if (picture.channels == 4) return picture;
  FloatImage rgba(picture.width, picture.height, 4);
  for (size_t i = 0; i < rgba.texelCount(); ++i) {
    for (uint32_t c = 0; c < 3; ++c) {
      rgba.texels[4 * i + c] = picture.texels[picture.channels * i + c];
    }
    rgba.texels[4 * i + 3] = 1.0f;
  }
  return rgba;
}

}  // namespace

void showSequence(Device& device, const std::vector<FloatImage*>& pictures, double frame_rate,
                  const std::function<bool(size_t)>& reset, const PostSettings& settings,
                  const PictureTimes& timed) {
  if (pictures.empty()) return;
  const VkExtent2D extent{pictures[0]->width, pictures[0]->height};
  const PostChain chain(device, extent, settings);
  const Image color(device, {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = extent});
  Timestamps timestamps(device);
  for (size_t i = 0; i < pictures.size(); ++i) {
    upload(device, color, withAlpha(*pictures[i]));
    device.submitAndWait([&](VkCommandBuffer commands) {
      timestamps.begin(commands);
      chain.record(commands, color, static_cast<float>(1.0 / frame_rate), i == 0 || reset(i),
                   &timestamps);
    });
    if (timed) timed(i, timestamps.milliseconds());
    FloatImage shown = download(device, chain.shown());
    for (float& value : shown.texels) value = eq::linearFromDisplay(value);
    *pictures[i] = std::move(shown);
  }
}

}  // namespace reprise::lab
