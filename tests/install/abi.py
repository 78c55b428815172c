#!/usr/bin/env python3
"""Compares the C interface with the recorded one, interface.h.

    abi.py             fails if a program that was compiled for the record would not run
                       with a library of today, and CRITREG_ABI_VERSION is still the same
    abi.py --update    records the interface of today: with a release, or with a new
                       CRITREG_ABI_VERSION

Functions and structs are compared by abidiff, in two libraries made of both headers with
functions that do nothing; that the library exports what its header declares is tested in
tests/tests/c_interface. Macros are compared here. New functions and macros are allowed,
and fields at the end of structs that begin with their size.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
HEADER = HERE.parent.parent / "include" / "critreg.h"
RECORD = HERE / "interface.h"
# What abidiff says in its exit status: that something changed, incompatibly or not.
CHANGED = 4 | 8
GROWS_AT_ITS_END = """
[suppress_type]
  type_kind = struct
  has_size_change = yes
  has_data_member_inserted_at = end
"""


def plain(header):
    """A header without comments."""
    code = re.sub(r"/\*.*?\*/|//[^\n]*", "", header.read_text(), flags=re.DOTALL)
    return "".join(line.rstrip() + "\n" for line in code.splitlines() if line.strip())


def macros(text):
    """The value of each macro, as it is written."""
    joined = text.replace("\\\n", " ")
    found = re.findall(r"^#define (CRITREG_\w+(?:\([^)]*\))?) (.*)$", joined, re.MULTILINE)
    return {name: " ".join(value.split()) for name, value in found}


def library(text, folder, name):
    """A shared library whose functions have the types of a header, and do nothing."""
    functions = re.sub(
        r"^((?!typedef)[\w *]*\bcritreg_\w+\([^;{]*\));",
        r"\1 { __builtin_trap(); }",
        text,
        flags=re.MULTILINE,
    )
    source = folder / f"{name}.c"
    source.write_text(functions)
    built = folder / f"{name}.so"
    subprocess.run(
        ["cc", "-g", "-shared", "-fPIC", "-w", "-fno-eliminate-unused-debug-types", source,
         "-o", built],
        check=True,
    )
    return built


def version(text):
    return macros(text)["CRITREG_ABI_VERSION"]


def breaks(old, new):
    """What a program compiled with the old header would stumble over, as lines."""
    before, after = macros(old), macros(new)
    # A version is there to change.
    lines = [
        f"{name} is {after.get(name, 'gone')}, and was {value}"
        for name, value in before.items()
        if after.get(name) != value and not name.startswith("CRITREG_VERSION_")
    ]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        suppressions = folder / "suppressions"
        suppressions.write_text(GROWS_AT_ITS_END)
        compared = subprocess.run(
            ["abidiff", "--no-added-syms", "--suppressions", suppressions,
             library(old, folder, "old"), library(new, folder, "new")],
            capture_output=True,
            text=True,
        )
    if compared.returncode & ~CHANGED:
        sys.exit(f"abidiff: {compared.stdout}{compared.stderr}")
    if compared.returncode:
        lines += compared.stdout.splitlines()
    return lines


def prove(text):
    """Changes that must be found, and changes that must not."""
    fields = re.search(r"typedef struct critreg_config \{\n(.*?)\} critreg_config;", text, re.DOTALL)
    first, last = fields.start(1), fields.end(1)
    behind_size = text.index(";", first) + 1
    end = text.index("critreg_status critreg_ask(")
    bad = {
        "a field in the middle": text[:behind_size] + "\nuint64_t more;" + text[behind_size:],
        "a function that is gone": text.replace(" critreg_conclude(", " critreg_concluded("),
        "another argument": text.replace("critreg_strerror(critreg_status", "critreg_strerror(uint64_t"),
        "another value": text.replace("CRITREG_BUSY 14", "CRITREG_BUSY 94"),
    }
    good = {
        "a field at the end": text[:last] + "uint64_t more;\n" + text[last:],
        "a new function": text[:end] + "int critreg_new(int more);\n" + text[end:],
        "a new macro": text + "\n#define CRITREG_NEW 1\n",
    }
    for what, changed in {**bad, **good}.items():
        if changed == text:
            sys.exit(f"{what}: the change to try does not fit the header any more")
        if bool(breaks(text, changed)) != (what in bad):
            sys.exit(f"{what}: {'not found' if what in bad else 'refused'}")


def main():
    new = plain(HEADER)
    if "--update" in sys.argv:
        RECORD.write_text(new)
        return
    prove(new)
    old = RECORD.read_text()
    broken = breaks(old, new)
    if broken and version(old) == version(new):
        print(*broken, sep="\n")
        sys.exit("programs have to be compiled again: raise CRITREG_ABI_VERSION, unless nothing "
                 "was released since it was raised last, and run abi.py --update")
    print(f"version {version(new)} of the binary interface: "
          f"{'a new one' if broken else 'programs that were compiled for the record run'}")


if __name__ == "__main__":
    main()
