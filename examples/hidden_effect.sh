#!/usr/bin/env bash
# A hidden effect from start to end, in ten commands: made, seen, named, added, gone.
#
#   cargo build --release && examples/hidden_effect.sh        (half a minute on two cores)
set -euo pipefail
cd "$(dirname "$0")/.."
washout() { target/release/washout --quiet "$@" --json; }
try=output/hidden-effect
run=$try/three-rods.toml
rm -rf "$try"

echo "1. What could this campaign see at all, before anybody measures?"
washout diagnose studies/three-rods.toml --plan | grep '"sentence"'
echo "2. Somebody measures it, on wings whose rod gives way at the root; we are not told."
washout synthesize studies/three-rods.toml --effect root-flexure=0.2 --seed 11 --output $try >/dev/null
echo "3. Where does the model fail?"
washout compare $run --output $try/before | grep -A3 '^  "chi_square_per_row"'
echo "4. What is missing?"
washout diagnose $run --output $try/diagnosis | grep -m1 '"sentence"'
echo "5. What is that?"
washout effects root-flexure | grep -E '"(summary|formula|source)"'
echo "6. It joins the model at its fitted strength."
washout add root-flexure --to $run --ladder $try/ladder | grep -A3 '"strength"'
echo "7. Where does the model fail now?"
washout compare $run --output $try/after | grep -A3 '^  "chi_square_per_row"'
echo "8. Is anything else missing?"
washout diagnose $run --output $try/again | grep -m1 '"sentence"' | tee $try/last.txt
echo "9. What was it?"
grep -A4 '"acted"' $try/answer.json
echo "10. And without it?"
washout add root-flexure --to $run --remove --ladder $try/without >/dev/null && echo "taken out again"
grep -q "Nothing detectable is missing" $try/last.txt
