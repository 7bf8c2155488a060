// SPDX-License-Identifier: MIT
#include "lab/paper/cpst/experiments.h"
#include "lab/paper/paper.h"

namespace reprise::lab {

Paper cpstPaper();
Paper cpstPaper() {
  using namespace cpst;
  return {.name = "cpst",
          .citation =
              "Xiao, Liktor, Vaidyanathan 2018, \"Coarse Pixel Shading with Temporal "
              "Supersampling\", I3D",
          .scale = {{480, 270}, 24, 8, 24, 32, 64, 0, false},
          .full = {{1920, 1080}, 120, 8, 120, 256, 256, 0, true},
          .experiments = {
              {"evaluations", "Shading evaluations at 1920 x 1080", evaluations},
              {"table 1", "Time of the passes, and evaluations", table1},
              {"table 2", "Time by the number of lights, and lights of each tile", table2},
              {"time by price", "Time by the price of an evaluation", timeByPrice},
              {"quality", "PS, CPS, CBR and CPS-T against the reference", quality},
              {"figure 1", "Crops of Bistro", figure1},
              {"figure 5", "The scale of the variance, and silhouettes", figure5},
              {"figure 6", "Jitter and shading filter", figure6},
              {"figure 7", "Shading that changes", figure7},
              {"figure 8", "Crops of Sponza and San Miguel", figure8},
              {"figure 9", "Evaluations along a camera's path", figure9},
              {"point sets", "Figures 2 and 4: samples of shading and of visibility", pointSets},
              {"disocclusion", "Maps of the disocclusion test; filling in", disocclusion},
              {"spread", "Shading where a triangle is covered, not beside it", spread},
              {"raster rate", "Coarse fragments beside the compute pass", rasterRate},
          }};
}

}  // namespace reprise::lab
