#!/usr/bin/python3
"""Measures how far the work of each stage of `isoloop loops` spreads over threads.

    tests/bench/thread_shares.py VOLUME [FLAG ...] [--threads 2 4 8 16] [--repeat 5]
                                 [--isoloop PROGRAM]

A stage takes about as long as its busiest thread is at work: the processor time of one thread alone
over that estimates how many times faster more threads make it. Threads take part whether the
machine has as many cores or fewer. The estimate leaves out what cores share, memory above all, and
is low where there are fewer cores than threads: who starts a short parallel stretch goes on with it
while the others wait for a core. Prints medians in a table, in Markdown; "loops" has the report in
it. FLAGs are those of `isoloop loops`.
Needs Linux, whose /proc tells each thread's time."""

import argparse
import json
import os
import pathlib
import select
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
STAGES = ["surface", "closest", "sizes", "pass", "loops"]


def seconds_by_thread(process):
    seconds = {}
    for thread in pathlib.Path(f"/proc/{process.pid}/task").glob("*"):
        try:
            on_processor = (thread / "schedstat").read_text().split()[0]
        except (OSError, IndexError):
            continue  # it has ended
        seconds[thread.name] = int(on_processor) / 1e9
    return seconds


def shares(command):
    """(stage) to the processor seconds that each thread spent in it."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    marks = []
    latest = {}
    pending = b""
    while True:
        ready, _, _ = select.select([process.stderr], [], [], 0.01)
        latest = {**latest, **seconds_by_thread(process)}
        if not ready:
            continue
        data = os.read(process.stderr.fileno(), 1 << 16)
        if not data:
            break
        *lines, pending = (pending + data).split(b"\n")
        for line in lines:
            told = json.loads(line)
            if "stage" in told:
                marks.append((told["stage"], latest))
    if process.wait() != 0:
        raise SystemExit(f"exit code {process.returncode}: {' '.join(command)}")
    marks.append(("end", latest))
    spent = {}
    for (stage, before), (_, after) in zip(marks, marks[1:]):
        each = spent.setdefault(stage, {})
        for thread, seconds in after.items():
            each[thread] = each.get(thread, 0.0) + seconds - before.get(thread, 0.0)
    return {stage: list(each.values()) for stage, each in spent.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter,
                                     allow_abbrev=False)  # --iso is of isoloop loops
    parser.add_argument("--threads", type=int, nargs="+", default=[2, 4, 8, 16])
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--isoloop", default=str(ROOT / "build/release/tools/isoloop"))
    parser.add_argument("volume")
    arguments, flags = parser.parse_known_args()
    counts = [1] + [count for count in arguments.threads if count != 1]
    command = [arguments.isoloop, "loops", arguments.volume, *flags, "--json", "-", "--log-json"]
    busiest = {count: {stage: [] for stage in STAGES} for count in counts}
    for _ in range(arguments.repeat):
        for count in counts:
            for stage, each in shares([*command, "--threads", str(count)]).items():
                if stage in STAGES:
                    busiest[count][stage].append(max(each))
    print("| stage | CPU s, 1 thread | " + " | ".join(f"{n} threads" for n in counts[1:]) + " |")
    print("|" + "---|" * (len(counts) + 1))
    for stage in STAGES:
        if not busiest[1][stage]:
            continue  # a surface without loops is done after the first
        alone = statistics.median(busiest[1][stage])
        estimates = [alone / statistics.median(busiest[count][stage]) for count in counts[1:]]
        print(f"| {stage} | {alone:.2f} | " + " | ".join(f"{e:.1f} ×" for e in estimates) + " |")


if __name__ == "__main__":
    main()
