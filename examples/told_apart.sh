#!/usr/bin/env bash
# Two effects that a campaign cannot tell apart, the experiment that would, and the campaign with it.
#
#   cargo build --release && examples/told_apart.sh        (seconds)
set -euo pipefail
cd "$(dirname "$0")/.."
washout() { target/release/washout --quiet "$@"; }
try=output/told-apart
rm -rf "$try"
mkdir -p "$try"
head=case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound
rows() { for r in "${@:2}"; do echo "$1,twist,chord_rotation,deg,washout,,$r,,,0.01,stated,none"; done; }

# a steel rod under three torques, its twist read near the tip; or, as an experiment, near the root
cat >$try/rod.toml <<'ROD'
format = 1
name = "rod"
[planform]
length_mm = 100.0
outline = [[0.0, 20.0], [100.0, 20.0]]
tip_cut = 1.0
[ribs]
bays = 10
[[rod]]
from_mm = 0.0
to_mm = 100.0
material = "steel"
section = { shape = "round", diameter_mm = 1.0 }
[material.steel]
e_gpa = 200.0
g_gpa = 80.0
poisson = 0.25
density_kg_m3 = 8000.0
[[load]]
at_mm = 100.0
moment_n_m = [0.001, 0.0, 0.0]
ROD
{ echo $head; for m in 1 2 3; do rows "m-$m" 98 99 100; done; } >$try/m.csv
{ echo $head; rows tip-again 100; rows near-the-root 10 20; } >$try/next.csv
cat >$try/study.toml <<'STUDY'
format = 1
name = "told-apart"
candidates = ["rod-shear-modulus", "root-flexure"]
[[case]]
design = "rod.toml"
set = ["load[0].moment_n_m=[{moment*0.001}, 0, 0]"]
measurement = "m.csv"
measured = "m-{moment}"
[[experiment]]
design = "rod.toml"
set = ["load[0].moment_n_m=[0.003, 0, 0]"]
measurement = "next.csv"
measured = "tip-again"
[[experiment]]
design = "rod.toml"
set = ["load[0].moment_n_m=[0.003, 0, 0]"]
measurement = "next.csv"
measured = "near-the-root"
STUDY

echo "Measured near the tip alone:"
washout synthesize $try/study.toml --effect root-flexure=0.2 --seed 7 --output $try/first
washout diagnose $try/first/study.toml --output $try/first/out --json |
    grep -E '"(sentence|best)"' | tee $try/first.txt
grep -q 'root-flexure.*rod-shear-modulus.*cannot tell apart' $try/first.txt
grep -q '"best": "near-the-root"' $try/first.txt

echo "With the experiment that it names:"
{ echo $head; for m in 1 2 3; do rows "m-$m" 98 99 100; done; rows m-3 10 20; } >$try/m.csv
washout synthesize $try/study.toml --effect root-flexure=0.2 --seed 7 --output $try/second
washout diagnose $try/second/study.toml --output $try/second/out --json | grep -m1 '"sentence"' | tee $try/second.txt
grep -q "Missing: root-flexure" $try/second.txt
