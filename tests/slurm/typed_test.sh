#!/bin/bash
# Requirement R-1201: what README says to type for Slurm works as typed: the program is found where quickstart builds
# it, or one line says what to set; a campaign with a mistake and a script given to sbatch by mistake stop before
# anything is queued.
# typed_test.sh PROGRAM SLURM_FOLDER
set -u
program=$1
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
fail() { echo "typed: $1" >&2; exit 1; }
unset OVERTURN OVERTURN_SLURM SLURM_JOB_ID SLURM_ARRAY_TASK_ID
cp -r "$2" "$tree/slurm"
rm -f "$tree/slurm/site.env"
cd "$tree" || exit 1
here=$(dirname "$0")
. "$(cd "$OLDPWD" && cd "$here" && pwd)/campaigns.sh"
campaign good 4 7
sed 's/pga/pag/' good.toml >bad.toml

# sbatch only notes what it is given; nothing else is on the way to programs but the system's own.
mkdir bin
printf '#!/bin/bash\necho "$OVERTURN $*" >>%q\necho 1\n' "$tree/queued" >bin/sbatch
chmod +x bin/sbatch
export PATH=$tree/bin:/usr/bin:/bin
if command -v overturn >/dev/null; then
    echo "skipped: an overturn is installed"
    exit 77
fi

for parts in 0 x 3x; do
    said=$(slurm/array.sbatch $parts good.toml good.h5 2>&1) && fail "takes $parts for a number of parts"
    [ "$said" = "usage: slurm/array.sbatch PARTS CAMPAIGN.toml FILE.h5 [options of overturn run]" ] || fail "$parts parts: $said"
done
said=$(slurm/array.sbatch 3 good.toml good.h5 2>&1) && fail "runs without a program"
grep -qx "segment: no overturn in PATH, nor built in .*/.build/release. Set OVERTURN in $tree/slurm/site.env" <<<"$said" || fail "$said"
said=$(SLURM_JOB_ID=7 SLURM_SUBMIT_DIR=$tree bash slurm/campaign.sbatch good.toml 2>&1) && fail "a segment without a program"
grep -q "Set OVERTURN in" <<<"$said" || fail "$said"
[ ! -e queued ] || fail "queued without a program: $(cat queued)"

mkdir -p .build/release/src
ln -s "$program" .build/release/src/overturn
said=$(slurm/array.sbatch 3 bad.toml bad.h5 2>&1) && fail "takes a campaign with a mistake"
grep -q "bad.toml:.*'pag'" <<<"$said" || fail "does not name the mistake: $said"
said=$(slurm/array.sbatch 3 good.toml good.h5 --set waves.count=none 2>&1) && fail "takes a setting with a mistake"
grep -q "waves.count" <<<"$said" || fail "does not name the setting: $said"
[ ! -e queued ] || fail "queued with a mistake: $(cat queued)"
said=$(SLURM_JOB_ID=7 SLURM_JOB_NAME=overturn-part bash slurm/array.sbatch 3 good.toml good.h5 2>&1) && fail "runs as a job"
grep -qx "array.sbatch: was given to sbatch (it submits itself). Run: slurm/array.sbatch PARTS CAMPAIGN.toml FILE.h5" <<<"$said" || fail "$said"
[ ! -e queued ] || fail "queued as a job: $(cat queued)"

slurm/array.sbatch 3 good.toml good.h5 --set waves.count=5 --max-walltime "1 h" >said 2>&1 || fail "$(cat said)"
grep -q "^$tree/.build/release/src/overturn --parsable --array=1-3 .*good.toml good.h5 --set waves.count=5" queued || fail "$(cat queued)"
grep -q "limit" said && fail "a word about a limit where none is stated: $(cat said)"
grep -q "wrap=$tree/.build/release/src/overturn merge good.h5" queued || fail "the merge job: $(cat queued)"

# The time limit that sbatch will take from its variable is known before anything waits; Slurm's "1" is a minute.
sed "s/^values = .*/values = {from = '1000 gal', to = '1400 gal', count = 60000}/" good.toml >long.toml
for limit in 0:01 00:00:01 0-00:00:01; do
    said=$(SBATCH_TIMELIMIT=$limit slurm/array.sbatch 3 long.toml long.h5 2>&1) || fail "a limit of a second: $said"
    grep -q "^warning  *within the limit of 1.0 s no block is done" <<<"$said" || fail "no word about a limit of a second: $said"
    grep -q "^[^ w]" <<<"${said%%parts *}" && fail "more than a warning: $said"
done
for limit in 1 UNLIMITED 0; do
    said=$(SBATCH_TIMELIMIT=$limit slurm/array.sbatch 3 long.toml long.h5 2>&1) || fail "the limit $limit: $said"
    [ "$said" = "parts 1, merge 1" ] || fail "the limit $limit: $said"
done
echo "typed: holds"
