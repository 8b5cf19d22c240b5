#!/bin/bash
# Requirement R-919: the examples for Snakemake and Parsl bring campaigns to their files and answers, take a larger campaign up
# where the smaller one ended, and end with a failure where a campaign has a mistake.
# workflows_test.sh PROGRAM SOURCE_TREE
set -u
program=$1 source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "workflows: $1" >&2; exit 1; }
. "$source/tests/slurm/campaigns.sh"
tried=0

begin() {  # FOLDER
    mkdir "$scratch/$1" && cd "$scratch/$1" || exit 1
    campaign a 3 7
    campaign b 2 8
}
expect_waves() {  # FILE COUNT
    "$program" status "$1" --json | grep -q "\"counted\": $2,\$" || fail "$1: not of $2 waves: $("$program" status "$1")"
}

if command -v snakemake >/dev/null; then
    tried=1
    begin snakemake
    work() { snakemake -s "$source/slurm/workflows/Snakefile" -j 2 --config campaigns="a.toml b.toml" overturn="$program" >said 2>&1; }
    work || fail "Snakemake: $(tail -5 said; cat ./*.log)"
    expect_waves a.h5 3 && expect_waves b.h5 2
    grep -q '"answer"' a.fit.json || fail "Snakemake: no answer"
    sed -i 's/count = 3/count = 5/' a.toml
    work || fail "Snakemake: $(tail -5 said)"
    expect_waves a.h5 5
    grep -q 'extending a.h5' a.log || fail "Snakemake: a larger campaign was begun anew"
    grep -q 'extending b.h5' b.log && fail "Snakemake: what had not changed was run again"
    sed -i 's/pga/pag/' a.toml
    work && fail "Snakemake: takes a campaign with a mistake"
    grep -q "a.toml:.*'pag'" a.log || fail "Snakemake: does not say what is wrong"
    cd "$scratch" || exit 1
else
    echo "workflows: no Snakemake here (apt-get install snakemake)"
fi

if /usr/bin/python3 -W ignore -c 'import parsl, h5py' 2>/dev/null; then
    tried=1
    begin parsl
    work() { PYTHONPATH=$source/src/report:${PYTHONPATH:-} PYTHONDONTWRITEBYTECODE=1 OVERTURN=$program /usr/bin/python3 -W ignore \
                 "$source/slurm/workflows/parsl_campaigns.py" a.toml b.toml >said 2>&1; }
    work || fail "Parsl: $(tail -5 said)"
    expect_waves a.h5 3 && expect_waves b.h5 2
    grep -q '^a.toml .*body=type-b' said || fail "Parsl: no answer: $(cat said)"
    sed -i 's/count = 3/count = 5/' a.toml
    work || fail "Parsl: $(tail -5 said)"
    expect_waves a.h5 5
    sed -i 's/pga/pag/' a.toml
    work && fail "Parsl: takes a campaign with a mistake"
    grep -q "'pag'" said || fail "Parsl: does not say what is wrong: $(tail -3 said)"
else
    echo "workflows: no Parsl here (its tasks call the Python package; pip install parsl)"
fi
[ $tried -eq 1 ] || exit 77
echo "workflows: hold"
