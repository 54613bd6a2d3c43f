#!/usr/bin/env bash
# An effect that no library has: hidden, not named for something else, added by a formula of one's own, gone.
#
#   cargo build --release && examples/own_effect.sh        (a minute and a half on two cores)
set -euo pipefail
cd "$(dirname "$0")/.."
washout() { target/release/washout --quiet "$@" --json; }
try=output/own-effect
run=$try/three-rods.toml
rm -rf "$try"

washout synthesize studies/three-rods.toml --own examples/loose_seam.toml --seed 21 --output $try >/dev/null
washout diagnose $run --output $try/diagnosis | grep -m2 -E '"(sentence|verdict)"' | tee $try/first.txt
grep -q '"verdict": "novel"' $try/first.txt
echo "The builder who sees the field along the span knows the seam, and its formula joins the model:"
washout add loose-seam --own examples/loose_seam.toml --to $run --ladder $try/ladder | grep -A3 '"strength"'
washout diagnose $run --output $try/again | grep -m1 '"sentence"' | tee $try/last.txt
grep -qE "Nothing detectable is missing|most likely nothing is missing" $try/last.txt
