#!/usr/bin/env bash
# Opens reports in Debian's Chromium without a screen: no error, the wing drawn in every colour, view and state, by WebGL and
# without it, every number shown and every value under the cursor as the documents in the page have it, the same without
# JavaScript. Writes the screenshots of docs/report.md. Installs chromium where it is not.
# Usage: .ci/report_in_chromium.sh [STUDY]
set -euo pipefail
cd "$(dirname "$0")/.."
export DEBIAN_FRONTEND=noninteractive
study=${1:-studies/tang-dowell-wind.toml}
out=target/report
mkdir -p "$out" docs/pictures

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi; }

if ! command -v chromium >/dev/null; then
    as_root apt-get update -q
    as_root apt-get install -qy --no-install-recommends chromium fonts-dejavu-core
fi

cargo build --release --quiet
target/release/washout solve designs/twist-v2.toml --quiet --report --output "$out/run"
target/release/washout solve designs/twist-v2.toml --stroke 36 --quiet --report --output "$out/stroke"
target/release/washout report "$study" --quiet --output "$out/study.html"
target/release/washout lift designs/rigid.toml designs/twist-v2.toml --quiet --report --output "$out/lift"
target/release/washout modes designs/twist-v2.toml --quiet --report --output "$out/modes"
target/release/washout sweep designs/twist-v2.toml --set mesh.refine=0.5 --vary flapping.frequency_hz=20,23 --quiet --report --output "$out/sweep"
python3 .ci/report_in_chromium.py "$out/"{run,stroke}/report.html "$out/study.html" "$out/"{lift,modes,sweep}/report.html --pictures docs/pictures --work "$out"
