"""Runs can be watched and interrupted, and other threads go on meanwhile."""

import _thread
import os
import signal
import subprocess
import sys
import threading
import time

import numpy
import pytest

import isoloop


@pytest.fixture(scope="module")
def lattice():
    return isoloop.generate("lattice", size=72, cells=3)


def test_progress_is_told_in_the_callers_thread(lattice):
    told = []
    isoloop.loops(lattice, progress=lambda stage, share: told.append((stage, share, threading.get_ident())))
    assert [stage for stage, _, _ in told][:1] == ["surface"] and len({s for s, _, _ in told}) >= 4
    shares = [share for _, share, _ in told]
    assert shares == sorted(shares) and 0 <= shares[0] and shares[-1] <= 1
    assert {ident for _, _, ident in told} == {threading.get_ident()}


def test_an_exception_of_progress_ends_the_run(lattice):
    def stop(stage, share):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        isoloop.loops(lattice, progress=stop)
    assert isoloop.count(lattice).components == 1


def test_ctrl_c_ends_a_run(lattice):
    threading.Timer(0.3, _thread.interrupt_main).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(1000):
            isoloop.loops(lattice)
    assert time.monotonic() - start < 30


def test_other_threads_go_on_meanwhile(lattice):
    beats = []

    def beat():
        while not done.wait(0.01):
            beats.append(time.monotonic())

    done = threading.Event()
    other = threading.Thread(target=beat)
    other.start()
    start = time.monotonic()
    isoloop.loops(lattice)
    end = time.monotonic()
    done.set()
    other.join()
    gaps = numpy.diff([start, *[b for b in beats if start < b < end], end])
    assert gaps.max() < max(1.0, (end - start) / 2), "the interpreter's lock is released"


def test_runs_of_several_threads_do_not_mix():
    solids = {n: isoloop.generate("plate", size=48 + 12 * n, holes=n) for n in (1, 2, 3)}
    found = {}

    def work(holes):
        found[holes] = isoloop.loops(solids[holes]).genus

    threads = [threading.Thread(target=work, args=(holes,)) for holes in solids]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == {1: 1, 2: 2, 3: 3}


def test_a_process_that_is_interrupted_ends():
    code = "import isoloop; v = isoloop.generate('lattice', size=96, cells=4); print(flush=True)\n"
    code += "while True: isoloop.loops(v)"
    process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, env=os.environ)
    process.stdout.readline()
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=120)
    assert b"KeyboardInterrupt" in errors and process.returncode != -signal.SIGSEGV


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")


def test_memory_does_not_grow_from_run_to_run():
    least_rounds, seconds = 30, float(os.environ.get("ISOLOOP_SECONDS", "0"))
    solid = isoloop.generate("plate", size=48, holes=3).array
    held = []
    end = time.monotonic() + seconds
    while len(held) < least_rounds or time.monotonic() < end:
        found = isoloop.features(solid, iso=0, inside="below")
        found.to_numpy(), found.to_dict(), found.labels, list(found), found.surface()
        isoloop.repair(solid, 0, inside="below", fill_tunnels=30)
        isoloop.scan(solid, values=10)
        try:
            isoloop.count(solid)
        except isoloop.UsageError:
            pass
        held.append(resident_bytes())
    settled = held[least_rounds // 3 :]
    assert max(settled) - settled[0] < 24 << 20, [h >> 20 for h in held[:: max(1, len(held) // 20)]]
