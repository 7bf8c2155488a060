// SPDX-License-Identifier: MIT
// Shared by GLSL and C++. Every compute shader of the library runs 8 x 8 invocations: one wave on
// 64-wide devices, two on 32-wide ones, and 8 x 8 tiles keep 3 x 3 neighbourhoods in the cache.
#ifndef REPRISE_CORE_WORKGROUP_H
#define REPRISE_CORE_WORKGROUP_H
#define REPRISE_WORKGROUP_SIZE 8
#endif
