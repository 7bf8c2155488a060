#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""PSNR, tPSNR and FLIP of every technique over every lab scene in motion, the best bold; a last
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
NAMES = {"psnr": "PSNR, dB", "tpsnr": "tPSNR, dB", "flip": "FLIP"}
FIGURES = {"psnr": (".2f", max), "tpsnr": (".2f", max), "flip": (".4f", min)}


def means(scene):
    runs = compared(scene, TECHNIQUES, "flip,tpsnr", SWITCHES)
    half = compared(scene, ["reprise"], "flip,tpsnr", [*SWITCHES, "--scale", "2"])
    print(scene, "done", file=sys.stderr, flush=True)
    return {**{t: runs[t]["mean"] for t in TECHNIQUES}, UPSAMPLED: half["reprise"]["mean"]}


def table(figure, of):
    """Rows are techniques; the best at the full extent is bold."""
    form, choose = FIGURES[figure]
    everywhere = {t: {figure: sum(of[s][t][figure] for s in of) / len(of)}
                  for t in [*TECHNIQUES, UPSAMPLED]}
    of = {**of, "mean": everywhere}
    best = {scene: choose(of[scene][t][figure] for t in TECHNIQUES) for scene in of}
    print(f"{NAMES[figure]}:\n\n| | " + " | ".join(of) + " |")
    print("|---|" + "---|" * len(of))
    for technique in [*TECHNIQUES, UPSAMPLED]:
        values = {scene: of[scene][technique][figure] for scene in of}
        cells = [f"**{v:{form}}**" if technique != UPSAMPLED and v == best[scene] else f"{v:{form}}"
                 for scene, v in values.items()]
        print(f"| {technique} | " + " | ".join(cells) + " |")
    print()


def main():
    scenes = sys.argv[1:] or SCENES
    of = {scene: means(scene) for scene in scenes}
    for figure in FIGURES:
        table(figure, of)
    above = [s for s in scenes if of[s][UPSAMPLED]["psnr"] > of[s]["taa"]["psnr"]]
    print(f"{UPSAMPLED} is above taa at the whole one, by PSNR, on {len(above)} of {len(scenes)} "
          f"scenes: {', '.join(above) or 'none'}")


main()
