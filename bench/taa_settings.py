#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures what each setting of taa does alone: every variant against the defaults, over a moving
and a still wall, a moving chart and, where REPRISE_DATA holds it, a Blender capture. Prints the
table of src/techniques/taa/README.md. About fifteen minutes on two cores."""
import json
import os
import subprocess
import sys
import tempfile

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


def main():
    reprise = os.path.join(os.path.dirname(__file__), "..", "build", "bin", "reprise")
    sources = ["brick/pan", "brick/still", "chart/pan"]
    spheres = os.path.join(os.environ.get("REPRISE_DATA", ""), "blender-spheres")
    if os.path.isdir(spheres):
        sources.append(spheres)
    techniques = ["taa"] + ["taa:" + variant for variant in VARIANTS]
    with tempfile.TemporaryDirectory() as directory:
        command = [reprise, "compare", *sources, "-t", *techniques, "--size", "384x216",
                   "--frames", "24", "--samples", "128", "--report-mib", "1", "--quiet", "--json",
                   "-o", directory, *sys.argv[1:]]
        output = subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout
        runs = json.loads(output)["runs"]
    names = list(dict.fromkeys(run["source"] for run in runs))
    figures = {(run["source"], run["technique"]): run["mean"] for run in runs}
    title = [os.path.basename(name) if os.path.isdir(name) else name for name in names]
    print("| setting | " + " | ".join(f"{name}: PSNR, FLIP, tPSNR" for name in title) + " |")
    print("|---|" + "---|" * len(names))
    for technique in techniques:
        cells = []
        for name in names:
            here, base = figures[name, technique], figures[name, "taa"]
            if technique == "taa":
                cells.append(f"{here['psnr']:.2f}, {here['flip']:.4f}, {here['tpsnr']:.2f}")
            else:
                cells.append(", ".join([f"{here['psnr'] - base['psnr']:+.2f}",
                                        f"{here['flip'] - base['flip']:+.4f}",
                                        f"{here['tpsnr'] - base['tpsnr']:+.2f}"]))
        label = "defaults" if technique == "taa" else technique[4:].replace(",", ", ")
        print(f"| {label} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
