#!/usr/bin/env bash
# A run as docs/paraview/washout.py shows it, drawn by real ParaView without a screen into docs/pictures/paraview.png.
# Needs a build (cargo build --release); installs Debian's ParaView if there is none.
set -euo pipefail
cd "$(dirname "$0")/.."

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi; }
if ! command -v pvpython >/dev/null || ! command -v xvfb-run >/dev/null; then
    as_root apt-get update -q
    as_root apt-get install -qy --no-install-recommends paraview python3-paraview xvfb xauth
fi
# Debian's ParaView draws through X, also without a screen
draw() { xvfb-run -a -s '-screen 0 1600x1200x24' pvpython docs/paraview/washout.py; }

run=target/paraview/run
picture=docs/pictures/paraview.png
rm -rf target/paraview "$picture"
target/release/washout solve designs/twist-v2.toml --quiet --output $run
WASHOUT_RUN=$run WASHOUT_PICTURE=$picture draw
# a picture with nothing in it is some kilobytes
test "$(stat -c %s "$picture")" -gt 20000
if WASHOUT_RUN=$run WASHOUT_COLOUR=nothing draw 2>/dev/null; then
    echo "an unknown array was accepted" >&2
    exit 1
fi
echo "drawn: $picture"
