#!/bin/bash
# Requirement R-1201, R-1001: an array over two nodes and its dependent merge give the bytes of one run, and so does one
# job over both.
# array_test.sh PROGRAM SLURM_FOLDER
set -u
OVERTURN=$1 OVERTURN_SLURM=$2
export OVERTURN OVERTURN_SLURM
here=$(cd "$(dirname "$0")" && pwd)
. "$here/cluster.sh"
. "$here/campaigns.sh"
cluster_start 2 2
cd "$cluster/runs" || exit 1
campaign c 100 7
campaign wide 60 8

jobs=$("$OVERTURN_SLURM/array.sbatch" 3 c.toml c.h5) || fail "array.sbatch"
merge=${jobs##* }
within 60 queue_is_empty || fail "the jobs do not end"
[ "$(state_of "$merge")" = COMPLETED ] || fail "the merge ended as $(state_of "$merge")"
grep -qh "resuming c.h5: 0 of 33 blocks\|all 33 blocks are done" overturn-part-*.log || fail "no task did a third"
expect_same c

# A task that fails stops nothing: the merge job names its waves, and what computes them finishes the file.
campaign torn 60 9
printf '#!/bin/bash\n[ "${SLURM_ARRAY_TASK_ID:-}" = 2 ] && exit 1\nexec %q "$@"\n' "$OVERTURN" >flaky
chmod +x flaky
jobs=$(OVERTURN=$PWD/flaky "$OVERTURN_SLURM/array.sbatch" 3 torn.toml torn.h5) || fail "array.sbatch"
merge=${jobs##* }
within 60 queue_is_empty || fail "the jobs of the torn array do not end"
[ "$(state_of "$merge")" = FAILED ] || fail "the merge of a torn array ended as $(state_of "$merge")"
grep -q "torn.h5.parts: waves .* are missing" "overturn-merge-$merge.log" || fail "the merge does not name what is missing"
"$OVERTURN" run torn.toml -o torn.h5 --resume >torn.log 2>&1 || fail "the rest of the torn array"
expect_same torn

job=$(sbatch --parsable -N 2 --ntasks-per-node=1 -t 10 "$OVERTURN_SLURM/campaign.sbatch" wide.toml) || fail "sbatch"
within 60 queue_is_empty || fail "the job over two nodes does not end"
[ "$(state_of "$job")" = COMPLETED ] || fail "the job over two nodes ended as $(state_of "$job")"
[ "$(grep -c '"rank"' wide.runtime.json)" -eq 2 ] || fail "not two ranks"
expect_same wide
