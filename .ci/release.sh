#!/usr/bin/env bash
# What is given to people who have no Rust: a static program for Linux in an archive with its manual pages, completions, designs and
# studies, and the Python wheel. Written to target/dist/ with their SHA-256; both are tried before they are called done.
#
#   .ci/release.sh            both
#   .ci/release.sh program    the archive alone
#   .ci/release.sh wheel      the wheel alone
#
# Needs Rust with rustup, and Python 3.11 or later for the wheel. docs/install.md says what macOS and Windows need.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TERM_COLOR=never CARGO_INCREMENTAL=0
what=${1:-all}
built=${CARGO_TARGET_DIR:-target}
dist=$PWD/target/dist
machine=$(uname -m)
platform=$machine-unknown-linux-musl
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -1)

step() { printf '\n== %s (after %s s)\n' "$*" "$SECONDS"; }

program() {
    step "the program, linked with musl so that it needs nothing"
    rustup target add "$platform"
    cargo build --release --locked --target "$platform"
    local name=washout-$version-$platform
    local folder=$dist/$name
    rm -rf "$folder"
    mkdir -p "$folder/man" "$folder/completions"
    cp "$built/$platform/release/washout" README.md CHANGELOG.md LICENSE-APACHE LICENSE-MIT "$folder"
    cp -r designs measurements studies "$folder"
    "$folder/washout" man "$folder/man" >/dev/null
    for shell in bash zsh fish; do
        "$folder/washout" completions "$shell" >"$folder/completions/washout.$shell"
    done

    step "the archive, tried where nothing else is"
    (cd "$dist" && tar --sort=name --owner=0 --group=0 --numeric-owner -czf "$name.tar.gz" "$name")
    if command -v ldd >/dev/null && ldd "$folder/washout" 2>&1 | grep -q '=>'; then
        echo "the program still needs libraries of the machine"
        exit 1
    fi
    local there
    there=$(mktemp -d)
    tar -xzf "$dist/$name.tar.gz" -C "$there"
    (cd "$there/$name" && env -i ./washout solve designs/twist-v2.toml --quiet && test -s output/twist-v2/summary.json)
    (cd "$there/$name" && env -i ./washout doctor --json >/dev/null)
    rm -rf "$there" "$folder"
}

wheel() {
    step "the wheel"
    local environment=target/release-python
    [ -x "$environment/bin/python" ] || python3 -m venv "$environment"
    "$environment/bin/python" -m pip install --quiet --disable-pip-version-check "maturin>=1.9,<2"
    rm -f "$dist"/washout-*.whl
    "$environment/bin/python" -m maturin build --release --manifest-path python/Cargo.toml --out "$dist"

    step "the wheel, in an environment of its own"
    local there
    there=$(mktemp -d)
    python3 -m venv "$there/python"
    "$there/python/bin/python" -m pip install --quiet --disable-pip-version-check "$dist"/washout-*.whl
    "$there/python/bin/python" -c 'import washout; print(washout.solve("designs/twist-v2.toml").tip_twist_deg)'
    rm -rf "$there"
}

mkdir -p "$dist"
case $what in
    program) program ;;
    wheel) wheel ;;
    all) program && wheel ;;
    *) echo "usage: .ci/release.sh [program|wheel]" && exit 2 ;;
esac
(cd "$dist" && shopt -s nullglob && sha256sum ./*.tar.gz ./*.whl | tee SHA256SUMS)
step "all good"
