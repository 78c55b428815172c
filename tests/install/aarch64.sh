#!/bin/sh
# Builds the library for 64-bit ARM on this computer, installs it, and runs the README's
# program with it under QEMU: it prints what it prints everywhere.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
# shellcheck source=tests/install/common.sh
. "$here/common.sh"

export CARGO_BUILD_TARGET=aarch64-unknown-linux-gnu
export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
[ -d "$(rustc --print target-libdir --target $CARGO_BUILD_TARGET)" ] ||
    rustup target add $CARGO_BUILD_TARGET >/dev/null
make -C "$top" library >/dev/null
prefix=$scratch/prefix
no_rust make -s -C "$top" install PREFIX="$prefix"
for library in libcritreg.a libcritreg.so; do
    # Every member of the archive is for the one machine.
    machines=$(readelf -h "$prefix/lib/$library" | sed -n 's/.*Machine: *//p' | sort -u)
    [ "$machines" = AArch64 ] || fail "$library is for $machines"
done

readme_block '```c' >"$scratch/grasp.c"
expected=$(readme_block '```' '^It prints')
cd "$scratch"
for linked in -lcritreg -l:libcritreg.a; do
    aarch64-linux-gnu-gcc -std=c99 -I"$prefix/include" grasp.c -L"$prefix/lib" $linked -lm -o grasp
    says "$expected" qemu-aarch64 -L /usr/aarch64-linux-gnu -E LD_LIBRARY_PATH="$prefix/lib" grasp
done
echo "aarch64: built, installed, and the README's program prints what it says"
