// SPDX-License-Identifier: MIT
#include "lab/paper/paper.h"
#include "lab/paper/phlm/experiments.h"

namespace reprise::lab {

Paper phlmPaper();
Paper phlmPaper() {
  using namespace phlm;
  return {
      .name = "phlm",
      .citation =
          "Iglesias-Guitian, Moon, Koniaris, Smolikowski, Mitchell 2016, \"Pixel History "
          "Linear Models for Real-Time Temporal Filtering\", Computer Graphics Forum 35(7)",
      .scale = {{384, 216}, 24, 1, 24, 32, 32, 0, false},
      .full = {{1920, 1080}, 480, 1, 480, 256, 256, 0, true},
      .experiments = {
          {"table 2", "Quality and time of four methods", table2},
          {"figure 2", "The last frames, and insets at the same places", figure2},
          {"figure 3", "PSNR by frame: the open world", figure3},
          {"figure 4", "PSNR by frame: the space land", figure4},
          {"figure 5", "Samples a pixel and texture filters", figure5},
          {"figure 6", "Reflections on the hull", figure6},
          {"equal time", "FXAA at two samples a pixel, PHLM at one", equalTime},
          {"time split", "Time of the feature and of the filter, bytes of each storage", timeSplit},
      }};
}

}  // namespace reprise::lab
