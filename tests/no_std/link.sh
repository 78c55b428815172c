#!/bin/sh
# Links everything that the library can do with start.c alone, and fails if anything of
# an operating system, of std or of an allocator is needed, or if a panic can be reached.
#
#   link.sh [<target> [<profile>]]
#
# The functions of the C interface are taken from the header, so none is forgotten. A
# panic that is reached is found by linking with -Wl,--defsym=a_panic_is_reachable=0 and
# looking at the callers of core::panicking in what objdump -d prints.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
target=${1:-$(rustc -vV | sed -n 's/^host: //p')}
profile=${2:-release}
output=${CARGO_TARGET_DIR:-$here/../../target}/no_std
library=$output/$target/$profile/libcritreg_no_std.a

case $target in
thumbv7em*) cc="arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb -mfloat-abi=hard" size=arm-none-eabi-size ;;
thumbv6m*) cc="arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb" size=arm-none-eabi-size ;;
*) cc=${CC:-cc} size=size ;;
esac

functions() {
    grep -v '^ *\*\|^#\|^typedef' "$here/../../include/critreg.h" | grep -o '\bcritreg_[a-z0-9_]*(' | tr -d '('
}

own() {
    grep -hoE '\bno_std_(learn|plan_[a-z_]+)\b' "$here"/src/*.rs | sort -u
}

# Everything is referred to: what is not would be dropped.
table=$output/all.c
mkdir -p "$output"
{
    for function in $(functions) $(own); do
        echo "void $function(void);"
    done
    echo "void (*const all[])(void) = {"
    for function in $(functions) $(own); do
        echo "    $function,"
    done
    echo "};"
} >"$table"

link() {
    # shellcheck disable=SC2086 # a compiler with its flags
    $cc -O2 -fno-builtin -ffreestanding -nostdlib -static "$@" \
        -Wl,--gc-sections,--fatal-warnings,-z,noexecstack "$here/start.c" "$table" "$library"
}

"$here/../../c_examples/cortex_m/cargo.sh" "$target" build --quiet --profile "$profile" \
    --manifest-path "$here/Cargo.toml" --target-dir "$output"

# Names of Rust begin with an underscore, and so do those of its arithmetic.
exported=$(nm --extern-only --defined-only "$library" 2>/dev/null | awk 'NF == 3 { print $3 }' |
    grep -v '^_\|^no_std_' | sort)
if [ "$exported" != "$(functions | sort)" ]; then
    echo "the static library exports something else than the header declares:" "$exported" >&2
    exit 1
fi

program=$output/$target/$profile/no_std
link -o "$program"

# The proof of the proof: with a panic it does not link.
if link -Wl,--undefined=no_std_panic -o "$program.panic" 2>"$program.log"; then
    echo "a panic was linked" >&2
    exit 1
fi
grep -q a_panic_is_reachable "$program.log"

code=$($size "$program" | awk 'NR == 2 { print $1 }')
echo "$target, $profile: core and $(functions | wc -l) functions linked without std, heap and panic," \
    "$code bytes"
