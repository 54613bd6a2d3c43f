#!/usr/bin/env bash
# A wing whose outline real Gmsh meshes, in both formats, solved on these meshes: twist within 3 % of washout's own mesh.
# Needs a build (cargo build --release); installs Debian's gmsh if there is none.
set -euo pipefail
cd "$(dirname "$0")/.."

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo -n "$@"; fi; }
if ! command -v gmsh >/dev/null; then
    as_root apt-get update -q
    as_root apt-get install -qy gmsh
fi

design=designs/twist-v2.toml
folder=target/gmsh
rm -rf "$folder"
tip() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["tip"]["twist_deg"])' "$1/summary.json"; }

target/release/washout mesh $design --quiet --output $folder/mesh
target/release/washout solve $design --quiet --output $folder/own
for format in msh41 msh22; do
    gmsh -2 -v 2 -format $format $folder/mesh/outline.geo -o $folder/$format.msh
    target/release/washout solve $design --quiet --mesh "$PWD/$folder/$format.msh" --output $folder/$format
    python3 -c 'import sys; own, other = map(float, sys.argv[1:])
print(f"tip twist {own:.3f} deg on the mesh of washout, {other:.3f} deg on that of Gmsh")
assert abs(other / own - 1) < 0.03' "$(tip $folder/own)" "$(tip $folder/$format)"
done
