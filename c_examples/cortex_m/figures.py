#!/usr/bin/env python3
"""Measures what critreg takes on a Cortex-M4 and compares it with README.md.

    figures.py            fails if a figure grew by more than 5%
    figures.py --update   writes the figures into README.md
"""

import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
README = HERE / "README.md"
BEGIN, END = "<!-- figures -->\n", "<!-- end of figures -->\n"
GROWTH = 1.05

# A column each: what is computed with, and the feature of the library.
VARIANTS = {
    "f64": "f64",
    "f32": "f32",
    "f32, micromath": "micromath",
}

# A row each: the key, and what it is.
ROWS = {
    "flash": "flash: `pick.c` with the library, bytes",
    "c_library": "flash: what it takes from the C library and libgcc, bytes",
    "ram_256_64": "RAM: a learner with 256 forms, 64 observations, 4 instances, bytes",
    "ram_1024_128": "RAM: 1024 forms, 128 observations",
    "ram_1024_128_untracked": "RAM: the same, with `tracked` = 0",
    "ram_4096_256": "RAM: 4096 forms, 256 observations",
    "stack": "deepest stack, bytes",
    "ask_mean": "instructions per `critreg_ask`, 1024 forms, mean of 100",
    "tell_mean": "instructions per `critreg_tell`, mean of 100",
    "tell_max": "instructions per `critreg_tell`, most",
    "sample": "instructions per `critreg_sample_region`, mean of 100",
    "sampling_flash": "without learners and planner: flash, `sample.c` with the library, bytes",
    "sampling_ram": "without learners and planner: RAM, a region with its domain, bytes",
    "sampling_stack": "without learners and planner: deepest stack, bytes",
}


def run(*command, **keywords):
    done = subprocess.run(command, cwd=HERE, text=True, stdout=subprocess.PIPE, **keywords)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stdout}")
    return done.stdout


def sections(program):
    listing = run("arm-none-eabi-size", "-A", program)
    return dict(re.findall(r"^\.(\S+)\s+(\d+)", listing, re.MULTILINE))


def measured(target, printed, *settings):
    """What a program printed, by key."""
    run("make", "--silent", target, *settings)
    lines = printed.read_text().splitlines()
    return {key: int(number) for key, number in map(str.split, lines)}


def measure(precision):
    """The figures of a library with this precision, by key."""
    build = HERE.parent / "build" / "cortex_m"
    figures = measured("measure", build / "figures.txt", f"FEATURES=halt planner {precision}")
    size = sections(build / "pick.elf")
    figures |= {"flash": int(size["text"]), "c_library": int(size["c_library"])}
    build = build.with_name("cortex_m_sampling")
    settings = f"FEATURES=halt {precision}", f"BUILD=../build/{build.name}"
    figures |= measured("sampling", build / "sampling.txt", *settings)
    size = sections(build / "sample.elf")
    return figures | {"sampling_flash": int(size["text"]) + int(size["c_library"])}


def table(columns):
    def number(value):
        return f"{value:,}".replace(",", " ")

    lines = ["| on a Cortex-M4F | " + " | ".join(columns) + " |", "|---" * (len(columns) + 1) + "|"]
    for key, title in ROWS.items():
        numbers = [number(figures[key]) for figures in columns.values()]
        lines.append("| " + " | ".join([title, *numbers]) + " |")
    return "\n".join(lines) + "\n"


def read(text):
    """The numbers of a table, by title and column."""
    head, _, *rows = [line.strip("|").split("|") for line in text.strip().splitlines()]
    names = [name.strip() for name in head[1:]]
    numbers = {}
    for title, *cells in rows:
        for name, cell in zip(names, cells):
            numbers[title.strip(), name] = int(cell.replace(" ", ""))
    return numbers


def compare(new, begin, end):
    """Holds a table against that between two marks of README.md, or writes it there."""
    before, _, rest = README.read_text().partition(begin)
    committed, _, after = rest.partition(end)
    script = pathlib.Path(sys.argv[0]).name
    print(new, end="")
    if "--update" in sys.argv:
        README.write_text(before + begin + new + end + after)
        return
    old, new = read(committed), read(new)
    if old.keys() != new.keys():
        sys.exit(f"README.md has other figures; {script} --update writes these")
    grown = [key for key in new if new[key] > GROWTH * old[key]]
    for title, name in grown:
        print(f"grew: {title}, {name}: {old[title, name]} -> {new[title, name]}")
    if grown:
        sys.exit(f"{script} --update accepts this")


def main():
    new = table({name: measure(precision) for name, precision in VARIANTS.items()})
    compare(new, BEGIN, END)


if __name__ == "__main__":
    main()
