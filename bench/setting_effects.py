# SPDX-License-Identifier: MIT
"""Measures what each setting of a technique does alone: every variant against the defaults, over a
moving and a still wall, a moving chart and, where REPRISE_DATA holds it, a Blender capture."""
import json
import os
import subprocess
import sys
import tempfile


def printTable(technique, variants):
    """Prints the table of the technique's page: a row a variant ("name=value" or several, separated by
    commas), differences from the defaults. Arguments of the script go to `reprise compare`."""
    reprise = os.path.join(os.path.dirname(__file__), "..", "build", "bin", "reprise")
    sources = ["brick/pan", "brick/still", "chart/pan"]
    spheres = os.path.join(os.environ.get("REPRISE_DATA", ""), "blender-spheres")
    if os.path.isdir(spheres):
        sources.append(spheres)
    techniques = [technique] + [technique + ":" + variant for variant in variants]
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
    for variant in techniques:
        cells = []
        for name in names:
            here, base = figures[name, variant], figures[name, technique]
            if variant == technique:
                cells.append(f"{here['psnr']:.2f}, {here['flip']:.4f}, {here['tpsnr']:.2f}")
            else:
                cells.append(", ".join([f"{here['psnr'] - base['psnr']:+.2f}",
                                        f"{here['flip'] - base['flip']:+.4f}",
                                        f"{here['tpsnr'] - base['tpsnr']:+.2f}"]))
        label = variant[len(technique) + 1:].replace(",", ", ") or "defaults"
        print(f"| {label} | " + " | ".join(cells) + " |")
