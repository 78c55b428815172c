#!/bin/sh
# Builds every cell of the README's table of features and targets.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cargo=$here/../../c_examples/cortex_m/cargo.sh
manifest=$here/../../Cargo.toml
host=$(rustc -vV | sed -n 's/^host: //p')
# Without std there is nothing to unwind with.
export CARGO_PROFILE_DEV_PANIC=abort

build() {
    "$cargo" "$target" "$@" --manifest-path "$manifest"
}

for target in "$host" thumbv7em-none-eabihf thumbv6m-none-eabi; do
    build build --quiet --package critreg
    build build --quiet --package critreg --features micromath
    for features in f64 f32 micromath "f64 f32"; do
        build rustc --quiet --package critreg-ffi --crate-type staticlib \
            --no-default-features --features "halt $features"
    done
    echo "$target: core and the C interface without std, in every precision"
done

target=$host
for features in f64 f32 micromath "f64 f32"; do
    build rustc --quiet --package critreg-ffi --crate-type staticlib \
        --no-default-features --features "std $features"
done
echo "$target: the C interface with std, in every precision"
