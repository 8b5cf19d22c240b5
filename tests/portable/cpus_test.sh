#!/bin/bash
# Requirement R-1002: one campaign gives one file on every x86-64 CPU: SSE4.2 alone (Nehalem), AVX2 and FMA (Haswell),
# this machine's own, and this machine's without AVX2 and FMA for libm; with planar, sliding, compliant and spatial
# trials, matched and drawn waves, and rare levels by plain trials, subset simulation and pulses.
# cpus_test.sh PROGRAM CAMPAIGNS
set -u
program=$1 campaigns=$2
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "cpus: $1" >&2; exit 1; }
command -v qemu-x86_64 >/dev/null || { echo "cpus: no qemu-x86_64 here (apt-get install qemu-user): skipped"; exit 77; }

cp "$here"/*.toml "$campaigns"/bodies/type_b_model.toml "$scratch"
cd "$scratch" || exit 1
all="rigid compliant rare rare_subset rare_pulses"
run() {  # NAME CAMPAIGNS COMMAND...: the campaigns by the program under COMMAND
    local name=$1 campaigns=$2 campaign
    shift 2
    mkdir "$name"
    for campaign in $campaigns; do
        "$@" "$program" run $campaign.toml -o "$name/$campaign.h5" >>"$name/log" 2>&1 || echo failed >>"$name/log"
    done
}
run native "$all" env
case $(grep -o '"lanes": "[^"]*"' native/rigid.runtime.json) in
    *AVX*) ;;
    *) echo "cpus: this machine has no AVX2, nothing to compare: skipped"; exit 77 ;;
esac
run without-fma "$all" env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA
run Nehalem "$all" qemu-x86_64 -cpu Nehalem &
# An emulated Haswell differs from this machine in its libraries' choices alone: what is dear to emulate is left out.
run Haswell "rigid compliant rare" qemu-x86_64 -cpu Haswell &
wait

! grep -q '"lanes": "AVX' Nehalem/rigid.runtime.json || fail "Nehalem is not emulated: $(grep lanes Nehalem/rigid.runtime.json)"
grep -q '"lanes": "AVX2"' Haswell/rigid.runtime.json || fail "Haswell is not emulated: $(grep lanes Haswell/rigid.runtime.json)"
for cpu in without-fma Nehalem Haswell; do
    for campaign in $all; do
        [ $cpu = Haswell ] && [ ! -e Haswell/$campaign.h5 ] && [ "${campaign#rare_}" != "$campaign" ] && continue
        cmp native/$campaign.h5 $cpu/$campaign.h5 || fail "$campaign.toml on $cpu: other bytes; $(tail -1 $cpu/log)"
    done
done
echo "cpus: one file each on $(grep -o '"lanes": "[^"]*"' native/rigid.runtime.json | cut -d'"' -f4), the same without FMA, Nehalem and Haswell"
