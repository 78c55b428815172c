#!/bin/sh
# Builds core without std and links it with start.c alone: fails if anything of an
# operating system, of an allocator or of std is needed.
set -eu
here=$(dirname "$0")
target=${1:-"$here/../../target/no_std"}
cargo build --quiet --release --manifest-path "$here/Cargo.toml" --target-dir "$target"
cc -O2 -fno-builtin -ffreestanding -nostdlib -static -Wl,--gc-sections,--fatal-warnings \
    "$here/start.c" "$target/release/libcritreg_no_std.a" -o "$target/no_std"
echo "no std: linked, $(size "$target/no_std" | awk 'NR == 2 { print $1 }') bytes of code"
