#!/usr/bin/env python3
"""Kills and stops processes of the MPI program again and again while it learns, rank 0 and
others: nothing that was told may be lost, and the region must be the one of an undisturbed
run that is fed the same answers.

    kill_mpi.py PROGRAM [KILLS]

PROGRAM is c_examples/build/bin/mpi, for MPICH; 6 kills unless told.
"""

import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

RANKS = 4
RECORD = 42  # bytes of an answer in the journal
CALLS = 64


def answers(journal):
    return journal.stat().st_size // RECORD if journal.exists() else 0


def disturbed(program, journal, kills, rng):
    """A start of the program, until it ends. What it printed, and how many were killed."""
    words = ["mpiexec", "-disable-auto-cleanup", "-n", str(RANKS), program, str(journal)]
    process = subprocess.Popen(
        words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    printed, ranks, killed = [], {}, 0
    for line in process.stdout:
        printed.append(line)
        started = re.fullmatch(r"rank (\d+) is process (\d+)\n", line)
        if started:
            ranks[int(started[1])] = int(started[2])
        if len(ranks) < RANKS or not started:
            continue
        for rank in rng.sample(range(RANKS), min(kills, 2)):
            time.sleep(rng.uniform(0.0, 0.25))
            how = signal.SIGSTOP if rank > 0 and rng.random() < 0.4 else signal.SIGKILL
            try:
                os.kill(ranks[rank], how)
            except ProcessLookupError:
                break
            killed += 1
            if rank == 0:
                # Workers that only hang would wait for a signal to go on.
                for own in ranks.values():
                    try:
                        os.kill(own, signal.SIGCONT)
                    except ProcessLookupError:
                        pass
                break
    process.wait(timeout=60)
    return "".join(printed), killed


def region(printed):
    found = re.search(r"region: (.+)\n", printed)
    return found and found[1]


def main():
    program = sys.argv[1]
    kills = int(sys.argv[2]) if len(sys.argv) > 2 else 6
    rng, killed, runs = random.Random(0), 0, 0
    with tempfile.TemporaryDirectory() as folder:
        while killed < kills:
            journal = pathlib.Path(folder) / f"journal{runs}"
            printed, told = "", 0
            while region(printed) is None:
                printed, more = disturbed(program, journal, kills - killed, rng)
                killed += more
                assert answers(journal) >= told, f"{told} answers became {answers(journal)}"
                told = answers(journal)
            assert told == CALLS, told
            alone = subprocess.run(
                [program, str(journal)], stdout=subprocess.PIPE, text=True, check=True
            )
            assert region(alone.stdout) == region(printed), (alone.stdout, printed)
            assert "hand.radius" in region(printed), printed
            runs += 1
            print(f"{killed} of {kills} kills", file=sys.stderr)
    print(f"kills: {killed}\nruns: {runs}\nlost: 0\ndifferent: 0")


if __name__ == "__main__":
    main()
