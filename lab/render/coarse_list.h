// SPDX-License-Identifier: MIT
//
// How the list of coarse pixels is laid out, in GLSL and C++. Not in frame_data.h: a new constant
// there renumbers the ids of every shader, and with them the hashes of references.
#ifndef REPRISE_LAB_COARSE_LIST_H
#define REPRISE_LAB_COARSE_LIST_H

#include "core/workgroup.h"
#include "lab/render/frame_data.h"

#ifdef __cplusplus
#define COARSE_FN constexpr
namespace reprise::lab {
#else
#define COARSE_FN
#endif

// Evaluations a workgroup of coarse.comp.
LAB_CONST kCoarseGroup = 64u;

// Strips of the frame, a list each. CPU drivers have threads list far parts of a frame at once: in
// one list for all, pieces of both would alternate, and a subgroup between two pieces waits for
// whichever light tile has more lamps. Neighbours of one strip have much the same. Twice the
// threads that it was measured on; each invocation of coarse.comp goes through the counts of all.
LAB_CONST kStrips = 4u;

// Along an axis: one more than fit where the grid begins inside the first, and one for the rest of
// a division.
COARSE_FN uint listedCoarsePixels(uint extent_px, uint size) {
  return extent_px / size + 2u;
}
// Workgroups of coarse_list.comp, along an axis.
COARSE_FN uint listGroups(uint extent_px, uint size) {
  uint side = uint(REPRISE_WORKGROUP_SIZE);
  return (listedCoarsePixels(extent_px, size) + side - 1u) / side;
}
COARSE_FN uint stripGroups(uint height_px, uint size) {  // rows of them
  return (listGroups(height_px, size) + kStrips - 1u) / kStrips;
}
// Items of a strip: one a pixel at most.
COARSE_FN uint stripCapacity(uint width_px, uint height_px, uint size) {
  uint side_px = uint(REPRISE_WORKGROUP_SIZE) * size;
  return stripGroups(height_px, size) * listGroups(width_px, size) * side_px * side_px;
}

#ifdef __cplusplus
}  // namespace reprise::lab
#endif
#endif
