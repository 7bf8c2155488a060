// SPDX-License-Identifier: MIT
//
// Plants in the wind: leaves turn about their stems, branches swing, the whole leans.
#ifndef REPRISE_LAB_SWAY_GLSL
#define REPRISE_LAB_SWAY_GLSL

// Angular frequencies (rad/s), chosen by eye: two of a leaf's flutter without a common period, one
// of a branch.
const float kFlutter = 9.1;
const float kFlutterSlow = 3.7;
const float kSwing = 2.3;

// Angle (rad) of the turn about the sway's axis.
float swayAngle(GpuSway sway, vec4 wind) {
  float phase = sway.axis_phase.w;
  return sway.pivot_angle.w * length(wind.xyz) *
         (0.6 * sin(kFlutter * wind.w + phase) + 0.4 * sin(kFlutterSlow * wind.w + 2.0 * phase));
}

// Rodrigues' rotation.
vec3 turned(vec3 v, vec3 axis, float angle) {
  float c = cos(angle);
  float s = sin(angle);
  return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1.0 - c));
}

// How far the wind moves what is not turned, in the world (m).
vec3 swayPush_world(GpuSway sway, vec4 wind) {
  return wind.xyz * (sway.push.x + sway.push.y * sin(kSwing * wind.w + sway.push.z));
}

#endif
