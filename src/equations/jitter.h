// SPDX-License-Identifier: MIT
//
// Where in the pixel a frame samples: offsets from the pixel centre in px, x right, y down, within
// (-0.5, 0.5]. The jitter of the frame is the negative: sample_px = centre - jitter_px. All are
// pure functions of the index.
#ifndef REPRISE_EQUATIONS_JITTER_H
#define REPRISE_EQUATIONS_JITTER_H

#include "equations/language.h"
EQ_BEGIN

EQ_CONST uint kSequenceNone = 0u;
EQ_CONST uint kSequenceHalton = 1u;
EQ_CONST uint kSequenceR2 = 2u;
EQ_CONST uint kSequenceSobol = 3u;
EQ_CONST uint kSequenceNRooks = 4u;
EQ_CONST uint kSequenceRotatedGrid = 5u;
EQ_CONST uint kSequenceMsaa8 = 6u;
EQ_CONST uint kSequenceHelix = 7u;
EQ_CONST uint kSequenceBlueNoise = 8u;  // equations/blue_noise.h: no closed form

// Digits of `index` in `base`, mirrored about the point: Halton 1960. [0, 1).
EQ_FN float radicalInverse(uint base, uint index) {
  float inverse_base = 1.0f / float(base);
  float scale = inverse_base;
  float result = 0.0f;
  for (uint i = index; i > 0u; i /= base) {
    result += float(i % base) * scale;
    scale *= inverse_base;
  }
  return result;
}

// Halton(2,3) from index 1, as shipped in most engines.
EQ_FN vec2 haltonOffset(uint index) {
  return vec2(radicalInverse(2u, index + 1u) - 0.5f, radicalInverse(3u, index + 1u) - 0.5f);
}

// Roberts 2018: additive recurrence by the reciprocals of the plastic number and its square.
// Written in 32-bit fixed point, so that high indices keep their fraction: multiples of round(2^32
// / g).
EQ_FN vec2 r2Offset(uint index) {
  uint x = 0x80000000u + (index + 1u) * 3242174889u;
  uint y = 0x80000000u + (index + 1u) * 2447445414u;
  return vec2(float(x >> 8u) * (1.0f / 16777216.0f) - 0.5f,
              float(y >> 8u) * (1.0f / 16777216.0f) - 0.5f);
}

EQ_FN uint reverseBits(uint v) {
  v = ((v >> 1u) & 0x55555555u) | ((v & 0x55555555u) << 1u);
  v = ((v >> 2u) & 0x33333333u) | ((v & 0x33333333u) << 2u);
  v = ((v >> 4u) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4u);
  v = ((v >> 8u) & 0x00ff00ffu) | ((v & 0x00ff00ffu) << 8u);
  return (v >> 16u) | (v << 16u);
}

// Second dimension of Sobol's sequence; the first is reverseBits. Direction numbers 1, 3, 5, 15
// ...: each is the one before xor itself shifted (Sobol 1967; Burley 2020).
EQ_FN uint sobolSecond(uint index) {
  uint result = 0u;
  uint direction = 0x80000000u;
  for (uint i = index; i > 0u; i >>= 1u) {
    if ((i & 1u) != 0u) result ^= direction;
    direction ^= direction >> 1u;
  }
  return result;
}

// Owen scrambling by a hash of the bits above each bit: Laine, Karras 2011, constants of Vegdahl as
// in Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4).
EQ_FN uint owenScramble(uint v, uint seed) {
  uint x = reverseBits(v);
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return reverseBits(x);
}

// Both dimensions scrambled by seeds of their own. [0, 1)^2.
EQ_FN vec2 owenSobol(uint index, uint seed) {
  uint x = owenScramble(reverseBits(index), seed * 2654435769u + 0x68bc21ebu);
  uint y = owenScramble(sobolSecond(index), seed * 2654435769u + 0x02e5be93u);
  return vec2(float(x >> 8u) * (1.0f / 16777216.0f), float(y >> 8u) * (1.0f / 16777216.0f));
}

// Unscrambled Sobol, in the middle of its finest cell for cycles of up to 2^16.
EQ_FN vec2 sobolOffset(uint index, uint length) {
  float half_cell = 0.5f / float(length);
  float x = float(reverseBits(index) >> 8u) * (1.0f / 16777216.0f);
  float y = float(sobolSecond(index) >> 8u) * (1.0f / 16777216.0f);
  return vec2(x + half_cell - 0.5f, y + half_cell - 0.5f);
}

EQ_FN uint greatestCommonDivisor(uint a, uint b) {
  while (b != 0u) {
    uint rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

// A multiplier near length / golden ratio that shares no factor with `length`: x -> k x mod length
// is then a permutation, and a near-golden k spreads it.
EQ_FN uint rookStep(uint length) {
  uint step = uint(float(length) * 0.618034f + 0.5f);
  if (step == 0u) step = 1u;
  while (greatestCommonDivisor(step, length) != 1u) step += 1u;
  return step;
}

// N-rooks (Shirley 1991): each of `length` columns and rows is used once. A rank-1 lattice, whose
// columns are visited in golden-ratio steps so that neighbouring frames lie apart. Modulo 4 and 6
// every multiplier gives a diagonal; there 1..length modulo the prime length + 1 is the
// permutation.
EQ_FN vec2 nRooksOffset(uint index, uint length) {
  uint step = rookStep(length);
  uint column = (index * step) % length;
  uint row = (column * step) % length;
  if (length == 4u || length == 6u) {
    row = ((column + 1u) * rookStep(length + 1u)) % (length + 1u) - 1u;
  }
  return vec2((float(column) + 0.5f) / float(length) - 0.5f,
              (float(row) + 0.5f) / float(length) - 0.5f);
}

// Vulkan's standard 4-sample positions, the rotated grid, in the order that keeps neighbours apart.
EQ_FN vec2 rotatedGridOffset(uint index) {
  uint i = index % 4u;
  if (i == 0u) return vec2(-0.125f, -0.375f);
  if (i == 1u) return vec2(0.125f, 0.375f);
  if (i == 2u) return vec2(0.375f, -0.125f);
  return vec2(-0.375f, 0.125f);
}

// Vulkan's standard 8-sample positions, in sixteenths from the pixel corner.
EQ_FN vec2 msaa8Offset(uint index) {
  uint i = index % 8u;
  float x = 1.0f;
  float y = 1.0f;
  if (i == 0u) {
    x = 9.0f;
    y = 5.0f;
  }
  if (i == 1u) {
    x = 7.0f;
    y = 11.0f;
  }
  if (i == 2u) {
    x = 13.0f;
    y = 9.0f;
  }
  if (i == 3u) {
    x = 5.0f;
    y = 3.0f;
  }
  if (i == 4u) {
    x = 3.0f;
    y = 13.0f;
  }
  if (i == 5u) {
    x = 1.0f;
    y = 7.0f;
  }
  if (i == 6u) {
    x = 11.0f;
    y = 15.0f;
  }
  if (i == 7u) {
    x = 15.0f;
    y = 1.0f;
  }
  return vec2(x / 16.0f - 0.5f, y / 16.0f - 0.5f);
}

// Vulkan's standard positions of 16 samples, likewise: both sixteenths of a sample in one byte, x
// in the low half, four samples a word.
EQ_FN vec2 msaa16Offset(uint index) {
  uint i = index % 16u;
  uint word = i < 4u ? 0x7ca55799u : i < 8u ? 0x3bbdda63u : i < 12u ? 0xc22418e6u : 0x01fe4f80u;
  uint packed_position = (word >> (8u * (i % 4u))) & 255u;
  return vec2(float(packed_position & 15u) / 16.0f - 0.5f,
              float(packed_position >> 4u) / 16.0f - 0.5f);
}

// And of 2: the three quarters and the quarter of the diagonal.
EQ_FN vec2 msaa2Offset(uint index) {
  return vec2(index % 2u == 0u ? 0.25f : -0.25f);
}

// Uniform4 helix of INSIDE (Pedersen 2016): quarter points, diagonal after diagonal.
EQ_FN vec2 helixOffset(uint index) {
  uint i = index % 4u;
  if (i == 0u) return vec2(-0.25f, -0.25f);
  if (i == 1u) return vec2(0.25f, 0.25f);
  if (i == 2u) return vec2(0.25f, -0.25f);
  return vec2(-0.25f, 0.25f);
}

// Length of a Halton cycle that covers the output pixels when the output has `scale` times the
// input's pixels an axis: 8, 18, 32 for 1, 1.5, 2 (FSR 2).
EQ_FN uint upscalingLength(float scale) {
  return uint(8.0f * scale * scale);
}

// Frames after which `sequence` repeats when `length` are asked for: fixed patterns keep their own.
EQ_FN uint jitterPeriod(uint sequence, uint length) {
  if (sequence == kSequenceNone) return 1u;
  if (sequence == kSequenceRotatedGrid || sequence == kSequenceHelix) return 4u;
  if (sequence == kSequenceMsaa8) return 8u;
  return length;
}

// Every sequence but blue noise. `index` < `length` = jitterPeriod(sequence, ...).
EQ_FN vec2 closedFormOffset(uint sequence, uint index, uint length) {
  if (sequence == kSequenceHalton) return haltonOffset(index);
  if (sequence == kSequenceR2) return r2Offset(index);
  if (sequence == kSequenceSobol) return sobolOffset(index, length);
  if (sequence == kSequenceNRooks) return nRooksOffset(index, length);
  if (sequence == kSequenceRotatedGrid) return rotatedGridOffset(index);
  if (sequence == kSequenceMsaa8) return msaa8Offset(index);
  if (sequence == kSequenceHelix) return helixOffset(index);
  return vec2(0.0f, 0.0f);
}

EQ_END
#endif
