# SPDX-License-Identifier: MIT
"""Captures that a measuring script renders once and compares often. What goes wrong is said in one
line."""
import json
import os
import subprocess
import sys
import tempfile

REPRISE = os.path.normpath(os.path.join(os.path.dirname(__file__), "..", "build", "bin", "reprise"))


def ran(*arguments, **options):
    if not os.path.exists(REPRISE):
        sys.exit(f"{REPRISE} is not there: scripts/build makes it")
    done = subprocess.run([REPRISE, *arguments], check=False, **options)
    if done.returncode != 0:
        sys.exit(f"reprise {' '.join(arguments)}: exit code {done.returncode}")
    return done


def captureDirectory(name):
    """The first argument of the script, else `name`; made."""
    directory = sys.argv[1] if len(sys.argv) > 1 else name
    try:
        os.makedirs(directory, exist_ok=True)
    except OSError as error:
        sys.exit(f"{directory}: {error.strerror}")
    return directory


def captured(directory, name, scene, plan, switches):
    """Renders `scene` sampled as technique `plan` asks, with references; returns the folder. One that
    an earlier run filled is taken as it is, one that it left unfinished is finished."""
    path = os.path.join(directory, name.replace("/", "-").replace(":", "-"))
    if os.path.exists(os.path.join(path, "capture.json")):
        print(f"{path} is there and is not rendered again: remove it where the scene has changed",
              file=sys.stderr, flush=True)
    else:
        ran("render", scene, "--plan", plan, "--reference", "-o", path, "--resume", *switches,
            stdout=sys.stderr)
    return path


def compared(source, techniques, metrics, switches=()):
    """The runs of results.json by technique."""
    with tempfile.TemporaryDirectory() as out:
        text = ran("compare", source, "-t", *techniques, "--report-mib", "1", "--quiet", "--json",
                   "--metrics", metrics, "-o", out, *switches, stdout=subprocess.PIPE).stdout
    return {run["technique"]: run for run in json.loads(text)["runs"]}
