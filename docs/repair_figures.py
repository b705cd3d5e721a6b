#!/usr/bin/python3
"""Measures what `isoloop repair --fill-tunnels SIZE` changes, for docs/repair.md.

    docs/repair_figures.py VOLUME_XxYxZ_uint8.raw ISO SIZE [ISOLOOP]

For each tunnel that is filled: the voxels changed; its cross-section, which is the area that its
loop spans, in voxels; the voxels in the bounding box of its feature (`loops --labels`); and the
excess, voxels changed beyond the cross-section, as a share of that box. Wants python3-numpy."""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy


def spanned_area(curves):
    """Half the length of the sum of cross products: exact for plane curves."""
    total = numpy.zeros(3)
    for curve in curves:
        points = numpy.array(curve)
        total += numpy.cross(points, numpy.roll(points, -1, axis=0)).sum(axis=0) / 2
    return numpy.linalg.norm(total)


def read_labels(path):
    data = path.read_bytes()
    header, voxels = data.split(b"\n\n", 1)
    fields = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line)
    kind = {"uint16": "<u2", "unsigned short": "<u2", "uint8": "u1", "uchar": "u1"}[fields["type"]]
    return numpy.frombuffer(voxels, kind).reshape([int(n) for n in fields["sizes"].split()],
                                                  order="F")


def run(*command):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)


def main():
    volume = pathlib.Path(sys.argv[1])
    iso, size = sys.argv[2:4]
    isoloop = sys.argv[4] if len(sys.argv) > 4 else "build/release/tools/isoloop"
    dims = [int(n) for n in volume.stem.split("_")[-2].split("x")]
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        run(isoloop, "loops", volume, "--iso", iso, "--quiet", "--labels", work / "labels.nrrd",
            "--json", work / "loops.json")
        repaired = work / volume.name
        run(isoloop, "repair", volume, "--iso", iso, "--fill-tunnels", size,
            "-o", repaired, "--json", work / "repair.json")
        labels = read_labels(work / "labels.nrrd")
        loops = json.loads((work / "loops.json").read_text())["loops"]
        report = json.loads((work / "repair.json").read_text())
        before, after = (numpy.fromfile(path, numpy.uint8).reshape(dims, order="F")
                         for path in (volume, repaired))
    tunnels = [loop for loop in loops if loop["kind"] == "tunnel"]
    if report["rounds"] != 1:
        sys.exit("more than one round: ids of later ones are not those of the loops")
    removed = {removal["id"]: removal["voxels"] for removal in report["removals"]}
    print("| tunnel | length | cross-section | voxels changed | of the cross-section "
          "| feature's box | excess of the box |")
    print("|---|---|---|---|---|---|---|")
    boxes = excess = 0
    ratios = []
    for loop in tunnels:
        if loop["id"] not in removed:
            continue
        area = spanned_area(loop["curves"])
        voxels = removed[loop["id"]]
        places = numpy.argwhere(labels == loop["feature"]["label"])
        box = int(numpy.prod(numpy.ptp(places, axis=0) + 1))
        more = max(0.0, voxels - area)
        boxes += box
        excess += more
        ratios.append(voxels / area)
        print(f"| {loop['id']} | {loop['length']:.1f} | {area:.1f} | {voxels} "
              f"| {voxels / area:.2f} | {box} | {more / box:.2%} |")
    short = sorted(loop["id"] for loop in tunnels if loop["length"] < float(size))
    print()
    print(f"Tunnels shorter than {size}: {short}; filled: {sorted(removed)}; "
          f"genus {report['before']['genus']} to {report['after']['genus']}; "
          f"voxels that differ: {numpy.count_nonzero(before != after)}. "
          f"Median of voxels over cross-section: {numpy.median(ratios):.2f}. "
          f"Excess: {excess / boxes:.2%} of the boxes' voxels.")


if __name__ == "__main__":
    main()
