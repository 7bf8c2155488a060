// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "lab/post/post_chain.h"

namespace reprise::lab {

// Sends linear pictures, RGBA or RGB of one extent, in order through a chain of their own. What
// comes back is linear again: the colour that the tone curve alone would show as the chain does, so
// that metrics and pictures need not know. `reset(i)`: the eye begins anew at picture i, as it does
// at the first. GPU times of a picture go to `timed`, null allowed.
using PictureTimes =
    std::function<void(size_t index, const std::vector<std::pair<std::string, double>>& spans)>;
void showSequence(Device& device, const std::vector<FloatImage*>& pictures, double frame_rate,
                  const std::function<bool(size_t)>& reset, const PostSettings& settings,
                  const PictureTimes& timed);

}  // namespace reprise::lab
