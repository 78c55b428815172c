#!/bin/sh
# What is told about the project in several places is the same everywhere: the version, what
# is compiled into the libraries, and the licences and README in the package of the crate.
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

packed=$(cargo package --manifest-path "$top/Cargo.toml" --package critreg --list --allow-dirty)
for file in LICENSE-MIT LICENSE-APACHE README.md; do
    if ! printf '%s\n' "$packed" | grep -qx "$file"; then
        echo "the package of the Rust crate has no $file" >&2
        exit 1
    fi
done

version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$top/Cargo.toml")
grep -q "<version>$version</version>" "$top/ffi/package/package.xml"
grep -qx "version: $version" "$top/CITATION.cff"
echo "version $version everywhere; the licences of the libraries and of the crate are complete"
