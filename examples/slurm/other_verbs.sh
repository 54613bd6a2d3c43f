#!/usr/bin/env bash
# A blind run, a front of several seeds and a design search as job arrays on a cluster of Slurm with two nodes, both on this
# machine: each answer is that of one machine without Slurm.
#
#   sudo apt-get install slurm-wlm munge && cargo build --release && sudo examples/slurm/other_verbs.sh
#
# Needs root, for munge and slurmd. Everything that it starts is ended again; what it writes is in output/slurm-verbs.
set -euo pipefail
cd "$(dirname "$0")/../.."
here=$PWD/output/slurm-verbs
source examples/slurm/cluster.sh

washout() { target/release/washout --quiet "$@"; }
cluster=(--slurm --partition try --minutes 20)
front=(pareto designs/rigid.toml --no-gain --population 40 --generations 30 --restarts 4)
layout=(design designs/twist-v2.toml --stock designs/stock.csv --lift 25 --pieces 1 --set mesh.refine=0.3 --first-look 1 --task-size 2)
blind=(blind 4 --study studies/three-rods.toml --set mesh.refine=0.3 --effect rod-shear-modulus --effect root-flexure --kind single
    --kind null --task-size 1)

same() { # WHAT FOLDER FOLDER
    for file in "$2"/*.*; do cmp "$file" "$3/$(basename "$file")"; done
    echo "$1: the same files, bit for bit ($(find "$here/cluster-$1-tasks/slurm" -name 'task-*.log' | wc -l) tasks)"
}
for what in front layout; do
    declare -n words=$what
    washout "${words[@]}" --output "$here/alone-$what"
    washout "${words[@]}" --output "$here/cluster-$what" "${cluster[@]}"
    same $what "$here/alone-$what" "$here/cluster-$what"
done

# times of diagnoses differ, and nothing else
board() { sed 's/ Median time .*//; s/| [0-9]* |$/|/' "$1/scoreboard.md"; }
washout "${blind[@]}" --output "$here/alone-blind"
washout "${blind[@]}" --output "$here/cluster-blind" "${cluster[@]}"
cmp <(board "$here/alone-blind") <(board "$here/cluster-blind")
echo "blind: the same scoreboard ($(find "$here/cluster-blind-tasks/cases" -name '*.json' | wc -l) cases)"
