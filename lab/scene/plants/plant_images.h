// SPDX-License-Identifier: MIT
//
// Pictures for plants and the ground under them, drawn once when a scene is made.
#pragma once

#include "lab/scene/scene.h"

namespace reprise::lab {

// 2 x 2 leaves with veins and serrated edges on transparent ground, stems at low v.
SceneImage leafImage(float alpha_cutoff);
// Blades of grass side by side, roots at v = 0.
SceneImage grassImage(float alpha_cutoff);
// One blade's greens, all covered.
SceneImage bladeImage();
SceneImage barkImage();
SceneImage barkNormalImage();
SceneImage soilImage();
SceneImage soilNormalImage();
// Crowns of a wood seen from far above.
SceneImage canopyImage();
// A row of trees seen from far away, holes between and in their crowns, feet at v = 0.
SceneImage treeLineImage(float alpha_cutoff);
// Haze at v = 0, thin clouds above; what it shows is light.
SceneImage skyImage();

}  // namespace reprise::lab
