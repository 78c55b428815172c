#!/bin/sh
# Checks all features on all targets that the README names. A check finds what can
# be missing there: a type, a feature, a panic handler. That it links is the matter of
# link.sh and of the board.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cargo=$here/../../c_examples/cortex_m/cargo.sh
manifest=$here/../../Cargo.toml
host=$(rustc -vV | sed -n 's/^host: //p')
# Without std there is nothing to unwind with.
export CARGO_PROFILE_DEV_PANIC=abort

check() {
    "$cargo" "$target" check --quiet --manifest-path "$manifest" "$@"
}

# The C interface in every precision: for programs in C, and for those in Rust, which have
# a panic handler already.
check_ffi() {
    for features in f64 f32 micromath "f64 f32"; do
        check --package critreg-ffi --no-default-features --features "$features halt"
        check --package critreg-ffi --no-default-features --features "$features"
    done
}

for target in "$host" thumbv7em-none-eabihf thumbv6m-none-eabi; do
    check --package critreg
    check --package critreg --features micromath
    check --package critreg --features environments
    check_ffi
    echo "$target: core and the C interface, in every precision"
done
