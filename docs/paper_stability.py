#!/usr/bin/python3
"""Prints the stability table of docs/paper.md, after figure 13 of the paper: the loops of the same
shapes at three resolutions, matched one to one, and how far their sizes and places move.

    docs/paper_stability.py [ISOLOOP]     (default: build/release/tools/isoloop)

Needs python3-scipy, which matches the loops so that centres and sizes move least in total."""

import json
import math
import pathlib
import shlex
import subprocess
import sys
import tempfile

import numpy
from scipy.optimize import linear_sum_assignment

FAR = 1e6  # voxels: no loop of finite size is matched with one of infinite size if it can be helped
MARGIN = 2.6  # shape_margin of volume/shapes/shape_field.h: voxels round a shape, on each side

# Name, and voxels along the longest axis: coarse, middle, fine.
SHAPES = [
    ("torus", (48, 72, 96)),
    ("linked_tori", (48, 72, 96)),
    ("nested_tori", (48, 72, 96)),
    ("trefoil", (48, 72, 96)),
    ("plate", (48, 72, 96)),
    ("lattice", (48, 72, 96)),
    ("engine_block", (104, 156, 208)),
]


def voxels_per_extent(size):
    return size - 1 - 2 * MARGIN


def loops_of(isoloop, name, size, engine, work):
    """Of each kind: (centre from the middle of the shape, size), in voxels of this resolution."""
    path = work / f"{name}_{size}.raw"
    made = subprocess.run(
        [isoloop, "generate", name, "--size", str(size), "-o", path],
        check=True, capture_output=True, text=True)
    # generate tells the command that reads its file.
    flags = shlex.split(made.stderr.split("isoloop loops ", 1)[1].splitlines()[0])
    run = subprocess.run([isoloop, "loops", *flags, "--engine", engine, "--json", "-"],
                         check=True, capture_output=True, text=True)
    report = json.loads(run.stdout)
    middle = [(n - 1) / 2 for n in report["input"]["dims"]]
    loops = {"handle": [], "tunnel": []}
    for loop in report["loops"]:
        centre = [x - m for x, m in zip(loop["center_index"], middle)]
        g = math.inf if loop["size"] is None else loop["size"]
        loops[loop["kind"]].append((centre, g))
    return loops


def size_move(a, b):
    if math.isinf(a) or math.isinf(b):
        return 0.0 if a == b else FAR
    return abs(a - b)


def moves(coarse, fine, scale):
    """Of each pair of matched loops, in coarse voxels: how far its place and its size moved."""
    scaled = [([x * scale for x in centre], g * scale) for centre, g in fine]
    place = [[math.dist(a[0], b[0]) for b in scaled] for a in coarse]
    size = [[size_move(a[1], b[1]) for b in scaled] for a in coarse]
    matched = list(zip(*linear_sum_assignment(numpy.add(place, size))))
    finite = [size[i][j] for i, j in matched if not math.isinf(coarse[i][1])]
    return [place[i][j] for i, j in matched], finite


def mean_and_most(values):
    if not values:
        return "inf | inf"
    return f"{sum(values) / len(values):.2f} | {max(values):.2f}"


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    isoloop = sys.argv[1] if len(sys.argv) > 1 else str(root / "build/release/tools/isoloop")
    print("| shape | engine | kind | loops | coarse size: mean | resolution | size: mean move | most |"
          " place: mean move | most |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as directory:
        for name, sizes in SHAPES:
            for engine in ("pair", "dual"):
                found = [loops_of(isoloop, name, size, engine, pathlib.Path(directory))
                         for size in sizes]
                for kind in ("handle", "tunnel"):
                    coarse = found[0][kind]
                    for size, other in zip(sizes[1:], found[1:]):
                        known = [g for _, g in coarse if not math.isinf(g)]
                        mean = f"{sum(known) / len(known):.1f}" if known else "inf"
                        start = f"| {name} | {engine} | {kind} | {len(coarse)}"
                        if len(other[kind]) != len(coarse):
                            print(f"{start}, {len(other[kind])} | {mean} | {sizes[0]} to {size} | | | | |")
                            continue
                        scale = voxels_per_extent(sizes[0]) / voxels_per_extent(size)
                        places, changes = moves(coarse, other[kind], scale)
                        print(f"{start} | {mean} | {sizes[0]} to {size} | {mean_and_most(changes)} |"
                              f" {mean_and_most(places)} |", flush=True)


if __name__ == "__main__":
    main()
