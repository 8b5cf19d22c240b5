#!/bin/bash
# Requirement R-1201: scan.sh runs campaigns one after the other; one that fails ends the chain instead of leaving jobs
# waiting.
# scan_test.sh PROGRAM SLURM_FOLDER
set -u
OVERTURN=$1 OVERTURN_SLURM=$2
export OVERTURN OVERTURN_SLURM
here=$(cd "$(dirname "$0")" && pwd)
. "$here/cluster.sh"
. "$here/campaigns.sh"
cluster_start 1 2
cd "$cluster/runs" || exit 1
campaign first 30 7
campaign second 30 8
echo "seed = 1" >bad.toml

"$OVERTURN_SLURM/scan.sh" first.toml second.toml || fail "scan.sh"
within 60 queue_is_empty || fail "the chain does not end"
[ first.h5 -ot second.h5 ] || fail "the second campaign was not the later one"
expect_same first
expect_same second

jobs=$("$OVERTURN_SLURM/scan.sh" bad.toml second.toml) || fail "scan.sh"
within 60 queue_is_empty || fail "a job waits for one that failed"
[ "$(state_of "$(awk '/^bad/ {print $2}' <<<"$jobs")")" = FAILED ] || fail "a bad campaign did not fail"
