#!/bin/sh
# Plays the newcomer: installs into an empty prefix, outside of the checkout, and builds
# and runs projects there with CMake, Meson and pkg-config, in C and C++, with the shared
# and with the static library. A version that fits is found, another one refused; what was
# installed can be moved, and leaves nothing behind.
#
#   run.sh    builds the library first, if need be
set -eu
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
# shellcheck source=tests/install/common.sh
. "$here/common.sh"

# A project of its own: a copy of a folder here, beside the programs.
project() {
    mkdir "$scratch/$1"
    cp "$here/$1"/* "$here"/consumer.* "$scratch/$1"
    cd "$scratch/$1"
}

# All four programs of a build folder say the same; the shared ones need the library, the
# static ones do not.
all_run() {
    for language in c cpp; do
        says "critreg 0.1.0: $draw" env LD_LIBRARY_PATH="$libdir" "$1/${language}_shared"
        says "critreg 0.1.0: $draw" "$1/${language}_static"
        readelf -d "$1/${language}_shared" | grep -q 'libcritreg\.so\.0' || fail "$1: not shared"
        ! readelf -d "$1/${language}_static" | grep -q libcritreg || fail "$1: not static"
    done
}

with_cmake() {
    project cmake
    for wanted in "" 0 0.1 0.1.0; do
        cmake -S . -B build -DWANTED="$wanted" -DCMAKE_PREFIX_PATH="$prefix" >log || fail "$(cat log)"
        rm -r build/CMakeCache.txt
    done
    for wanted in 0.0 0.1.1 0.2 1; do
        refused cmake -S . -B other -DWANTED=$wanted -DCMAKE_PREFIX_PATH="$prefix"
        grep -q 'critreg.*version: 0.1.0' refused.log || fail "refused for another reason"
        rm -rf other
    done
    cmake -S . -B build -DWANTED=0.1 -DCMAKE_PREFIX_PATH="$prefix" >log
    cmake --build build >log || fail "$(cat log)"
    all_run build
}

with_meson() {
    project meson
    refused meson setup other -Dwanted='>=0.2'
    grep -q "critreg found: NO found 0.1.0 but need" refused.log || fail "refused for another reason"
    meson setup build -Dwanted='>=0.1' >log || fail "$(cat log)"
    ninja -C build >log || fail "$(cat log)"
    all_run build
}

with_pkg_config() {
    project pkg_config
    refused pkg-config --exists 'critreg >= 0.2'
    make WANTED='>= 0.1' >log || fail "$(cat log)"
    all_run .
}

with_ompl() {
    project ompl
    make sampler goal >log 2>&1 || fail "$(cat log)"
    LD_LIBRARY_PATH=$libdir ./sampler || fail "OMPL draws from somewhere else"
    LD_LIBRARY_PATH=$libdir ./goal || fail "OMPL has another goal"
}

refused() {
    if "$@" >refused.log 2>&1; then fail "accepted: $*"; fi
}

make -C "$top" library >/dev/null
# Where distributions put libraries, and through a root of a packager's.
prefix=$scratch/moved
libdir=$prefix/lib/$(uname -m)-linux-gnu
installed="PREFIX=$prefix LIBDIR=$libdir"
# shellcheck disable=SC2086 # two words
no_rust make -s -C "$top" install DESTDIR="$scratch/root" $installed
mv "$scratch/root$prefix" "$prefix"
export PKG_CONFIG_PATH="$libdir/pkgconfig"

draw=0.1259
with_cmake
with_meson
with_pkg_config
with_ompl

# As colcon does in a ROS 2 workspace; with what was built above.
cmake -S "$top/ffi/package" -B "$scratch/colcon" -DCMAKE_INSTALL_PREFIX="$scratch/workspace" \
    -DCARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$top/target}" >log
{ cmake --build "$scratch/colcon" && cmake --install "$scratch/colcon"; } >log || fail "$(cat log)"
for file in lib/libcritreg.so share/critreg/package.xml \
    share/ament_index/resource_index/packages/critreg; do
    [ -e "$scratch/workspace/$file" ] || fail "no $file in the workspace"
done

for file in LICENSE-MIT LICENSE-APACHE THIRD_PARTY; do
    [ -s "$prefix/share/doc/critreg/$file" ] || fail "no $file"
done
[ "$(readelf -S "$libdir"/libcritreg.so "$libdir/libcritreg.a" 2>/dev/null | grep -c debug_)" = 0 ] ||
    fail "not stripped"
# shellcheck disable=SC2086
no_rust make -s -C "$top" uninstall $installed
left=$(find "$prefix" ! -type d)
[ -z "$left" ] || fail "left behind: $left"
# Nothing was built for it, so nothing is installed.
refused make -s -C "$top" install DESTDIR="$scratch/root" CARGO_BUILD_TARGET=mips-unknown-none

echo "installed, found, linked and removed: CMake, Meson, pkg-config, OMPL; C, C++; shared, static"
