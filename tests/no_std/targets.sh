#!/bin/sh
# Checks all features on all targets that c_examples/cortex_m/README.md names. A check finds
# what can be missing there: a type, a feature, a panic handler. That it links is the matter of
# link.sh and of the board.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cargo=$here/../../c_examples/cortex_m/cargo.sh
host=$(rustc -vV | sed -n 's/^host: //p')
# Without std there is nothing to unwind with.
export CARGO_PROFILE_DEV_PANIC=abort

run() {
    "$cargo" "$target" "$@" --quiet --manifest-path "$here/../../Cargo.toml"
}

for target in "$host" thumbv7em-none-eabihf thumbv6m-none-eabi; do
    run check --package critreg
    run check --package critreg --features micromath
    run check --package critreg --features environments
    # For a program in Rust, which has a panic handler, and for those in C.
    run check --package critreg-ffi
    # The first two only draw.
    for features in f64 "f32 bodies" "learner f32" "planner f64" "planner micromath" \
        "planner f64 f32" "planner f32 bodies"; do
        run rustc --package critreg-ffi --no-default-features --features "$features halt" \
            --profile check --crate-type staticlib
    done
    echo "$target: core and the C interface, in every precision"
done
