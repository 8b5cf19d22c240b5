#!/bin/bash
# Requirement R-1203: built with MPICH the program gives the file that it gives with Open MPI, alone and on two ranks.
# mpich_test.sh PROGRAM SOURCE BUILD CAMPAIGNS (BUILD: a tree of its own, kept for the next time)
set -u
program=$1 source=$2 build=$3 campaigns=$4
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "mpich: $1" >&2; exit 1; }
command -v mpicc.mpich >/dev/null && command -v mpiexec.mpich >/dev/null \
    || { echo "mpich: none here (apt-get install libmpich-dev): skipped"; exit 77; }

# Configured as slurm/README.md says. One room alone calls MPI (.cmake/layering.cmake sees to it): that one is compiled, and the
# program is linked as $program was, with it and with MPICH's library in the places of Open MPI's.
cmake -S "$source" -B "$build" -G Ninja -DBUILD_TESTING=OFF -DMPI_C_COMPILER=mpicc.mpich \
      -DMPIEXEC_EXECUTABLE="$(command -v mpiexec.mpich)" >"$scratch/log" 2>&1 || fail "not configured: $(tail -3 "$scratch/log")"
cmake --build "$build" --target overturn_parallel >"$scratch/log" 2>&1 || fail "not built: $(tail -3 "$scratch/log")"
other=$build/overturn-mpich
linked() { ninja -C "$1" -t commands src/overturn | tail -1; }
mpich=$(linked "$build" | grep -o ' [^ ]*/libmpich[^ ]*[.]so' | tr '\n' ' ')
tree=$(dirname "$(dirname "$program")")
line=$(linked "$tree" | sed -E "s| src/liboverturn_parallel[.]a +[^ ]*/libmpi[.]so | $build/src/liboverturn_parallel.a $mpich |; s| -o src/overturn | -o $other |")
(cd "$tree" && eval "$line") >"$scratch/log" 2>&1 || fail "not linked: $(tail -3 "$scratch/log")"
! ldd "$other" | grep -q 'libmpi[.]so' || fail "linked with Open MPI too"
ldd "$other" | grep -q libmpich || fail "not built with MPICH: $(ldd "$other" | grep -i mpi)"
ldd "$program" | grep -q libmpich && fail "the program to compare with is built with MPICH as well"

cp "$here/rigid.toml" "$here/compliant.toml" "$campaigns"/bodies/type_b_model.toml "$scratch"
cd "$scratch" || exit 1
run() {  # NAME CAMPAIGN COMMAND...
    local file=$1 campaign=$2
    shift 2
    "$@" run "$campaign" -o "$file" >"$file.log" 2>&1 || fail "$*: $(tail -1 "$file.log")"
}
for campaign in rigid compliant; do
    run $campaign-open.h5 $campaign.toml "$program"
    run $campaign-one.h5 $campaign.toml "$other"
    run $campaign-two.h5 $campaign.toml mpiexec.mpich -n 2 "$other"
    grep -q '"ranks": 2' $campaign-two.runtime.json || fail "two ranks did not compute together"
    for file in $campaign-one.h5 $campaign-two.h5; do
        cmp $campaign-open.h5 "$file" || fail "$file: other bytes than Open MPI's"
    done
done
echo "mpich: one file alone, on two ranks and with Open MPI"
