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

#endif
