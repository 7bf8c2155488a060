#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The four claims of phlm over ue4-taa on frames that no setting was chosen on: other stretches of
both cameras' paths, at another size. Prints the table of src/techniques/phlm/effects.md. Each
technique gets frames sampled as it asks; `ue4-taa` also those of phlm, which do not jitter in
motion (the paper gave all methods one input). Captures are kept in the directory given (default:
./phlm-held-out); a quarter of an hour on two quiet cores."""
from captures import captureDirectory, captured, compared

SEQUENCES = [("foliage/walk:from=3", "320x180"), ("foliage/walk:from=8", "320x180"),
             ("hangar/fly:from=3", "320x180"), ("hangar/fly:from=7", "320x180")]
COUNTS = ["--frames", "24", "--samples", "32"]
ON_ITS_INPUT = ["none", "fxaa", "ue4-taa", "phlm", "phlm:storage=packed", "phlm:preset=paper"]


def figures(directory, scene, size, plan, techniques):
    path = captured(directory, "-".join([scene, size, plan]), scene, plan,
                    ["--size", size, *COUNTS])
    runs = compared(path, techniques, "flicker,disocclusion,sharpness")
    return [runs[t]["mean"] for t in techniques]


def main():
    directory = captureDirectory("phlm-held-out")
    names = ["ue4-taa, its own jitter"] + ON_ITS_INPUT
    rows = [[] for _ in names]
    for scene, size in SEQUENCES:
        own = figures(directory, scene, size, "ue4-taa", ["ue4-taa"])
        same = figures(directory, scene, size, "phlm:jitter=none", ON_ITS_INPUT)
        for row, m in zip(rows, own + same):
            row.append(f"{m['psnr']:.2f}, {m['flicker']:.5f}, {m['disoccluded']:.2f}, "
                       f"{m['sharpness']:.3f}")
    print("| technique | " + " | ".join(f"{scene}, {size}" for scene, size in SEQUENCES) + " |")
    print("|---|" + "---|" * len(SEQUENCES))
    for name, row in zip(names, rows):
        print(f"| {name} | " + " | ".join(row) + " |")


main()
