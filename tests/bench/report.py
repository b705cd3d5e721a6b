#!/usr/bin/python3
"""Tables, in Markdown, and a plot of what tests/bench/whole_runs.py measured.

    tests/bench/report.py RUNS.csv [--plot PLOT.svg]

Stages are CPU seconds. Needs python3-matplotlib for the plot."""

import argparse
import collections
import csv
import math
import statistics

STAGES = ["surface", "closest", "sizes", "pass", "loops"]
GIB = 2.0 ** 30
LEAST_GENUS = 100  # of what the table of growth with genus shows


def medians(path):
    """(volume, size, program, threads) to a row of medians, in the order of the file. What failed
    is left out."""
    runs = collections.defaultdict(list)
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            if row["cpu_s"] == "":
                continue
            key = (row["volume"], int(row["size"]), row["program"], int(row["threads"]))
            runs[key].append(row)
    merged = {}
    for key, rows in runs.items():
        merged[key] = dict(rows[0])
        for column in ("cpu_s", "wall_s", "peak_bytes", "slowest_s", *STAGES):
            values = [float(row[column]) for row in rows if row[column] != ""]
            if values:
                merged[key][column] = statistics.median(values)
    return merged


def table(header, rows):
    print("| " + " | ".join(header) + " |")
    print("|" + "---|" * len(header))
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print()


def print_runs(rows):
    threads = max(key[3] for key in rows)
    lines = []
    for (volume, size, program, used), row in rows.items():
        if program != "isoloop loops" or used != 1:
            continue
        count = next(r for k, r in rows.items() if k[:3] == (volume, size, "isoloop count"))
        all_cores = rows.get((volume, size, program, threads))
        peak = float((all_cores or row)["peak_bytes"])
        lines.append([volume, str(size), row["genus"], f"{count['cpu_s']:.2f}",
                      f"{row['cpu_s']:.2f}", f"{all_cores['wall_s']:.2f}" if all_cores else "-",
                      f"{peak / GIB:.2f}",
                      f"{peak / int(row['voxels']):.0f}",
                      *(f"{row[stage]:.2f}" for stage in STAGES)])
    table(["volume", "size", "genus", "count: CPU s", "loops: CPU s, 1 thread",
           f"wall s, {threads} threads", "peak GiB", "bytes a voxel", *(f"{s} s" for s in STAGES)],
          lines)


def print_growth(rows):
    lines = []
    by_volume = collections.defaultdict(list)
    for (volume, size, program, threads), row in rows.items():
        if program == "isoloop loops" and threads == 1:
            by_volume[volume].append((size, int(row["voxels"]), row["cpu_s"]))
    for volume, points in by_volume.items():
        if volume == "noise":
            continue  # its genus grows with it: the next table
        for (size_a, voxels_a, cpu_a), (size_b, voxels_b, cpu_b) in zip(points, points[1:]):
            exponent = math.log(cpu_b / cpu_a) / math.log(voxels_b / voxels_a)
            lines.append([volume, f"{size_a} to {size_b}", f"{voxels_b / voxels_a:.2f}",
                          f"{cpu_b / cpu_a:.2f}", f"{exponent:.2f}", f"{8.0 ** exponent:.1f}"])
    table(["shape", "size", "voxels: factor", "CPU: factor", "exponent", "CPU for 8 x the voxels"],
          lines)


def print_genus(rows):
    """What loops cost by their number, on one thread, and by which power of the genus that grows
    from the row before of the same volume."""
    lines = []
    before = {}
    for (volume, size, program, threads), row in rows.items():
        if program != "isoloop loops" or threads != 1 or int(row["genus"]) < LEAST_GENUS:
            continue
        genus = int(row["genus"])
        exponent = "-"
        smaller, cpu = before.get(volume, (genus, None))
        if smaller < genus:
            exponent = f"{math.log(row['loops'] / cpu) / math.log(genus / smaller):.2f}"
        before[volume] = (genus, row["loops"])
        lines.append([volume, str(size), str(genus), row["triangles"], f"{row['cpu_s']:.2f}",
                      f"{row['loops']:.2f}", f"{500.0 * row['loops'] / genus:.2f}", exponent,
                      f"{100.0 * row['slowest_s'] / row['loops']:.0f} %",
                      f"{float(row['peak_bytes']) / GIB:.2f}"])
    table(["volume", "size", "genus", "triangles", "CPU s", "loops s", "ms a loop",
           "exponent over genus", "slowest hundredth", "peak GiB"], lines)


def print_rivals(rows):
    lines = []
    for (volume, size, program, _), row in rows.items():
        if program.startswith("isoloop"):
            continue
        own_name = "isoloop loops" if program in ("gudhi", "phat") else "isoloop count"
        own = next((r for k, r in rows.items() if k[:3] == (volume, size, own_name)), None)
        if own is None:
            continue  # it failed
        lines.append([volume, str(size), program, f"{row['cpu_s']:.2f}", own_name,
                      f"{own['cpu_s']:.2f}", f"{row['cpu_s'] / own['cpu_s']:.2f}",
                      f"{float(row['peak_bytes']) / float(own['peak_bytes']):.1f}"])
    table(["volume", "size", "program", "its CPU s", "beside", "CPU s", "CPU: ratio",
           "memory: ratio"], lines)


def plot(rows, path):
    import matplotlib
    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "isoloop"
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(7, 5))
    series = collections.defaultdict(list)
    for (volume, _, program, threads), row in rows.items():
        if program == "isoloop loops" and threads == 1:
            series[volume].append((int(row["voxels"]), row["cpu_s"]))
    for volume, points in series.items():
        axes.loglog(*zip(*points), marker="o", markersize=4, label=volume)
    axes.set_xlabel("voxels")
    axes.set_ylabel("CPU seconds, loops, one thread")
    axes.grid(True, which="major", alpha=0.3)
    axes.legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs")
    parser.add_argument("--plot")
    arguments = parser.parse_args()
    rows = medians(arguments.runs)
    print_runs(rows)
    print_growth(rows)
    print_genus(rows)
    if any(not key[2].startswith("isoloop") for key in rows):
        print_rivals(rows)
    if arguments.plot:
        plot(rows, arguments.plot)


if __name__ == "__main__":
    main()
