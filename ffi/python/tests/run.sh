#!/bin/sh
# Installs the package as its users do, into an environment of its own, and tests it there: with
# lists only, then with NumPy; and its types.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

python3 -m venv "$scratch/venv"
python="$scratch/venv/bin/python"
pip() { "$python" -m pip --quiet --disable-pip-version-check "$@"; }

pip wheel --no-deps --wheel-dir "$scratch" "$here/.."
pip install --no-index "$scratch"/critreg-*-py3-none-*.whl
# What is not installed is not found by chance.
cd "$scratch"
unset CRITREG_LIBRARY PYTHONPATH
export PYTHONDONTWRITEBYTECODE=1
"$python" -W error -m unittest discover --quiet --start-directory "$here"
pip install numpy mypy
"$python" -W error -m unittest discover --quiet --start-directory "$here"
"$python" -m mypy --cache-dir "$scratch/types" --config-file "$here/../pyproject.toml" --package critreg

# The README's program.
sed -n '/^```python$/,/^```$/p' "$here/../README.md" | sed '1d;$d' >readme.py
"$python" readme.py | tee printed
grep -qx 'grasp.y <= 2.9 (zone.top - robot.radius)' printed
