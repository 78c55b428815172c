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

# The first block of the README that opens with a line, behind a line with a pattern.
readme_block() {
    # shellcheck disable=SC2154 # the top of the repository, which every script here knows
    block=$(awk -v opening="$1" -v behind="${2:-}" '
        $0 ~ behind { found = 1 }
        inside && /^```$/ { exit }
        inside { print }
        found && $0 == opening { inside = 1 }' "$top/README.md")
    [ -n "$block" ] || fail "the README has no block $1"
    printf '%s\n' "$block"
}
