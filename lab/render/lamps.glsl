// SPDX-License-Identifier: MIT
// Local lights, and which of them a tile of the screen has. A mask and not a list: its order is
// that of the lamps, so that sums of light are the same bytes however the tile was binned.
#ifndef REPRISE_LAB_LAMPS_GLSL
#define REPRISE_LAB_LAMPS_GLSL

layout(binding = kLampsBinding, std430) readonly buffer Lamps {
  GpuLamp lamps[];
};
// kLampWords a tile.
layout(binding = kLampTilesBinding, std430) readonly buffer LampTiles {
  uint lamp_tiles[];
};

layout(constant_id = 6) const uint kLampCount = 0u;

// The tile of what is shaded. Set before every shading.
uint shown_light_tile = 0u;

void selectLightTile(ivec2 px) {
  uint tiles_x = (uint(frame.extent_px.x) + kLightTile_px - 1u) / kLightTile_px;
  shown_light_tile = uint(px.y) / kLightTile_px * tiles_x + uint(px.x) / kLightTile_px;
}

uint lampWords() {
  return (kLampCount + 31u) / 32u;
}

uint lampsOfTile(uint word) {
  return lamp_tiles[kLampWords * shown_light_tile + word];
}

// for (LampCursor c = beforeLamps(); toLamp(c); passLamp(c)) ... lampOf(c)
// One loop and not one inside another: CPU drivers run a loop's body once more than it has turns,
// which would be a light in each word.
struct LampCursor {
  uint word;
  uint bits;  // of the word, not passed yet
};

LampCursor beforeLamps() {
  return LampCursor(0u, kLampCount > 0u ? lampsOfTile(0u) : 0u);
}

bool toLamp(inout LampCursor c) {
  while (c.bits == 0u && c.word + 1u < lampWords()) {
    ++c.word;
    c.bits = lampsOfTile(c.word);
  }
  return c.bits != 0u;
}

void passLamp(inout LampCursor c) {
  c.bits &= c.bits - 1u;
}

uint lampOf(LampCursor c) {
  return 32u * c.word + uint(findLSB(c.bits));
}

#endif
