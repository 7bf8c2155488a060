#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What each setting of phlm does alone, and what each storage form, jitter, share of updates and
input is worth: prints the tables of src/techniques/phlm/effects.md. Frames are rendered once, as
captures kept in the directory given (default: ./phlm-captures); a quarter of an hour on two quiet
cores, five minutes with captures and references there."""
import captures

SCENES = ["foliage/walk", "hangar/fly"]
SIZE = ["--size", "384x216", "--frames", "24", "--samples", "32"]  # as `reprise paper phlm`

EFFECTS = """
input_width=0 input_width=0.4 input_width=0.8 space=linear lambda=0.998 lambda=0.95 lambda=0.85
forgetting=constant forgetting=constant,lambda=0.95
forgetting=constant,lambda=0.95,initial_variance=1000,box_space=rgb,feature_floor=0.03
initial_variance=1000 slope_variance=0 slope_variance=1 slope_variance=100 variance_limit=10
clip=reset clip_variance=0.03 clip_variance=0.3 clip_variance=1000 box=rounded box=variance
box=variance,box_gamma=1.5 box_space=rgb box_feature=never box_feature=still
history_filter=bilinear dilation=none depth_tolerance=0.02 feature_a=0.25 feature_b=1
feature_floor=0 feature_floor=0.01 feature_floor=0.04 feature_floor=0.08 feature_weighs=old
low_pass=none low_pass=tent bilinear=shader update=half update=quarter preset=sharp
preset=paper preset=paper,dilation=none preset=paper,origin=feature
preset=paper,depth_tolerance=0.02 preset=paper,clip_variance=0.1 preset=paper,low_pass=box
preset=paper,space=compressed preset=paper,input_width=0.58
preset=paper,origin=feature,input_width=0.58
preset=paper,origin=feature,input_width=0.58,feature_floor=0.03,low_pass=box
""".split()
# At rest nothing of the above learns.
AT_REST = """
jitter_length=16 jitter_length=256 box_still=0 box_still=1 box_still=16 still_frames=0
still_frames=64 space=linear storage=symmetric storage=packed preset=paper
""".split()
STORAGE = ["storage=paper", "storage=symmetric", "storage=half", "storage=packed",
           "storage=paper,history_filter=bilinear", "storage=packed,history_filter=bilinear",
           "storage=paper,origin=zero", "storage=symmetric,origin=zero"]


def captured(directory, scene, plan, switches=()):
    return captures.captured(directory, "-".join([scene, plan, *switches]).replace("--", ""), scene,
                             plan, [*SIZE, *switches])


def compared(path, techniques):
    runs = captures.compared(path, techniques, "flicker,disocclusion,sharpness")
    return {technique: run["mean"] for technique, run in runs.items()}


def atRest(scene, techniques):
    runs = captures.compared(scene, techniques, "flicker", ["--size", "320x180", "--frames", "64",
                                                            "--samples", "64"])
    return {technique: run["frames"][-1]["psnr"] for technique, run in runs.items()}


def absolute(figures):
    return (f"{figures['psnr']:.2f}, {figures['flicker']:.5f}, {figures['disoccluded']:.2f}, "
            f"{figures['sharpness']:.3f}")


def difference(figures, base):
    return (f"{figures['psnr'] - base['psnr']:+.2f}, x{figures['flicker'] / base['flicker']:.2f}, "
            f"{figures['disoccluded'] - base['disoccluded']:+.2f}, "
            f"{figures['sharpness'] - base['sharpness']:+.3f}")


def table(first, columns, lines):
    print(f"| {first} | " + " | ".join(f"{c}: PSNR, flicker, disoccluded, sharpness"
                                        for c in columns) + " |")
    print("|---|" + "---|" * len(columns))
    for name, cells in lines:
        print(f"| {name} | " + " | ".join(cells) + " |")
    print()


def main():
    directory = captures.captureDirectory("phlm-captures")
    plain = {scene: captured(directory, scene, "phlm:jitter=none") for scene in SCENES}

    techniques = ["phlm"] + ["phlm:" + e for e in EFFECTS]
    runs = {scene: compared(plain[scene], techniques) for scene in SCENES}
    lines = [("defaults", [absolute(runs[s]["phlm"]) for s in SCENES])]
    for effect in EFFECTS:
        cells = [difference(runs[s]["phlm:" + effect], runs[s]["phlm"]) for s in SCENES]
        lines.append((effect.replace(",", ", "), cells))
    table("setting", SCENES, lines)

    runs = {scene: compared(plain[scene], ["phlm:" + s for s in STORAGE]) for scene in SCENES}
    table("storage", SCENES,
          [(s.replace(",", ", "), [absolute(runs[c]["phlm:" + s]) for c in SCENES])
           for s in STORAGE])

    # What is sampled otherwise is another capture.
    lines = []
    for name, plan, switches, techniques in [
            ("jitter=still", "phlm:jitter=none", (),
             ["none", "ue4-taa", "phlm", "phlm:preset=sharp"]),
            ("jitter=always", "phlm:jitter=always", (), ["none", "phlm", "phlm:preset=sharp"]),
            ("after FXAA", "phlm:jitter=none", (), ["fxaa", "phlm:input=fxaa,input_width=0"]),
            ("--spp 4", "phlm:jitter=none", ("--spp", "4"),
             ["none", "fxaa", "ue4-taa", "taa", "phlm", "phlm:preset=sharp"]),
            ("its own jitter", "ue4-taa", (), ["ue4-taa"]), ("its own jitter", "taa", (), ["taa"])]:
        runs = {s: compared(captured(directory, s, plan, switches), techniques) for s in SCENES}
        lines += [(f"{name}: {t}", [absolute(runs[s][t]) for s in SCENES]) for t in techniques]
    table("input", SCENES, lines)

    scenes = ["brick/still", "hangar/still"]
    techniques = ["taa", "phlm"] + ["phlm:" + e for e in AT_REST]
    runs = {scene: atRest(scene, techniques) for scene in scenes}
    print("| at rest | " + " | ".join(f"{s}: PSNR of frame 64" for s in scenes) + " |")
    print("|---|" + "---|" * len(scenes))
    for t in techniques:
        print(f"| {t} | " + " | ".join(f"{runs[s][t]:.2f}" for s in scenes) + " |")


main()
