#!/usr/bin/env bash
# All C programs and examples under AddressSanitizer and UndefinedBehaviorSanitizer, and two
# threads on the same handles under ThreadSanitizer. The library is compiled with overflow
# checks, and, where there is a nightly compiler, instrumented itself.
set -euo pipefail
cd "$(dirname "$0")/.."

target=$(rustc -vV | sed -n 's/^host: //p')
build=target/sanitizers
export CARGO_PROFILE_RELEASE_LTO=false CARGO_PROFILE_RELEASE_OPT_LEVEL=1 \
    CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 CARGO_PROFILE_RELEASE_OVERFLOW_CHECKS=true
mkdir -p "$build"
# Without full optimisation core refers to what unwinds, which nothing here does; and the
# runtime of GCC's ThreadSanitizer knows no memory functions of LLVM's: it intercepts its own.
cat > "$build/runtime.c" <<'END'
#include <string.h>
void rust_eh_personality(void) {}
void *__tsan_memcpy(void *to, const void *from, size_t n) { return memcpy(to, from, n); }
void *__tsan_memmove(void *to, const void *from, size_t n) { return memmove(to, from, n); }
void *__tsan_memset(void *to, int byte, size_t n) { return memset(to, byte, n); }
END
cc -O1 -fno-builtin -c "$build/runtime.c" -o "$build/runtime.o"

# library <sanitizer>: the library, instrumented if that is possible.
library() {
    local flags='' toolchain=()
    if rustup run nightly rustc --version >/dev/null 2>&1; then
        flags="-Zsanitizer=$1 -Cunsafe-allow-abi-mismatch=sanitizer" toolchain=(+nightly)
    fi
    RUSTFLAGS="$flags" cargo "${toolchain[@]}" rustc --quiet --release -p critreg-ffi \
        --features halt --crate-type staticlib --target "$target" --target-dir "$build/$1"
}

# program <sanitizers of C> <sanitizer of Rust> <name> <sources...>: compiles a program.
program() {
    local sanitizers=$1 library=$2 name=$3 compiler=(cc -std=c99)
    shift 3
    case "$1" in *.cpp) compiler=(c++ -std=c++17) ;; esac
    "${compiler[@]}" -D_DEFAULT_SOURCE -O1 -g "-fsanitize=$sanitizers" \
        -fno-sanitize-recover=all -I include "$@" "$build/runtime.o" \
        "$build/$library/$target/release/libcritreg_ffi.a" -lm -lpthread -o "$build/$name"
}

# run <program> <arguments...>: a program that does not end is stuck in the panic handler.
run() {
    printf '%s\n' "$*"
    (cd "$build" && timeout 600 "./$@" >"$1.out" 2>&1) || { tail -n 40 "$build/$1.out"; exit 1; }
}

library address
for source in tests/c/*.c; do
    name=$(basename "$source" .c)
    case "$name" in
        # These are parts of programs, or about how the library is linked.
        two_units_other | plug_in | beside_rust) continue ;;
        # Instrumented code takes more stack.
        stack) continue ;;
        # It is told what to learn; plan_tasks and misuse_skills do the same.
        skills) continue ;;
        two_units_main) program address,undefined address "$name" "$source" \
            tests/c/two_units_other.c ;;
        *) program address,undefined address "$name" "$source" ;;
    esac
    run "$name"
done
for source in c_examples/{pick_stick.c,own_domain.c,ask_tell.c,plan_tasks.c,own_world.c,from_cpp.cpp}; do
    name=$(basename "${source%.*}")
    program address,undefined address "$name" "$source"
    case "$name" in
        pick_stick | own_domain) run "$name" 2 ;;
        plan_tasks | own_world) run "$name" 5 12 ;;
        *) run "$name" ;;
    esac
done

library thread
program thread thread threads tests/c/threads.c
run threads
echo "nothing found"
