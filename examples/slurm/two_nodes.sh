#!/usr/bin/env bash
# A sweep on a cluster of Slurm with two nodes, both on this machine, one of which dies half-way: the table is that of one
# machine, nothing is lost, and nothing is done twice but what the dead node had begun.
#
#   sudo apt-get install slurm-wlm munge && cargo build --release && sudo examples/slurm/two_nodes.sh
#
# Needs root, for munge and slurmd. Everything that it starts is ended again; what it writes is in output/slurm.
set -euo pipefail
cd "$(dirname "$0")/../.."
here=$PWD/output/slurm
source examples/slurm/cluster.sh

cases=${1:-120}
sweep=(designs/twist-v2.toml --vary "flapping.frequency_hz=15..26:$cases" --task-size 4)
washout() { target/release/washout "$@"; }
echo "== on one machine, without Slurm"
washout --quiet sweep "${sweep[@]}" --output "$here/alone"

echo "== on two nodes; n2 dies when a third of the tasks is done"
washout sweep "${sweep[@]}" --output "$here/cluster" --slurm --partition try --minutes 10 >"$here/washout.log" 2>&1 &
waiting=$!
tasks=$(((cases + 3) / 4))
done_() { find "$here/cluster-tasks" -name "[0-9]*.json" 2>/dev/null | wc -l; }
while [ "$(done_)" -lt $((tasks / 3)) ]; do sleep 0.2; done
squeue -o "%i %j %T %N"
find "$here/cluster-tasks" -name "[0-9]*.json" -printf '%f %T@\n' | sort >"$here/before.txt"
echo "killing n2 with what it runs, $(done_) of $tasks tasks done"
pkill -9 -F "$here/slurmd-n2.pid"
for pid in $(pgrep -f "$here/spooln2"); do kill -9 "$pid" 2>/dev/null || true; done
wait $waiting || { cat "$here/washout.log"; exit 1; }
cat "$here/washout.log"

echo "== what came of it"
cmp "$here/alone/sweep.csv" "$here/cluster/sweep.csv" && echo "the table is the same, bit for bit: $cases cases"
find "$here/cluster-tasks" -name "[0-9]*.json" -printf '%f %T@\n' | sort >"$here/after.txt"
again=$(comm -23 "$here/before.txt" "$here/after.txt" | wc -l)
echo "tasks that were done before n2 died and done again: $again"
[ "$again" = 0 ]
starts=$(find "$here/cluster-tasks/slurm" -name 'task-*.log' | wc -l)
echo "tasks $tasks, started $starts times by the array jobs (a requeued task keeps its log)"
