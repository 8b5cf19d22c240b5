#!/bin/bash
# Requirement R-1201: a job whose limit is shorter than a block ends after three legs without one and says so; legs between
# which one was committed count anew. Of an array each task counts its own part. Needs no Slurm.
# idle_test.sh PROGRAM SLURM_FOLDER
set -u
OVERTURN=$1 OVERTURN_SLURM=$2 OVERTURN_LAUNCH=env
export OVERTURN OVERTURN_SLURM OVERTURN_LAUNCH
here=$(cd "$(dirname "$0")" && pwd)
. "$here/campaigns.sh"
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
fail() { echo "idle: $1" >&2; cat said >&2; exit 1; }
unset SLURM_RESTART_COUNT SLURM_JOB_END_TIME
cp -r "$OVERTURN_SLURM" "$tree/slurm"
rm -f "$tree/slurm/site.env"
export OVERTURN_SLURM=$tree/slurm
cd "$tree" || exit 1
mkdir bin other
printf '#!/bin/bash\necho "$*" >>%q\n' "$tree/queued" >bin/scontrol
chmod +x bin/scontrol
export PATH=$tree/bin:$PATH
campaign c 1000000 7
ln -s other/real.h5 link.h5

# leg JOB OPTIONS OF run... : its exit code; what it said is in the file `said`, requeues are counted.
leg() {
    SLURM_JOB_ID=$1 bash slurm/campaign.sbatch c.toml "${@:2}" >said 2>&1
    [ $? -eq 3 ] || fail "a leg that can go on ended otherwise"
}
requeued() { grep -cx "requeue $1" queued; }
short=(--max-walltime '0.001 s') long=(--max-walltime '1.5 s')

# Three in a row, wherever the file is.
# shellcheck disable=SC2086  # no option or two words
for output in "" "-o c.h5" "--output=d.h5" "-oe.h5" "--output link.h5"; do
    rm -f queued
    for _ in 1 2; do leg 7 $output "${short[@]}"; done
    [ "$(requeued 7)" -eq 2 ] || fail "[$output]: not put back into the queue"
    leg 7 $output "${short[@]}"
    [ "$(requeued 7)" -eq 2 ] || fail "[$output]: goes round for ever"
    grep -q "^segment: 3 legs in a row ended without a new block.*overturn plan c.toml --max-walltime LIMIT.*raise the limit" said || fail "[$output]: no word"
done

# One with a block between them, then three again; another job's legs are its own.
rm -f queued
leg 8 "${short[@]}"
leg 8 "${short[@]}"
leg 8 "${long[@]}"
[ "$(blocks_of c)" -gt 0 ] || fail "no block within ${long[1]}"
leg 9 "${short[@]}"
leg 8 "${short[@]}"
leg 8 "${short[@]}"
[ "$(requeued 8)" -eq 5 ] || fail "a leg with a block counts as one without: $(cat queued)"
leg 8 "${short[@]}"
[ "$(requeued 8)" -eq 5 ] || fail "goes round for ever after a block"

# Tasks of an array into one folder: what one does is not the progress of another.
task() { # ARRAY_TASK OPTIONS OF run...
    SLURM_JOB_ID=2$1 SLURM_ARRAY_TASK_ID=$1 SLURM_ARRAY_TASK_COUNT=2 bash slurm/array.sbatch c.toml a.h5 "${@:2}" >said 2>&1
    [ $? -eq 3 ] || fail "a task's leg that can go on ended otherwise"
}
rm -f queued
for _ in 1 2 3; do
    task 1 "${short[@]}"
    before=$(blocks_of a)
    task 2 "${long[@]}"
    more_blocks_than a "$before" || fail "task 2 did no block within ${long[1]}"
done
[ "$(requeued 21)" -eq 2 ] || fail "a task that does nothing takes another's blocks for its own: $(cat queued)"
[ "$(requeued 22)" -eq 3 ] || fail "a task that does blocks ends: $(cat queued)"
[ ! -e a.h5.legs-21 ] || fail "what an idle task kept stays"
[ -s a.h5.legs-22 ] || fail "a task keeps nothing between two legs"

# Nothing of it stays beside a file that is complete, nor after a TERM.
leg 10 -o done.h5 "${short[@]}" --set waves.count=2
[ -s done.h5.legs-10 ] || fail "nothing is kept between two legs"
SLURM_JOB_ID=10 bash slurm/campaign.sbatch c.toml -o done.h5 --set waves.count=2 >said 2>&1 || fail "a campaign of two waves"
[ ! -e done.h5.legs-10 ] || fail "what is kept between two legs stays"
leg 11 "${short[@]}"
SLURM_JOB_ID=11 bash slurm/campaign.sbatch c.toml >said 2>&1 & job=$!
sleep 4
kill -TERM $job
wait $job
[ $? -eq 3 ] || fail "TERM"
[ "$(requeued 11)" -eq 1 ] || fail "put back after a TERM"
[ ! -e c.h5.legs-11 ] || fail "what is kept stays after a TERM"
echo "idle: holds"
