#!/bin/bash
# Requirement R-1202, R-907, R-915, R-1009: cmake --install gives a tree that works alone: program, Python package, campaigns, batch
# scripts, man page and completion, without the source or build tree.
# install_test.sh BUILD_TREE SOURCE_TREE
set -euo pipefail
build=$1 source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "install: $1" >&2; exit 1; }

cmake --install "$build" --prefix "$scratch/prefix" > "$scratch/log" || fail "$(tail -3 "$scratch/log")"
prefix=$scratch/prefix data=$scratch/prefix/share/overturn
for file in bin/overturn share/man/man1/overturn.1 share/bash-completion/completions/overturn share/overturn/campaigns/quickstart.toml \
            share/overturn/campaigns/bodies/cask_prototype.toml share/overturn/campaigns/KEYS.md \
            share/overturn/campaigns/schema.json share/overturn/campaigns/bodies/schema.json share/overturn/slurm/campaign.sbatch share/overturn/slurm/overturn.def \
            share/overturn/slurm/spack.yaml share/overturn/python/overturn/draw.py share/overturn/python/overturn/report/campaign_page.py share/doc/overturn/LICENSE share/doc/overturn/THIRD_PARTY.md; do
    [ -s "$prefix/$file" ] || fail "$file is missing"
done
for script in $(cd "$source/src/report" && git ls-files overturn 2>/dev/null || find overturn -name '*.py'); do
    cmp -s "$source/src/report/$script" "$data/python/$script" || fail "python/$script is missing or another"
done
[ -z "$(find "$data/python" ! -name '*.py' ! -type d)" ] || fail "something else than scripts lies in the Python package"
[ ! -e "$data/slurm/site.env" ] || fail "site.env of this machine came along"
for script in array.sbatch scan.sh; do [ -x "$data/slurm/$script" ] || fail "slurm/$script cannot be executed"; done
! grep -rqF "$source" "$prefix/share" || fail "$(grep -rlF "$source" "$prefix/share" | head -1) names the source tree"

# The man page: every verb and option of the program, nothing that groff would complain of.
overturn=$prefix/bin/overturn
for verb in $("$overturn" --help | awk '/^Subcommands:/ { on = 1; next } on && NF { print $1 }'); do
    grep -qx ".SS $verb" "$prefix/share/man/man1/overturn.1" || fail "the man page does not know $verb"
    for option in $("$overturn" "$verb" --help | grep -oE '^  (-.,)?--[a-z-]+' | grep -oE -e '--[a-z-]+'); do
        tr -d '\\' < "$prefix/share/man/man1/overturn.1" | sed -n "/^.SS $verb\$/,/^.S[SH]/p" | grep -qE -- "$option( |\$)" ||
            fail "the man page does not know $verb $option"
    done
done
if command -v groff >/dev/null; then
    said=$(groff -man -Tutf8 -ww -z "$prefix/share/man/man1/overturn.1" 2>&1)
    [ -z "$said" ] || fail "the man page: $said"
fi

# The completion, as bash calls it.
complete_words() {
    bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _overturn; echo "${COMPREPLY[*]}"' _ \
        "$prefix/share/bash-completion/completions/overturn" "$@"
}
[ "$(complete_words overturn rep)" = "replay report" ] || fail "completion of 'rep': $(complete_words overturn rep)"
[ "$(complete_words overturn run --max)" = --max-walltime ] || fail "completion of 'run --max'"
[ "$(complete_words overturn list k)" = keys ] || fail "completion of 'list k'"
[ "$(complete_words overturn list keys sta)" = statistics ] || fail "completion of 'list keys sta'"
[ -z "$(complete_words overturn fit c.h)" ] || fail "completion of a file's name is bash's own"

# Work, in a world without the source tree where the kernel lets us make one.
mkdir "$scratch/work"
cat > "$scratch/work.sh" <<'END'
set -eu
cd "$1"
export PATH=$2/bin:/usr/bin:/bin HOME=$1
[ "$4" = visible ] || [ ! -e "$3/CMakeLists.txt" ]
overturn list > list.txt
overturn run "$2/share/overturn/campaigns/quickstart.toml" --set waves.count=3 -o q.h5 > run.txt 2> said.txt
overturn status q.h5
overturn fit q.h5 --json > fit.json
overturn replay q.h5 --trial 5 | grep -q 'bit-equal to the stored row'
for campaign in design_basis slip_limit; do overturn plan "$2/share/overturn/campaigns/$campaign.toml" > plan.txt; done
if /usr/bin/python3 -c 'import matplotlib, h5py' 2>/dev/null; then
    overturn report q.h5 -o q.html 2>> said.txt
    PYTHONPATH=$2/share/overturn/python /usr/bin/python3 -Bc '
import sys, overturn
from overturn import program
assert program.program_path() == sys.argv[1] + "/bin/overturn", program.program_path()
results = overturn.run(sys.argv[1] + "/share/overturn/campaigns/quickstart.toml", "c.h5", settings={"waves.count": 3})
assert (results.trials["verdict"].names == overturn.open("q.h5").trials["verdict"].names).all()
assert overturn.status("q.h5").complete and results.trials["peak_rotation"].units == "rad"
try:
    import pandas, xarray
    assert len(results.trials.to_pandas()) == results.trials.to_xarray().sizes["trial"] > 0
except ImportError:
    pass
' "$2" 2>> said.txt
fi
slurm=$2/share/overturn/slurm
. "$slurm/segment.sh"
[ "$OVERTURN" = "$2/bin/overturn" ]
END
hide='mount -t tmpfs none "$3"; exec bash /dev/fd/9 "$1" "$2" "$3" hidden'
if unshare -rm bash -c 'mount -t tmpfs none "$1"' _ "$source" 2>/dev/null; then
    unshare -rm bash -c "$hide" _ "$scratch/work" "$prefix" "$source" 9< "$scratch/work.sh" || fail "nothing works without the source tree: $(cat "$scratch/work/said.txt")"
else
    echo "install: this kernel hides no folder; the source tree stays visible"
    env -i bash "$scratch/work.sh" "$scratch/work" "$prefix" "$source" visible || fail "the installed program does not work"
fi
echo "install: all is well"
