#!/usr/bin/python3
"""Measures whole runs of isoloop, and what one might run instead, on shapes and real volumes.

    tests/bench/whole_runs.py [--sizes 64 128 256] [--noise 32 48 64] [--repeat 5]
                              [--rivals NAME ...] [--only NAME ...] [--threads 1 2]
                              [--max-seconds S] [--isoloop PROGRAM] [--data FOLDER] -o RUNS.csv

One line for each volume, program and number of threads: CPU and wall-clock seconds, peak memory and
the CPU seconds of each stage, as `isoloop bench` measures them (medians over --repeat); of `isoloop
count` and of rivals those of the whole process. --sizes is of shapes, --noise of white noise.
tests/bench/report.py makes tables and a plot of it. Rivals are gudhi, skimage
and vtk (python3-gudhi, python3-skimage, python3-vtk9) and phat (target isoloop_bench_phat); those
that are not there are left out."""

import argparse
import csv
import gzip
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHAPES = {name: [name] for name in ("ball", "engine_block", "gyroid", "lattice", "linked_tori",
                                    "nested_tori", "plate", "shell", "torus", "trefoil")}
SHAPES["lattice_7"] = ["lattice", "--cells", "7"]  # b1 = 833
SHEET_SIZE = 128
REAL = [("engine", "engine_256x256x128_uint8.raw", 70, 1),
        ("engine_half", "engine_half_128x128x64_uint8.raw", 70, 1),
        ("engine_doubled", "engine_256x256x128_uint8.raw", 70, 2),  # each voxel eight times
        ("aneurism", "aneurism_256x256x256_uint8.raw", 51, 1),
        ("hydrogen", "hydrogen_128x128x128_uint8.raw", 15, 1),
        ("fuel", "fuel_64x64x64_uint8.raw", 15, 1),
        ("knee", "MRknee_128x128x128_uint8.raw", 80, 1),
        ("bonsai", "bonsai_256x256x256_uint8.nii.gz", 40, 1)]
STAGES = ["read", "surface", "closest", "sizes", "pass", "loops", "checks"]
COLUMNS = ["volume", "size", "voxels", "program", "threads", "cpu_s", "wall_s", "peak_bytes",
           "bytes_per_voxel", "genus", "triangles", "slowest_s", *STAGES, "result"]
RIVALS = ["gudhi", "phat", "skimage", "vtk"]


class Volume:
    def __init__(self, name, size, voxels, flags, array):
        self.name, self.size, self.voxels, self.flags, self.array = name, size, voxels, flags, array


def timed(command):
    """(stdout, CPU seconds, wall seconds, peak bytes) of a process; None where it fails."""
    start = time.monotonic()
    with tempfile.TemporaryFile() as out:
        process = subprocess.Popen([str(word) for word in command], stdout=out,
                                   stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        wall = time.monotonic() - start
        out.seek(0)
        text = out.read().decode()
    if process.returncode != 0:
        print(f"exit code {process.returncode}: {shlex.join(str(w) for w in command)}",
              file=sys.stderr)
        return None
    return text, usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss * 1024


def run_count(arguments, volume):
    measured = timed([arguments.isoloop, "count", *volume.flags, "--json", "-"])
    if measured is None:
        return None
    text, cpu, wall, peak = measured
    report = json.loads(text)
    return {"program": "isoloop count", "threads": os.cpu_count(), "cpu_s": cpu, "wall_s": wall,
            "peak_bytes": peak, "genus": report["surface"]["genus"],
            "triangles": report["surface"]["triangles"],
            "result": f"{report['betti']['b1']} tunnels",
            **{stage: report["seconds"].get(stage, 0.0) for stage in STAGES}}


def run_loops(arguments, volume):
    """One row for each number of threads, by `isoloop bench`."""
    limit = ["--max-seconds", arguments.max_seconds] if arguments.max_seconds else []
    command = [arguments.isoloop, "bench", "--file", *volume.flags, *limit,
               "--threads", ",".join(map(str, arguments.threads)),
               "--repeat", arguments.repeat, "--json", "-"]
    ran = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if ran.returncode != 0:
        print(f"{volume.name}: {ran.stderr.strip()}", file=sys.stderr)
        return
    for run in json.loads(ran.stdout)["runs"]:
        row = {"program": "isoloop loops", "threads": run["threads"]}
        if run["failure"]:
            print(f"{volume.name}: {run['failure']}", file=sys.stderr)
            yield {**row, "result": run["failure"]}
            continue
        stages = {stage["stage"]: stage for stage in run["stages"]}
        whole = stages["all"]
        yield {**row, "cpu_s": whole["cpu_seconds"], "wall_s": whole["wall_seconds"],
               "peak_bytes": whole["peak_bytes"], "genus": run["genus"],
               "triangles": run["triangles"], "slowest_s": run["slowest_loops_seconds"],
               "result": f"{run['loops']} loops",
               **{stage: stages[stage]["cpu_seconds"] if stage in stages else 0.0
                  for stage in STAGES}}


def run_rival(name, phat, volume, work):
    if name == "phat":
        if not phat.exists():
            print(f"needs {phat}", file=sys.stderr)
            return None
        file, iso, side = volume.flags[0], volume.flags[volume.flags.index("--iso") + 1], "above"
        if "below" in volume.flags:
            side = "below"
        measured = timed([phat, file, iso, side])
        if measured is None:
            return None
        text, cpu, wall, peak = measured
        return {"program": name, "threads": 1, "cpu_s": cpu, "wall_s": wall, "peak_bytes": peak,
                "result": text.strip()}
    array, iso = volume.array()
    file = work / "rival.npy"
    numpy.save(file, array)
    measured = timed(["/usr/bin/python3", ROOT / "tests/bench/rivals.py", name, file, iso])
    if measured is None:
        return None
    text, _, wall, peak = measured
    seconds, result = text.strip().split(" ", 1)
    return {"program": name, "threads": 1, "cpu_s": float(seconds), "wall_s": wall,
            "peak_bytes": peak, "result": result}


def shape_volume(isoloop, name, size, work):
    path = work / f"{name}_{size}.raw"
    made = subprocess.run([isoloop, "generate", *SHAPES[name], "--size", str(size), "-o", path],
                          capture_output=True, text=True)
    if made.returncode != 0:
        print(made.stderr.strip(), file=sys.stderr)
        return None
    # generate tells the command that reads its file.
    flags = shlex.split(made.stderr.split("isoloop loops ", 1)[1].splitlines()[0])
    place = flags.index("--dims")
    dims = [int(n) for n in flags[place + 1:place + 4]]
    path = path.rename(work / f"{name}_{'x'.join(map(str, dims))}_float32.raw")
    flags = [path, *flags[flags.index("--inside"):]]
    voxels = dims[0] * dims[1] * dims[2]

    def array():
        values = numpy.fromfile(path, numpy.float32).reshape(dims, order="F")
        return -values, 0.0  # inside is below

    return Volume(name, size, voxels, flags, array)


def raw_volume(work, name, values, iso):
    """`values`: indexed [x, y, z]; inside is at or above `iso`."""
    dims = values.shape
    path = work / f"{name}_{'x'.join(map(str, dims))}_{values.dtype}.raw"
    values.ravel(order="F").tofile(path)
    return Volume(name, max(dims), values.size, [path, "--iso", iso], lambda: (values, iso))


def noise_volume(work, size):
    values = numpy.random.default_rng(5).integers(0, 256, (size,) * 3).astype(numpy.uint8)
    return raw_volume(work, "noise", values, 128)


def sheet_volume(work):
    """A gyroid that is a sheet, of six periods, cut off by the box."""
    angles = 12 * numpy.pi * numpy.arange(SHEET_SIZE) / SHEET_SIZE
    x, y, z = numpy.meshgrid(angles, angles, angles, indexing="ij")
    sin, cos = numpy.sin, numpy.cos
    values = 0.5 - abs(sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x))
    return raw_volume(work, "gyroid_sheet", values.astype(numpy.float32), 0)


def read_voxels(path, dims):
    if path.suffix != ".gz":
        return numpy.fromfile(path, numpy.uint8).reshape(dims, order="F")
    voxels = dims[0] * dims[1] * dims[2]
    with gzip.open(path) as file:  # NIfTI: the voxels are the end of the file
        return numpy.frombuffer(file.read()[-voxels:], numpy.uint8).reshape(dims, order="F")


def real_volume(data, work, name, file, iso, factor):
    path = data / "volumes" / file
    if not path.exists():
        print(f"needs {path}", file=sys.stderr)
        return None
    dims = [int(n) for n in file.rsplit("_", 2)[1].split("x")]
    if factor > 1:
        values = read_voxels(path, dims)
        for axis in range(3):
            values = values.repeat(factor, axis)
        return raw_volume(work, name, values, iso)

    def array():
        return read_voxels(path, dims), iso

    return Volume(name, max(dims), dims[0] * dims[1] * dims[2], [path, "--iso", iso], array)


def measure(arguments, volume, work, out):
    def write(row):
        if row is None:
            return
        row = {**row, "volume": volume.name, "size": volume.size, "voxels": volume.voxels}
        if "peak_bytes" in row:
            row["bytes_per_voxel"] = row["peak_bytes"] / volume.voxels
        out.writerow({key: f"{value:.4f}" if isinstance(value, float) else value
                      for key, value in row.items()})

    write(run_count(arguments, volume))
    for row in run_loops(arguments, volume):
        write(row)
    for name in arguments.rivals:
        write(run_rival(name, arguments.phat, volume, work))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    build = ROOT / "build/release"
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--sizes", type=int, nargs="*", default=[64, 128, 256])
    parser.add_argument("--noise", type=int, nargs="*", default=[32, 48, 64])
    parser.add_argument("--repeat", type=int, default=1)
    parser.add_argument("--max-seconds", type=float, help="of a run of isoloop loops")
    parser.add_argument("--threads", type=int, nargs="*", default=[1, os.cpu_count()])
    parser.add_argument("--rivals", nargs="*", choices=RIVALS, default=[],
                        help="gudhi and phat take minutes and gigabytes at 256")
    parser.add_argument("--only", nargs="*", help="names of shapes and real volumes")
    parser.add_argument("--isoloop", type=pathlib.Path, default=build / "tools/isoloop")
    parser.add_argument("--phat", type=pathlib.Path,
                        default=build / "tests/bench/isoloop_bench_phat")
    parser.add_argument("--data", type=pathlib.Path, default=ROOT.parent / "shared/data")
    arguments = parser.parse_args()
    with (tempfile.TemporaryDirectory() as directory,
          open(arguments.output, "w", newline="") as file):
        work = pathlib.Path(directory)
        out = csv.DictWriter(file, COLUMNS)
        out.writeheader()
        wanted = [lambda n=name, s=size: shape_volume(arguments.isoloop, n, s, work)
                  for size in arguments.sizes for name in SHAPES
                  if not arguments.only or name in arguments.only]
        if not arguments.only or "noise" in arguments.only:
            wanted += [lambda s=size: noise_volume(work, s) for size in arguments.noise]
        if not arguments.only or "gyroid_sheet" in arguments.only:
            wanted.append(lambda: sheet_volume(work))
        wanted += [lambda r=real: real_volume(arguments.data, work, *r) for real in REAL
                   if not arguments.only or real[0] in arguments.only]
        for make in wanted:
            volume = make()
            if volume is not None:
                measure(arguments, volume, work, out)
                file.flush()
            for path in work.iterdir():
                path.unlink()


if __name__ == "__main__":
    main()
