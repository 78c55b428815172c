#!/usr/bin/env python3
"""Asks z3 what the library proves itself: do regions satisfy what is specified?

Each text beside this file is a claim: a domain, a region, one that is wrong by some percent, a
specification and the ranges of an instance. z3 has to say "unsat" to every question of the
region, and "sat" to one of the wrong one. Claims with `== prover` `own` are left to the
library: where something turns, z3 takes for ever.
"""

import math
import pathlib
import re
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# The package of the checkout, with the library that was built last.
sys.path.insert(0, str(ROOT / "ffi" / "python" / "src"))

import critreg

SECONDS = 20


def sections_of(path):
    """What a claim says, by the names of its sections."""
    sections, own = {}, "domain"
    for line in path.read_text().splitlines():
        if line.startswith("== "):
            own = line[3:]
            continue
        if line.startswith("include "):
            line = (ROOT / line[8:]).read_text()
        sections[own] = sections.get(own, "") + line + "\n"
    return sections


def number(text):
    factors = [math.pi if f == "pi" else -math.pi if f == "-pi" else float(f) for f in text.split("*")]
    return math.prod(factors)


def ranges_of(domain, text):
    """The ends for each number of an instance: of each object in the order of the domain, of
    each attribute in that of the claim, which is the same."""
    lines = [line.split() for line in text.splitlines()]
    ranges = []
    for name, count in re.findall(r"^object\s+(\w+)(?:\[(\d+)\])?", domain, re.MULTILINE):
        own = [[number(low), number(high)] for path, low, high in lines if path.split(".")[0] == name]
        ranges += own * int(count or 1)
    return ranges


def ask(question):
    """What z3 says."""
    options = ["z3", "-in", f"-T:{SECONDS}"]
    answer = subprocess.run(options, input=question, capture_output=True, text=True, check=False)
    return answer.stdout.split("\n")[0]


def main():
    failed = 0
    for path in sorted(HERE.glob("*.txt")):
        claim = sections_of(path)
        if claim.get("prover", "").strip() == "own":
            continue
        domain = critreg.Domain(claim["domain"])
        ranges = ranges_of(claim["domain"], claim["ranges"])
        specification = critreg.Region(domain, claim["specification"])
        start = time.monotonic()
        answers = []
        for section in ["region", "wrong"]:
            region = critreg.Region(domain, claim[section])
            answers.append([ask(question) for question in region.to_smt2(specification, ranges)])
        right, wrong = answers
        holds = set(right) == {"unsat"} and "sat" in wrong
        failed += not holds
        print(f"{path.stem:16} {'as claimed' if holds else answers} {time.monotonic() - start:.1f} s")
    return failed


if __name__ == "__main__":
    sys.exit(1 if main() else 0)
