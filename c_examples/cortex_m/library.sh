#!/bin/sh
# Builds the static library for a target that has no operating system, and prints its
# path:
#
#   library.sh <target> [<profile> [<features>]]
#
# With the Rust of rustup, the target's library is installed if it is missing. Without
# rustup it takes Debian's packages rustc-web and rust-web-src, a compiler with the
# source of its library, and builds that library, too.
set -eu
target=$1
profile=${2:-firmware}
features=${3:-halt}
here=$(cd "$(dirname "$0")" && pwd)
cargo=${CARGO:-cargo}
output=${CARGO_TARGET_DIR:-$here/../../target}
built=

if [ -d "$(${RUSTC:-rustc} --print target-libdir --target "$target" 2>/dev/null)" ]; then
    :
elif command -v rustup >/dev/null && rustup target add "$target" >&2; then
    :
else
    RUSTC=${RUSTC_WITH_SOURCE:-/usr/bin/rustc}
    RUSTC_BOOTSTRAP=1
    export RUSTC RUSTC_BOOTSTRAP
    built="-Z build-std=core"
fi

# shellcheck disable=SC2086 # no words, or two
"$cargo" rustc --quiet --profile "$profile" --package critreg-ffi --crate-type staticlib \
    --manifest-path "$here/../../Cargo.toml" --target-dir "$output" --target "$target" \
    --no-default-features --features "$features" $built >&2
echo "$output/$target/$profile/libcritreg_ffi.a"
