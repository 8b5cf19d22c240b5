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

# What is to be the jobs' time limit, as overturn takes it; nothing where sbatch is not told one here. Slurm's "30" are minutes.
limit_of_jobs() {
    local limit=${SBATCH_TIMELIMIT:-}
    case $limit in
        *[!0-9:-]* | -* | '' | 0) ;;
        *[:-]*) echo "$limit" ;;
        *) echo "$limit min" ;;
    esac
}

# planned CAMPAIGN [options of overturn run]: is it a campaign? Said here at once, not by every task after its wait. A limit
# within which no block is done gives a warning.
planned() {
    local campaign=$1 sets=() limit said
    limit=$(limit_of_jobs)
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
    [ -z "$limit" ] || sets+=(--max-walltime "$limit")
    said=$("$OVERTURN" plan "$campaign" "${sets[@]}") || return
    awk '/^[^ ]/ { about_limit = /^warning +within the limit/ } about_limit' <<<"$said" >&2
}

# file_of ARGUMENTS OF run... : the results file, behind links, as run itself finds it.
file_of() {
    local file
    file=$(basename "$1")
    file=${file%.*}.h5
    while [ $# -gt 0 ]; do
        case $1 in
            -o | --output) file=${2:-} ;;
            --output=*) file=${1#*=} ;;
            -o?*) file=${1#-o} ;;
        esac
        shift
    done
    readlink -f -- "$file"
}

# part_of ARGUMENTS OF run... : the part that they ask for, if any.
part_of() {
    local part=''
    while [ $# -gt 0 ]; do
        case $1 in
            --part) part=${2:-} ;;
            --part=*) part=${1#*=} ;;
        esac
        shift
    done
    echo "$part"
}

# done_so_far FILE PART : blocks; of a part, whose blocks lie among those of others, the trials that its legs have noted.
done_so_far() {
    if [ -z "$2" ]; then
        find "$1.parts" -name '*.block' 2>/dev/null | wc -l
    else
        sed -n 's|.*"part":"'"$2"'",.*"trials":\([0-9]*\),"ranks":.*|\1|p' "$1.parts"/*.segment 2>/dev/null |
            awk '{ trials += $1 } END { print trials + 0 }'
    fi
}

# idle_legs FILE PART : how many legs of this job by now, one after the other, committed no block. Between two legs what is
# done and the answer lie in a file beside FILE; another way a job has to remember both is not known to every site.
idle_legs() {
    local kept=$1.legs-$SLURM_JOB_ID before=0 idle=0 now
    now=$(done_so_far "$1" "$2")
    ! [ -s "$kept" ] || read -r before idle _ <"$kept"
    [ "$now" -gt "$before" ] && idle=0 || idle=$((idle + 1))
    echo "$now $idle (done by now, and the last legs of job $SLURM_JOB_ID that added nothing)" >"$kept"
    echo "$idle"
}

# Launchers lose or die of what reaches them in their first seconds; five minutes' warning has room for waiting.
tell() {
    [ -n "$pid" ] || return 0  # not begun yet: told as soon as it is
    [ "$1" = USR2 ] || while [ $((SECONDS - begun)) -lt 3 ]; do sleep 1; done
    kill "-$1" "$pid" 2>/dev/null
}

# segment ARGUMENTS OF run... : 0 the work is complete, 3 it can go on, else what run returned. It is put back into the queue,
# but not after a TERM: who preempts does that, and who cancels does not want it; nor where it does not get any further.
segment() {
    local pid='' code told='' begun=$SECONDS file idle most_idle=3
    file=$(file_of "$@")
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
    if [ $code -ne 3 ] || [ "$told" = USR2 ]; then
        rm -f "$file.legs-$SLURM_JOB_ID"
        return $code
    fi
    idle=$(idle_legs "$file" "$(part_of "$@")")
    if [ "$idle" -ge "$most_idle" ]; then
        rm -f "$file.legs-$SLURM_JOB_ID"
        echo "segment: $idle legs in a row ended without a new block, so this job would go round for ever: it is not put back into" \
            "the queue. A time limit must be longer than a block takes, and than merging once all blocks are there" \
            "(overturn plan $1 --max-walltime LIMIT). Blocks are kept: raise the limit (sbatch -t) and submit again" >&2
        return 3
    fi
    if [ "${SLURM_RESTART_COUNT:-0}" -ge "$OVERTURN_MOST_SEGMENTS" ]; then
        echo "segment: still not complete after $OVERTURN_MOST_SEGMENTS segments. Submit again, with a longer limit or OVERTURN_MOST_SEGMENTS" >&2
        return 3
    fi
    scontrol requeue "$SLURM_JOB_ID"
    return $code
}
