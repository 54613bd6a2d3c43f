#!/usr/bin/env bash
# The Python package: its wheel built, installed into an environment of its own, typed, and tested against the command line; the
# example notebook runs among the tests. Needs Rust and Python 3.11 or later; installs Debian's python3-venv where venv is missing.
# Leaves its own things in target/.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TERM_COLOR=never DEBIAN_FRONTEND=noninteractive CARGO_TARGET_DIR="$PWD/target"

step() { printf '\n== %s\n' "$*"; }

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi; }

environment=target/python
wheels=target/python-wheels
python=$environment/bin/python

step "an environment with maturin"
if ! "$python" -m maturin --version 2>/dev/null; then
    rm -rf "$environment"
    if ! python3 -m venv "$environment"; then
        as_root apt-get update -q
        as_root apt-get install -qy python3-venv
        rm -rf "$environment"
        python3 -m venv "$environment"
    fi
    "$python" -m pip install --quiet --disable-pip-version-check "maturin>=1.9,<2"
fi

step "format, lints and licences of the native half"
cargo fmt --check --manifest-path python/Cargo.toml
cargo clippy --release --manifest-path python/Cargo.toml -- -D warnings
cargo metadata --format-version 1 --manifest-path python/Cargo.toml |
    "$python" .ci/licences.py "Apache-2.0 WITH LLVM-exception"

step "the program that the package is held against; it shares the library with the wheel"
cargo build --release --manifest-path python/Cargo.toml --package washout

step "the wheel"
rm -rf "$wheels"
"$python" -m maturin build --release --manifest-path python/Cargo.toml --out "$wheels"
wheel=$(ls "$wheels"/washout-*-abi3-*.whl)
"$python" -m pip install --quiet --disable-pip-version-check --force-reinstall --no-deps "$wheel"
"$python" -m pip install --quiet --disable-pip-version-check "$wheel[test]"

step "types"
(cd python && "../$python" -m mypy --cache-dir ../target/python-mypy tests package)

step "tests and notebook"
(cd python && "../$python" -m pytest -p no:cacheprovider --durations 5)

step "the crate knows nothing of it"
if cargo package --list --allow-dirty | grep '^python/'; then exit 1; fi

step "all good"
