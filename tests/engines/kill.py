#!/usr/bin/env python3
"""Kills the command-line program again and again while it learns, and compares the run with
one that nobody disturbed: the saved bytes must be the same.

    kill.py PROGRAM [KILLS]

PROGRAM is c_examples/build/bin/critreg, perhaps behind the words of a tool that runs it; 30
kills unless told, and one run at least.
"""

import pathlib
import random
import shlex
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
CALLS = 40
NOTHING_MORE = 4


class Run:
    """A run in a folder, whose commands may be killed."""

    def __init__(self, program, folder, kills, rng):
        self.program, self.folder, self.kills, self.rng = program, folder, kills, rng
        self.killed, self.slowest = 0, 0.05

    def command(self, name, *arguments):
        """What a command prints and its status; None if it was killed."""
        words = [*self.program, name, str(self.folder), *map(str, arguments)]
        start = time.monotonic()
        process = subprocess.Popen(
            words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        )
        if self.killed < self.kills and self.rng.random() < 0.7:
            time.sleep(self.rng.uniform(0.0, 1.2 * self.slowest))
            process.kill()
        printed, _ = process.communicate()
        if process.returncode < 0:
            self.killed += 1
            return None
        self.slowest = min(self.slowest, 2.0 * (time.monotonic() - start))
        return printed, process.returncode

    def question(self):
        """The open question, or a new one; None if learning is finished."""
        while True:
            done = self.command("open")
            if done and done[0]:
                return done[0]
            done = done and self.command("ask")
            if done and done[1] == NOTHING_MORE:
                return None

    def learn(self):
        """Asks and tells until there is nothing more to ask."""
        told = 0
        while (question := self.question()) is not None:
            own, instance, theta = question.splitlines()[0].split("|")
            works = float(theta) <= float(instance.split()[0]) - 0.1
            # A command that was killed may have told it: then another one is open.
            self.command("tell", own.split()[0], int(works))
            told += 1
        return told

    def saved(self):
        return (self.folder / "saved").read_bytes()


def main():
    program = shlex.split(sys.argv[1])
    kills = int(sys.argv[2]) if len(sys.argv) > 2 else 30
    rng, killed, runs = random.Random(0), 0, 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)

        def learned(name, seed, kills):
            run = Run(program, folder / name, 0, rng)
            made = run.command("new", HERE / "domain", HERE / "walls", CALLS, seed)
            assert made == ("", 0), made
            run.kills = kills
            run.learn()
            return run

        while runs == 0 or killed < kills:
            whole = learned(f"whole{runs}", runs, 0)
            disturbed = learned(f"disturbed{runs}", runs, kills - killed)
            assert disturbed.saved() == whole.saved(), f"run {runs} differs"
            region = whole.command("region")
            assert "hand.radius" in region[0], region
            picture, status = whole.command("draw", 0)
            assert status == 0 and "tried, and worked" in picture, picture
            (folder / "region").write_text(region[0])
            (folder / "wall").write_text("1 0")
            texts = [HERE / "domain", folder / "region", folder / "wall"]
            words = [*program, "draw", *map(str, texts)]
            same = subprocess.run(words, stdout=subprocess.PIPE, text=True, check=True).stdout
            assert same.endswith("</svg>\n") and "tried" not in same, same
            killed += disturbed.killed
            runs += 1
            print(f"{killed} of {kills} kills", file=sys.stderr)
    print(f"kills: {killed}\nruns: {runs}\ndifferent: 0")


if __name__ == "__main__":
    main()
