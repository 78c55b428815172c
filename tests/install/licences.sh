#!/bin/sh
# The list of what is compiled into the libraries is that of Cargo.
set -eu
top=$(cd "$(dirname "$0")/../.." && pwd)
taken=$(cargo tree --manifest-path "$top/Cargo.toml" --package critreg-ffi --all-features \
    --edges normal --prefix none --format '{p}' | awk '{ print $1 }' | sort -u | grep -v '^critreg')
listed=$(sed -n 's/^\([a-z][a-z0-9_-]*\) [0-9.]* .*Copyright.*/\1/p' "$top/ffi/package/THIRD_PARTY" | sort)
if [ "$taken" != "$listed" ]; then
    echo "ffi/package/THIRD_PARTY lists other crates than Cargo takes:" >&2
    printf '%s\n' "$taken" "$listed" | sort | uniq -u >&2
    exit 1
fi
