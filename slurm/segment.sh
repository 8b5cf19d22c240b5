# One segment of a campaign: as much of it as this job's time allows. Sourced by the batch scripts here.
# shellcheck shell=bash

# What the site says, from beside this file: copy site.env.example to site.env.
[ ! -e "$slurm/site.env" ] || . "$slurm/site.env"
# The program: what is stated, else beside an installation's scripts, else in PATH, else where quickstart builds it.
if [ -z "${OVERTURN:-}" ]; then
    for candidate in "$slurm/../../../bin/overturn" "$(command -v overturn)" "$slurm/../.build/release/src/overturn"; do
        [ -x "$candidate" ] || continue
        OVERTURN=$(cd "$(dirname "$candidate")" && pwd)/overturn
        break
    done
    if [ -z "${OVERTURN:-}" ]; then
        echo "segment: no overturn in PATH, nor built in $(dirname "$slurm")/.build/release. Set OVERTURN in $slurm/site.env" >&2
        return 2
    fi
fi
: "${OVERTURN_LAUNCH:=mpirun}" "${OVERTURN_MOST_SEGMENTS:=100}"

# planned CAMPAIGN [options of overturn run]: is it a campaign? Said here at once, not by every task after its wait.
planned() {
    local campaign=$1 sets=()
    shift
    if ! command -v "$OVERTURN" >/dev/null; then
        return 0  # in a container that only the jobs enter: there it is said
    fi
    while [ $# -gt 0 ]; do
        case $1 in
            --set) while [ $# -gt 1 ] && [[ $2 == *=* && $2 != -* ]]; do sets+=(--set "$2"); shift; done ;;
            --set=*) sets+=("$1") ;;
        esac
        shift
    done
    "$OVERTURN" plan "$campaign" "${sets[@]}" >/dev/null
}

# Launchers lose or die of what reaches them in their first seconds; five minutes' warning has room for waiting.
tell() {
    [ -n "$pid" ] || return 0  # not begun yet: told as soon as it is
    [ "$1" = USR2 ] || while [ $((SECONDS - begun)) -lt 3 ]; do sleep 1; done
    kill "-$1" "$pid" 2>/dev/null
}

# segment ARGUMENTS OF run... : 0 the work is complete, 3 it can go on, else what run returned. It is put back into the queue,
# but not after a TERM: who preempts does that, and who cancels does not want it.
segment() {
    local pid='' code told='' begun=$SECONDS
    trap 'told=USR1; tell USR1' USR1  # from --signal: finish the blocks in hand
    trap 'told=USR2; tell USR2' TERM  # preempted: leave within a second (mpirun hands TERM on too, but ends with 1 then)
    $OVERTURN_LAUNCH "$OVERTURN" run "$@" --resume & pid=$!
    [ -z "$told" ] || tell "$told"
    wait $pid; code=$?
    while kill -0 $pid 2>/dev/null; do  # a trapped signal ends wait, not the run
        wait $pid; code=$?
    done
    trap - USR1 TERM
    # What is told while the launcher itself starts can kill it: nothing is lost, so the next segment goes on.
    [ -z "$told" ] || [ $code -le 128 ] || code=3
    [ $code -eq 3 ] && [ "$told" != USR2 ] || return $code
    if [ "${SLURM_RESTART_COUNT:-0}" -ge "$OVERTURN_MOST_SEGMENTS" ]; then
        echo "segment: still not complete after $OVERTURN_MOST_SEGMENTS segments (is the time limit shorter than a block?). Raise it" >&2
        return 3
    fi
    scontrol requeue "$SLURM_JOB_ID"
    return $code
}
