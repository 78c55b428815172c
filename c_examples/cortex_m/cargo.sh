#!/bin/sh
# Cargo for a target that has no operating system:
#
#   cargo.sh <target> <command and arguments of cargo>
#
# With the Rust of rustup, the target's library is installed if it is missing. Where
# there is no rustup, Debian's packages rustc-web and rust-web-src do: a compiler with the
# source of its library, which is then built, too.
set -eu
target=$1
shift
cargo=${CARGO:-cargo}

if [ -d "$("${RUSTC:-rustc}" --print target-libdir --target "$target" 2>/dev/null)" ]; then
    exec "$cargo" "$@" --target "$target"
elif command -v rustup >/dev/null; then
    rustup target add "$target" >&2
    exec "$cargo" "$@" --target "$target"
else
    RUSTC=${RUSTC:-/usr/bin/rustc} RUSTC_BOOTSTRAP=1 \
        exec "$cargo" -Z build-std=core "$@" --target "$target"
fi
