#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each setting of taa does alone: prints the table of src/techniques/taa/README.md. About
fifteen minutes on two cores."""
from setting_effects import printTable

VARIANTS = """
jitter=none jitter=halton jitter=n-rooks jitter=sobol jitter=rotated-grid jitter=msaa8 jitter=helix
jitter=blue-noise jitter_length=4 jitter_length=8 jitter_length=64 jitter_centred=false mip_bias=-1
input_filter=box,input_width=1 input_filter=tent,input_width=1 input_filter=mitchell,input_width=1
input_filter=blackman-harris,input_width=1 input_filter=gaussian dilation=none dilation=closest
dilation=longest history_filter=bilinear history_filter=catmull-rom-9 history_filter=lanczos
history_sharpness=0.5 history_sharpness=0.75 clip=none clip=minmax clip=rounded clip=kdop clip=cross
clip_toward=clamp clip_toward=sample clip_space=rgb gamma=0.75 gamma=1.5 gamma=2 clip_forget=0
clip_forget=1 weighting=luminance weighting=log alpha=0.05 alpha=0.1 alpha=0.15 alpha=0.3
anti_flicker=bounds anti_flicker=contrast speed_alpha=0.3,speed_px=4 depth_test=none
depth_test=pixel depth_tolerance=0.005 motion_tolerance_px=1 rejected_blur=true spatial_frames=0
offscreen=extend still_frames=0 still_frames=64 gamma_still=1 gamma_still=16 average=2 average=4
average=6 sharpen=0.3 sharpen=1 dither=false preset=fast
""".split()

printTable("taa", VARIANTS)
