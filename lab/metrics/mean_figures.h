// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "lab/metrics/sequence_meter.h"

namespace reprise::lab {

// Over the counted frames that `takes` takes; nullopt without one. A figure's mean is over the
// frames that have it.
std::optional<MeanFigures> meanFigures(const std::vector<FrameFigures>& frames,
                                       const std::function<bool(const FrameFigures&)>& takes);
// Of all counted frames.
std::vector<AgeFigures> ageFigures(const std::vector<FrameFigures>& frames);

}  // namespace reprise::lab
