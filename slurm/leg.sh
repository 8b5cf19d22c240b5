# One leg of a campaign: as much of it as this job's time allows. Sourced by the batch scripts here.
# shellcheck shell=bash

# What the site says, from beside this file: copy site.env.example to site.env.
[ ! -e "$slurm/site.env" ] || . "$slurm/site.env"
: "${OVERTURN:=overturn}" "${OVERTURN_LAUNCH:=mpirun}" "${OVERTURN_MOST_LEGS:=100}"

# leg ARGUMENTS OF run... : 0 the work is complete, 3 the job has been put back into the queue, else what run returned.
leg() {
    local pid code
    $OVERTURN_LAUNCH "$OVERTURN" run "$@" --resume & pid=$!
    trap 'kill -USR1 $pid' USR1  # from --signal: finish the blocks in hand
    trap 'kill -TERM $pid' TERM  # preempted: leave within a second
    wait $pid; code=$?
    while kill -0 $pid 2>/dev/null; do  # a trapped signal ends wait, not the run
        wait $pid; code=$?
    done
    trap - USR1 TERM
    [ $code -eq 3 ] || return $code
    if [ "${SLURM_RESTART_COUNT:-0}" -ge "$OVERTURN_MOST_LEGS" ]; then
        echo "leg: still not complete after $OVERTURN_MOST_LEGS legs (is the time limit shorter than a block?). Raise it" >&2
        return 3
    fi
    scontrol requeue "$SLURM_JOB_ID"
    return $code
}
