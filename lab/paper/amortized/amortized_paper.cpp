// SPDX-License-Identifier: MIT
//
// Yang et al. 2009 as a list of experiments.
#include "lab/paper/amortized/experiments.h"
#include "lab/paper/paper.h"

namespace reprise::lab {

Paper amortizedPaper();
Paper amortizedPaper() {
  using namespace amortized;
  return {.name = "amortized",
          .citation =
              "Yang, Nehab, Sander, Sitthi-amorn, Lawrence, Hoppe 2009, \"Amortized "
              "Supersampling\", ACM TOG 28(5)",
          .scale = {{384, 288}, 40, 8, 128, 64, 256, 5, false},
          .full = {{1024, 768}, 64, 4, 256, 256, 1024, 9, true},
          .experiments = {
              {"figure 1", "Close-ups", figure1},
              {"figure 3", "Blur of bilinear reprojection against equation (11)", figure3},
              {"figure 6", "Drift of the two update orders", figure6},
              {"figure 7", "Slices of the blur table", figure7},
              {"figure 8", "Blur tolerance", figure8},
              {"figure 9", "Adaptive evaluation where reprojection fails", figure9},
              {"figure 10", "Residual tolerance under moving lights", figure10},
              {"figure 11", "PSNR by frame: panning, rotation, zoom", figure11},
              {"figure 12", "PSNR by frame: animated and dynamically lit scenes", figure12},
              {"figure 13", "Gobo light amortized or deferred", figure13},
              {"figure 14", "Quality and cost of everything compared", figure14},
              {"time by price", "Time by the price of an evaluation", timeByPrice},
              {"limits", "Shading that moves over the surface", limits},
              {"memory", "Bytes at 1024 x 768", memory},
              {"silhouettes", "The whole pixel: silhouettes too", silhouettes},
          }};
}

}  // namespace reprise::lab
