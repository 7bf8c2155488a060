// SPDX-License-Identifier: MIT
//
// A scene for tests alone: a tilted board of bricks before the sky, smaller than the frame, so that
// it has silhouettes, under one light and one more of the deferred layer.
#pragma once

#include "lab/scene/scene.h"

namespace reprise::lab {

// "still", or "pan" at some pixels a frame.
SceneRun boardRun(const char* camera);

}  // namespace reprise::lab
