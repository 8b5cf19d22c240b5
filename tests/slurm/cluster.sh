# A throw-away Slurm cluster on this host, for the tests here: everything in one folder, gone with the test.
# Sourced. cluster_start NODES CPUS; then $cluster is its folder and sbatch, squeue, ... talk to it. Ends with the shell.
# shellcheck shell=bash

skip() {
    echo "skipped: $*"
    exit 77
}

cluster_needs() {
    local tool
    export PATH="$PATH:/usr/sbin:/sbin"
    [ "$(id -u)" -eq 0 ] || skip "Slurm's daemons need root"
    for tool in munged slurmctld slurmd sbatch squeue scancel scontrol; do
        command -v $tool >/dev/null || skip "no $tool here (apt-get install slurmctld slurmd slurm-client munge)"
    done
}

# As many free ports in a row as asked for.
free_ports() {
    local first port
    for _ in {1..50}; do
        first=$((20000 + RANDOM % 12000))
        for ((port = first; port < first + $1; port++)); do
            ! (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || continue 2
        done
        echo $first
        return
    done
    return 1
}

within() { # SECONDS COMMAND... : true as soon as the command is
    local end=$((SECONDS + $1))
    while [ $SECONDS -lt $end ]; do
        "${@:2}" >/dev/null 2>&1 && return
        sleep 0.1
    done
    return 1
}

cluster_start() {
    local nodes=$1 cpus=$2 host ports names=() i
    cluster_needs
    cluster=$(mktemp -d "${TMPDIR:-/tmp}/overturn-slurm.XXXXXX")
    trap cluster_stop EXIT
    chmod 755 "$cluster"
    mkdir -p "$cluster"/{state,run,runs}
    mkdir -m 700 "$cluster/munge"
    host=$(hostname -s)
    ports=$(free_ports $((nodes + 1))) || skip "no free ports"
    head -c 128 /dev/urandom >"$cluster/munge/key"
    chmod 400 "$cluster/munge/key"
    # One node bears the host's name, as a real one does: mpirun then starts its ranks itself.
    if [ "$nodes" -eq 1 ]; then names=("$host"); else for ((i = 1; i <= nodes; i++)); do names+=("node$i"); done; fi
    for i in "${names[@]}"; do mkdir -p "$cluster/spool/$i" "$cluster/tmp/$i"; done
    export SLURM_CONF=$cluster/slurm.conf
    cat >"$SLURM_CONF" <<END
ClusterName=overturn
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$ports
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$cluster/run/munge.socket,cred_expire=5
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool/%n
TmpFS=$cluster/tmp/%n
SlurmctldPidFile=$cluster/run/slurmctld.pid
SlurmdPidFile=$cluster/run/slurmd-%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobCompType=jobcomp/filetxt
JobCompLoc=$cluster/jobs.txt
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=bf_interval=1,batch_sched_delay=0,sched_interval=1
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=2
MinJobAge=300
$(for i in "${!names[@]}"; do
        echo "NodeName=${names[i]} NodeHostname=$host NodeAddr=127.0.0.1 Port=$((ports + 1 + i)) CPUs=$cpus State=UNKNOWN"
    done)
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
    munged --socket="$cluster/run/munge.socket" --key-file="$cluster/munge/key" --pid-file="$cluster/run/munged.pid" \
        --log-file="$cluster/munge/log" --seed-file="$cluster/munge/seed" </dev/null >"$cluster/munged.out" 2>&1 ||
        skip "munged does not start: $(tail -1 "$cluster/munged.out")"
    slurmctld -c </dev/null >"$cluster/slurmctld.out" 2>&1 || skip "slurmctld does not start: $(tail -1 "$cluster/slurmctld.out")"
    for i in "${names[@]}"; do
        slurmd -N "$i" </dev/null >"$cluster/slurmd-$i.out" 2>&1 || skip "slurmd does not start: $(tail -1 "$cluster/slurmd-$i.out")"
    done
    within 30 cluster_is_idle "$nodes" || skip "the nodes do not come up: $(tail -1 "$cluster/slurmctld.log")"
    # Whatever core and network this host has: ranks may share cores and talk over the loopback.
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
    export OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader,tcp
    export OMPI_MCA_btl_tcp_if_include=lo OMPI_MCA_oob_tcp_if_include=lo
}

cluster_is_idle() { [ "$(sinfo -h -N -t idle -o %N | sort -u | wc -l)" -eq "$1" ]; }

cluster_stop() {
    local pids=() file
    if [ -n "$(squeue -h 2>/dev/null)" ]; then
        scancel -u root 2>/dev/null
        within 10 queue_is_empty
    fi
    for file in "$cluster"/run/slurmd-*.pid "$cluster/run/slurmctld.pid" "$cluster/run/munged.pid"; do
        [ ! -s "$file" ] || pids+=("$(cat "$file")")
    done
    [ ${#pids[@]} -eq 0 ] || kill "${pids[@]}" 2>/dev/null
    within 10 all_gone "${pids[@]}" || kill -KILL "${pids[@]}" 2>/dev/null
    rm -rf "$cluster"
}

all_gone() { ! kill -0 "$@" 2>/dev/null; }
queue_is_empty() { [ -z "$(squeue -h)" ]; }

# How a job ended, from the list of finished jobs: COMPLETED, FAILED, ...
state_of() { grep "^JobId=$1 " "$cluster/jobs.txt" | tail -1 | grep -o 'JobState=[A-Z]*' | cut -d= -f2; }

# Fails the test, with what the jobs and daemons said.
fail() {
    echo "FAILED: $*"
    tail -n 12 "$cluster"/runs/*.log "$cluster/jobs.txt" "$cluster/slurmctld.log" 2>/dev/null
    exit 1
}
