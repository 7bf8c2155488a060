#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each ingredient of reprise is worth: each off in turn, over every lab scene and the Blender
capture; prints the tables of src/techniques/reprise/effects.md. Frames are rendered once, as
captures kept in the directory given (default: ./reprise-captures). Half an hour on two quiet cores,
ten minutes with captures there."""
import json
import os
import subprocess
import sys
import tempfile

REPRISE = os.path.join(os.path.dirname(__file__), "..", "build", "bin", "reprise")
SIZE = ["--size", "320x180", "--frames", "24", "--samples", "64"]
# The defaults were chosen on these.
SEEN = ["brick/pan", "foliage/walk", "hangar/fly", "horse/gallop", "chart/pan"]
# On these they were only checked.
HELD_OUT = ["brick/rotate", "brick/zoom", "teapot/orbit", "indoor/fly"]
STILL = ["brick/still", "chart/still"]
FIGURES = ["psnr", "tpsnr", "flip", "flicker", "disoccluded"]

INGREDIENTS = [
    ("all", "reprise"),
    ("taa", "taa"),
    ("samples not weighted by distance", "reprise:sample_width=4"),
    ("history moved without lobes", "reprise:sharpness=0"),
    ("history moved by Lanczos alone", "reprise:sharpness=1"),
    ("no depth test", "reprise:depth_tolerance=1"),
    ("farthest depth of one frame", "reprise:far_frames=0"),
    ("what silhouettes leave counts as any", "reprise:history_uncovered=1e4"),
    ("always bounded by 1 deviation", "reprise:bound=1,bound_faint=1"),
    ("never bounded", "reprise:bound=1000,bound_faint=1000,bound_changed=1000,bound_still=1000,"
                      "bound_apart=1000"),
    ("faint content bounded as any", "reprise:bound_faint=3"),
    ("surfaces moving apart bounded as any", "reprise:bound_apart=3"),
    ("flips do not widen the bound", "reprise:flips=0"),
    ("bright samples weigh as any", "reprise:tone=0"),
    ("at rest bounded as in motion", "reprise:bound_still=3"),
    ("clipped history keeps its weight", "reprise:forget_clipped=0"),
    ("changed history keeps its weight", "reprise:forget_changed=0"),
    ("light not followed", "reprise:doubt_light=1e6"),
    ("no evidence of one frame", "reprise:doubt_now=1e6"),
    ("no evidence over frames", "reprise:doubt_mean=1e6"),
    ("no evidence", "reprise:doubt_light=1e6,doubt_now=1e6,doubt_mean=1e6"),
    ("64 samples held in motion", "reprise:history=64"),
    ("as short at rest as in motion", "reprise:still_history=4"),
]


def captured(directory, scene):
    path = os.path.join(directory, scene.replace("/", "-"))
    if not os.path.exists(os.path.join(path, "capture.json")):
        subprocess.run([REPRISE, "render", scene, "--plan", "reprise", "--reference", "-o", path,
                        *SIZE], stdout=sys.stderr, check=True)
    return path


def compared(path):
    with tempfile.TemporaryDirectory() as out:
        command = [REPRISE, "compare", path, "-t", *[t for _, t in INGREDIENTS], "--report-mib",
                   "1", "--quiet", "--json", "--metrics", "flip,tpsnr,flicker,disocclusion", "-o",
                   out]
        text = subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout
    runs = json.loads(text)["runs"]
    print(path, "done", file=sys.stderr, flush=True)
    return {run["technique"]: run["mean"] for run in runs}


def mean(runs, technique, figure):
    values = [run[technique].get(figure) for run in runs]
    values = [v for v in values if v is not None]
    return sum(values) / len(values) if values else None


def cells(runs, technique):
    base = "reprise"
    row = []
    for figure in FIGURES:
        value, at = mean(runs, technique, figure), mean(runs, base, figure)
        if value is None:
            row.append("-")
        elif technique == base:
            row.append(f"{value:.4f}" if figure in ("flip", "flicker") else f"{value:.2f}")
        elif figure == "flicker":
            row.append(f"x{value / at:.2f}")
        else:
            row.append(f"{value - at:+.4f}" if figure == "flip" else f"{value - at:+.2f}")
    return row


def table(title, runs):
    print(f"{title}:\n")
    print("| | PSNR | tPSNR | FLIP | flicker | disoccluded |")
    print("|---|---|---|---|---|---|")
    for name, technique in INGREDIENTS:
        print(f"| {name} | " + " | ".join(cells(runs, technique)) + " |")
    print(flush=True)


def main():
    directory = sys.argv[1] if len(sys.argv) > 1 else "reprise-captures"
    os.makedirs(directory, exist_ok=True)
    spheres = os.path.join(os.environ.get("REPRISE_DATA", ""), "blender-spheres")
    groups = [("In motion, scenes that the defaults were chosen on", SEEN),
              ("In motion, scenes that they were not chosen on", HELD_OUT), ("At rest", STILL)]
    for title, scenes in groups:
        table(f"{title} ({', '.join(scenes)})",
              [compared(captured(directory, scene)) for scene in scenes])
    if os.path.isdir(spheres):
        table("The Blender capture (looked at from the first)", [compared(spheres)])
    else:
        print("REPRISE_DATA holds no blender-spheres: no table of the capture", file=sys.stderr)


main()
