"""CPU seconds and memory of isoloop.loops beside the command: python3 cost.py VOLUME ISO [ROUNDS]

ISOLOOP names the command. Memory is the most that is resident, less what is so before the run."""

import json
import os
import resource
import subprocess
import sys

MODULE = """
import resource, sys, isoloop
volume = isoloop.read(sys.argv[1])
array = volume.array
def used():
    use = resource.getrusage(resource.RUSAGE_SELF)
    return use.ru_utime + use.ru_stime, use.ru_maxrss
before = used()
isoloop.loops(array, float(sys.argv[2]))
after = used()
print(after[0] - before[0], (after[1] - before[1]) / 1024)
"""


def of_module(path, iso):
    words = [sys.executable, "-c", MODULE, path, iso]
    seconds, mebibytes = subprocess.run(words, capture_output=True, check=True).stdout.split()
    return float(seconds), float(mebibytes)


def of_command(path, iso):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    words = [os.environ["ISOLOOP"], "loops", path, "--iso", iso, "--json", "-"]
    report = json.loads(subprocess.run(words, capture_output=True, check=True).stdout)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    voxels = 1
    for n in report["input"]["dims"]:
        voxels *= n
    seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return seconds, (report["peak_bytes"] - voxels) / 2**20


path, iso = sys.argv[1:3]
rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 5
module, command = ([run(path, iso) for _ in range(rounds)] for run in (of_module, of_command))
for name, runs in (("isoloop.loops", module), ("isoloop loops", command)):
    print(f"{name}  {min(s for s, _ in runs):6.2f} CPU s  {min(m for _, m in runs):6.0f} MiB")
