#!/bin/bash
# Requirement R-1201, R-1102: campaign.sbatch as it is, under a real time limit: Slurm itself sends USR1, segments follow
# until complete. The limit is the five minutes of the warning, so that it comes when Slurm first looks (every half
# minute).
# limit_test.sh PROGRAM SLURM_FOLDER
set -u
OVERTURN=$1 OVERTURN_SLURM=$2
export OVERTURN OVERTURN_SLURM
here=$(cd "$(dirname "$0")" && pwd)
. "$here/cluster.sh"
. "$here/campaigns.sh"
cluster_start 1 2
cd "$cluster/runs" || exit 1
campaign c 1000000 7  # longer than any segment

job=$(sbatch --parsable -n 1 -t 5 "$OVERTURN_SLURM/campaign.sbatch" c.toml) || fail "sbatch"
within 50 grep -q "stopped early" overturn-"$job".log || fail "Slurm's own warning did not make the run leave"
within 60 grep -q "resuming c.h5: [1-9][0-9]* of" overturn-"$job".log || fail "no second segment resumed"
