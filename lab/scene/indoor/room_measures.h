// SPDX-License-Identifier: MIT
// The indoor scene's room and its two lamps, for the scene and for the mirrors that see the room
// (shading/room.glsl). x and z lie about 0, the floor at y = 0.
#ifndef REPRISE_LAB_ROOM_MEASURES_H
#define REPRISE_LAB_ROOM_MEASURES_H

#ifdef __cplusplus
namespace reprise::lab {
#define ROOM_CONST constexpr float
#else
#define ROOM_CONST const float
#endif

ROOM_CONST kRoomWidth_m = 8.0;
ROOM_CONST kRoomHeight_m = 3.2;
ROOM_CONST kRoomLength_m = 7.0;

ROOM_CONST kLampAX_m = -1.5;
ROOM_CONST kLampAZ_m = 0.6;
ROOM_CONST kLampBX_m = 1.6;
ROOM_CONST kLampBZ_m = -0.8;

#ifdef __cplusplus
}  // namespace reprise::lab
#endif
#undef ROOM_CONST

#endif
