#!/usr/bin/env python3
"""Measures a region that was written as C, and compares it with README.md.

    export.py            fails if a figure grew by more than 5%
    export.py --update   writes the figures into README.md

The instructions are the most that one call of pick_contains executes, apart from those of
the C library: there are no loops in it, and only sines are called.
"""

import pathlib
import re

from figures import compare, run

HERE = pathlib.Path(__file__).resolve().parent
BUILD = HERE.parent / "build" / "cortex_m_export"
BEGIN, END = "<!-- export -->\n", "<!-- end of export -->\n"

M4 = ["-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"]
M0 = ["-mcpu=cortex-m0plus", "-mthumb"]

# A column each: the machine, and in what is computed.
VARIANTS = {
    "M4F, float": [*M4, "-Dpick_FLOAT"],
    "M4F, double": M4,
    "M0+, float": [*M0, "-Dpick_FLOAT"],
    "M0+, double": M0,
}

# A function each, which the compiler makes of the C.
FUNCTIONS = {
    "contains": "int contains(const pick_real *i, const pick_real *t)"
    " { return pick_contains(i, t); }",
    "margins": "void margins(const pick_real *i, const pick_real *t, pick_real *v, pick_real *g)"
    " { pick_margins(i, t, v, g); }",
    "sample": "int sample(const pick_real *i, pick_real s, pick_real *t)"
    " { return pick_sample(i, s, t); }",
}


def measure(options):
    """Flash, stack and instructions of each function, by title."""
    figures = {}
    for name, function in FUNCTIONS.items():
        source, built = BUILD / f"{name}.c", BUILD / f"{name}.o"
        source.write_text(f'#include "pick.h"\n{function}\n')
        run("arm-none-eabi-gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-Os",
            "-ffp-contract=off", "-fno-math-errno", "-fstack-usage", *options,
            "-c", str(source), "-o", str(built))
        size = run("arm-none-eabi-size", str(built)).splitlines()[1].split()
        listing = run("arm-none-eabi-objdump", "-d", "--no-show-raw-insn", str(built))
        # A part each of what was compiled: its name, and its instructions.
        parts = {}
        for part in listing.split("\n\n"):
            if head := re.search(r"<(\w+)>:", part):
                parts[head[1]] = re.findall(r"^ +[0-9a-f]+:\t(?!\.word)(.*)", part, re.MULTILINE)
        own = parts[name]
        called = re.findall(r"^bl\t.*<(\w+)>", "\n".join(own), re.MULTILINE)
        count = len(own) + sum(len(parts.get(part, [])) for part in called if part != name)
        stack = sum(int(line.split("\t")[1])
                    for line in built.with_suffix(".su").read_text().splitlines())
        figures[f"`pick_{name}`: flash, bytes"] = int(size[0])
        figures[f"`pick_{name}`: stack, bytes"] = stack
        if name == "contains":
            figures[f"`pick_{name}`: instructions, at most"] = count
    return figures


def table(columns):
    lines = ["| of a pick as C | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for title in next(iter(columns.values())):
        cells = (f"{figures[title]:,}".replace(",", " ") for figures in columns.values())
        lines.append("| " + " | ".join([title, *cells]) + " |")
    return "\n".join(lines) + "\n"


def main():
    BUILD.mkdir(parents=True, exist_ok=True)
    run("make", "--silent", "pick.h")
    new = table({name: measure(options) for name, options in VARIANTS.items()})
    compare(new, BEGIN, END)


if __name__ == "__main__":
    main()
