#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The README's C blocks are the example's text, line for line; its links lead somewhere."""
import os
import re
import sys

root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
readme = open(os.path.join(root, "README.md"), encoding="utf-8").read()
example = open(os.path.join(root, "examples/minimal/minimal.c"), encoding="utf-8").read()
flat = "\n".join(line.strip() for line in example.split("\n"))
failures = []
blocks = re.findall(r"```c\n(.*?)```", readme, re.S)
if len(blocks) != 3:
    failures.append(f"README.md has {len(blocks)} C blocks, not 3")
for block in blocks:
    if "\n".join(line.strip() for line in block.strip().split("\n")) not in flat:
        failures.append("a C block of README.md is not in examples/minimal/minimal.c:\n" + block)
for folder, _, names in os.walk(root):
    if "/build" in folder or "/.git" in folder:
        continue
    for name in names:
        if not name.endswith(".md"):
            continue
        path = os.path.join(folder, name)
        for link in re.findall(r"\]\(([^)#]+)[^)]*\)", open(path, encoding="utf-8").read()):
            if "://" not in link and not os.path.exists(os.path.join(folder, link)):
                failures.append(f"{os.path.relpath(path, root)}: no such file: {link}")
print("\n".join(failures))
sys.exit(1 if failures else 0)
