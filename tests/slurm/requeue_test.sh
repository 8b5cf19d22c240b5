#!/bin/bash
# Requirement R-1201, R-1102, R-919: told to leave by SIGUSR1, a job goes back into the queue and completes to the bytes of an
# unbroken run.
# requeue_test.sh PROGRAM SLURM_FOLDER
set -u
OVERTURN=$1 OVERTURN_SLURM=$2
export OVERTURN OVERTURN_SLURM
here=$(cd "$(dirname "$0")" && pwd)
. "$here/cluster.sh"
. "$here/campaigns.sh"
cluster_start 1 2
cd "$cluster/runs" || exit 1
campaign c 2500 7  # longer than the three seconds in which a launcher is not told

job=$(sbatch --parsable -n 2 -t 10 "$OVERTURN_SLURM/campaign.sbatch" c.toml) || fail "sbatch"
within 30 more_blocks_than c 5 || fail "no block was committed"
scancel --batch --signal=USR1 "$job"
within 30 grep -q "stopped early" overturn-"$job".log || fail "the run did not leave"
before=$(blocks_of c)
[ "$before" -gt 0 ] || fail "nothing was committed"
within 60 queue_is_empty || fail "the job does not end"

[ "$(state_of "$job")" = COMPLETED ] || fail "the job ended as $(state_of "$job")"
grep -q "resuming c.h5: $before of [0-9]* blocks are done" overturn-"$job".log || fail "the second segment did not resume"
expect_same c

# Told to leave by TERM, as who preempts it does, a job ends at once with 3 and is left to who told it.
campaign t 100000 9
job=$(sbatch --parsable -n 2 -t 10 "$OVERTURN_SLURM/campaign.sbatch" t.toml) || fail "sbatch"
within 30 more_blocks_than t 5 || fail "no block was committed"
scancel --batch --signal=TERM "$job"
within 30 queue_is_empty || fail "the job does not leave"
grep -q "stopped early" overturn-"$job".log || fail "the run was killed"
grep -q "^JobId=$job .* ExitCode=3:0" "$cluster/jobs.txt" || fail "the job's exit code does not say that it can go on"
