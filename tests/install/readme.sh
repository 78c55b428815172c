#!/bin/sh
# The README's first five minutes: its commands install the library, and compile and run its
# program, as they stand there, in an empty home.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
# shellcheck source=tests/install/common.sh
. "$here/common.sh"

readme_block '```sh' >"$scratch/commands"
readme_block '```c' >"$scratch/grasp.c"
expected=$(readme_block '```' '^It prints')
ln -s "$top" "$scratch/critreg"
# Rust is there, wherever it was installed.
export CARGO_HOME="${CARGO_HOME:-$HOME/.cargo}" RUSTUP_HOME="${RUSTUP_HOME:-$HOME/.rustup}"
unset CARGO_BUILD_TARGET PKG_CONFIG_PATH
cd "$scratch"
HOME=$scratch sh -e commands >printed 2>log || fail "$(cat printed log)"
# What the program prints comes last.
[ "$(tail -n "$(printf '%s\n' "$expected" | wc -l)" printed)" = "$expected" ] ||
    fail "the program prints something else: $(cat printed)"
echo "the README's commands install the library and run its program"
