# What the scripts here share: a folder that goes when they end, and expectations.
# shellcheck shell=sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
    echo "$(basename "$0"): $*" >&2
    exit 1
}

# What a command prints is this.
says() {
    expected=$1
    shift
    printed=$("$@") || fail "failed: $*"
    [ "$printed" = "$expected" ] || fail "$* says $printed instead of $expected"
}

# Runs a command as someone who has no Rust, such as root.
no_rust() {
    CARGO=false RUSTC=false "$@"
}
