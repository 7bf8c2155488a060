#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""PSNR / tPSNR / FLIP of every technique over every lab scene in motion, and which is best; a last
row has reprise with frames of half the extent per axis. Each technique gets frames sampled as it
asks, rendered anew, since their jitters differ; references come from the cache. Arguments: scenes,
instead of all. A quarter of an hour on two quiet cores."""
import sys

from captures import compared

SCENES = ["chart/pan", "brick/pan", "brick/rotate", "brick/zoom", "horse/gallop", "teapot/orbit",
          "teapot/lights", "indoor/fly", "foliage/walk", "hangar/fly", "lights/dolly"]
# All but ss, which shades sixteen times as much.
TECHNIQUES = ["none", "fxaa", "reprojection", "ue4-taa", "taa", "amortized", "phlm", "cps", "cpst",
              "checkerboard", "reprise"]
SWITCHES = ["--size", "320x180", "--frames", "24", "--samples", "64"]
UPSAMPLED = "reprise of half the extent"
FIGURES = {"psnr": (".2f", max), "tpsnr": (".2f", max), "flip": (".4f", min)}


def means(scene):
    runs = compared(scene, TECHNIQUES, "flip,tpsnr", SWITCHES)
    half = compared(scene, ["reprise"], "flip,tpsnr", [*SWITCHES, "--scale", "2"])
    print(scene, "done", file=sys.stderr, flush=True)
    return {**{t: runs[t]["mean"] for t in TECHNIQUES}, UPSAMPLED: half["reprise"]["mean"]}


def cell(mean):
    return " / ".join(f"{mean[figure]:{form}}" for figure, (form, _) in FIGURES.items())


def best(of):
    """The best technique by each figure, at the full extent."""
    names = [choose(TECHNIQUES, key=lambda t: of[t][figure])
             for figure, (_, choose) in FIGURES.items()]
    return names[0] if len(set(names)) == 1 else " / ".join(names)


def main():
    scenes = sys.argv[1:] or SCENES
    table = {scene: means(scene) for scene in scenes}
    print("| PSNR / tPSNR / FLIP | " + " | ".join(scenes) + " |")
    print("|---|" + "---|" * len(scenes))
    for technique in [*TECHNIQUES, UPSAMPLED]:
        print(f"| {technique} | " + " | ".join(cell(table[s][technique]) for s in scenes) + " |")
    print("| best | " + " | ".join(best(table[s]) for s in scenes) + " |")
    above = [s for s in scenes if table[s][UPSAMPLED]["psnr"] > table[s]["taa"]["psnr"]]
    print(f"\n{UPSAMPLED} is above taa at the whole one, by PSNR, on {len(above)} of {len(scenes)} "
          f"scenes: {', '.join(above) or 'none'}")


main()
