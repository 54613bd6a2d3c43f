# A cluster of Slurm with two nodes of one core, both on this machine, until the script that sources this ends; files in $here.
rm -rf "$here"
mkdir -p "$here"/state "$here"/spooln1 "$here"/spooln2
host=$(hostname -s)
conf=$here/slurm.conf
cat >"$conf" <<CONF
ClusterName=try
SlurmctldHost=$host
SlurmUser=root
SlurmctldPort=16817
AuthType=auth/munge
CryptoType=crypto/munge
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/spool%n
SlurmctldPidFile=$here/slurmctld.pid
SlurmdPidFile=$here/slurmd-%n.pid
SlurmctldLogFile=$here/slurmctld.log
SlurmdLogFile=$here/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdTimeout=20
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
NodeName=n1 NodeHostname=$host Port=17001 CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname=$host Port=17002 CPUs=1 State=UNKNOWN
PartitionName=try Nodes=n1,n2 Default=YES MaxTime=60 State=UP
CONF
export SLURM_CONF=$conf
stop() {
    scancel --user=root 2>/dev/null || true
    for pid in "$here"/*.pid; do kill "$(cat "$pid")" 2>/dev/null || true; done
    [ -z "${munge:-}" ] || kill "$munge" 2>/dev/null || true
}
trap stop EXIT

# munge, which tells the daemons from strangers, runs as its own user
[ -f /etc/munge/munge.key ] || { command -v mungekey >/dev/null && mungekey --create || create-munge-key -f; }
mkdir -p /run/munge
chown munge:munge /run/munge /etc/munge/munge.key
if ! munge -n >/dev/null 2>&1; then
    setpriv --reuid=munge --regid=munge --clear-groups munged --foreground >"$here/munged.log" 2>&1 &
    munge=$!
    for _ in $(seq 50); do munge -n >/dev/null 2>&1 && break; sleep 0.1; done
fi
slurmctld -f "$conf"
slurmd -f "$conf" -N n1
slurmd -f "$conf" -N n2
for _ in $(seq 100); do [ "$(sinfo -h -t idle -o %D)" = 2 ] && break; sleep 0.2; done
sinfo
