#!/usr/bin/env bash
# Runs farm.sbatch for real, on a Slurm of its own on this machine: 200 creatures in an array of 4, of which one task is killed and requeued in the middle.
# Then nothing may be missing and nothing there twice. Needs Debian's packages, which are unpacked, not installed, and root.
#   slurm-rehearsal.sh CREATUREGEN FOLDER
set -euo pipefail
program=$(realpath "$1"); place=$(mkdir -p "$2" && realpath "$2"); here=$(dirname "$(realpath "$0")")
cd "$place"

if [ ! -d root ]; then
    mkdir -p packages root
    (cd packages && apt-get download -q slurmctld slurmd slurm-client slurm-wlm-basic-plugins munge libmunge2 libhwloc15 libjson-c5 liblz4-1 libyaml-0-2 liblua5.1-0 libnuma1 libdbus-1-3 > ../packages.log 2>&1)
    for package in packages/*.deb; do dpkg -x "$package" root; done
fi
root=$place/root
libraries=$(dirname "$(find "$root/usr/lib" -name 'libmunge.so.2' | head -1)")
export LD_LIBRARY_PATH=$libraries:$libraries/slurm-wlm
export PATH=$root/usr/bin:$root/usr/sbin:$PATH SLURM_CONF=$place/slurm.conf
node=$(hostname -s)

rm -rf run spool state creatures whole ./*.log; mkdir -p run spool state
[ -s munge.key ] || (umask 077; head -c 1024 /dev/urandom > munge.key)
chmod 700 run spool state
cat > slurm.conf <<END
ClusterName=rehearsal
SlurmctldHost=$node(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$place/run/munge.socket
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
StateSaveLocation=$place/state
SlurmdSpoolDir=$place/spool
SlurmctldPidFile=$place/run/slurmctld.pid
SlurmdPidFile=$place/run/slurmd.pid
SlurmctldLogFile=$place/slurmctld.log
SlurmdLogFile=$place/slurmd.log
SlurmctldPort=16817
SlurmdPort=16818
PluginDir=$libraries/slurm-wlm
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
KillWait=5
JobRequeue=1
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 RealMemory=2000 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES State=UP MaxTime=INFINITE
END

stop() {
    for name in slurmd slurmctld munged; do
        if [ -s "run/$name.pid" ]; then kill "$(cat "run/$name.pid")" 2> /dev/null || true; fi
    done
}
trap stop EXIT
munged --force --key-file="$place/munge.key" --socket="$place/run/munge.socket" --pid-file="$place/run/munged.pid" --log-file="$place/munged.log" --seed-file="$place/run/munged.seed" --num-threads=2
slurmctld-wlm
slurmd-wlm -d "$(command -v slurmstepd-wlm)" -N "$node"
for _ in $(seq 60); do sinfo -h -o %T 2> /dev/null | grep -q idle && break; sleep 0.5; done
sinfo

began=$(date +%s%N)
job=$(CREATUREGEN=$program SEEDS=${SEEDS:-1-200} OUT=$place/creatures OPTIONS=${OPTIONS:---textures 512 --picture-size 256x192} sbatch --parsable --array=0-3 --mem=400M --chdir="$place" "$here/farm.sbatch")
echo "job $job"

# In the middle of the first task it is killed, as by a node that fails, and put back into the queue.
made() { grep -c '"files"' creatures/manifest-0-of-4.jsonl 2> /dev/null || true; }
for _ in $(seq 600); do
    if [ "0$(made)" -ge 10 ]; then break; fi
    sleep 0.1
done
scancel --signal=KILL "${job}_0" || true
scontrol requeue "${job}_0"
echo "task 0 killed and requeued after $(made) creatures"
before=$(stat -c %Y creatures/creature-1.glb)
# Without a wait for the time at which Slurm would begin it again.
for _ in $(seq 1200); do
    [ -n "$(squeue -h)" ] || break
    scontrol update jobid="${job}_0" starttime=now 2> /dev/null || true
    sleep 0.25
done
[ -z "$(squeue -h)" ] || { squeue; echo "the job does not end"; exit 1; }
echo "all tasks done after $((($(date +%s%N) - began) / 1000000)) ms"

"$program" merge creatures
"$program" verify --manifest creatures
[ "$(stat -c %Y creatures/creature-1.glb)" = "$before" ] || { echo "a creature that was there was made again"; exit 1; }
grep -h "there already" creatures-*.log | head -1
listed=$(grep -o '"seed":"[0-9]*"' creatures/manifest.jsonl | sort -u | wc -l)
[ "$listed" = "$(grep -c '"files"' creatures/manifest.jsonl)" ] || { echo "a creature is listed twice"; exit 1; }
echo "$listed creatures, none lost, none twice"
