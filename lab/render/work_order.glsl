// SPDX-License-Identifier: MIT
//
// Which workgroup does what. CPU drivers give each thread one run of a dispatch's workgroups, and
// wait for the last: where one half of the frame takes longer, a core is idle at the end.
#ifndef REPRISE_LAB_WORK_ORDER_GLSL
#define REPRISE_LAB_WORK_ORDER_GLSL

// The i-th of `count` pieces of work, so that either half of the order has every second one.
uint everySecond(uint i, uint count) {
  uint first_half = (count + 1u) / 2u;
  return i < first_half ? 2u * i : 2u * (i - first_half) + 1u;
}

#endif
