#!/bin/bash
# Lays every table and figure of the paper (PATRAM 2013) beside what this program finds: reproduced, different and why, or
# not to be known. Runs the campaigns it takes, draws their figures and writes one page, OUT/paper.html.
#
#   bash campaigns/paper.sh [--out FOLDER] [--records FOLDER] [--quick]
#
# --out: where results and page go (default: paper, in the folder you are in); results that are complete there, and of the
# same program, campaign, waves and records (NAME.asked), are taken as they are. --records: recorded waves, laid out as campaigns/records_one_axis.toml says; without it that part is left out
# and said. --quick: few waves, to see that it works; its numbers mean nothing.
# What remains there, some 40 MB (quick 9): the page and its data (paper.html, paper.json), the figures, steady.csv, and of
# each study the results, the fits and what was printed.
# The program is OVERTURN, else the one in PATH, else where quickstart.sh builds it; ranks are OVERTURN_RANKS, else one per
# core. Takes 6 min of CPU time.
set -euo pipefail
campaigns=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
out=paper records=${OVERTURN_RECORDS:-} quick=
while [ $# -gt 0 ]; do
    case $1 in
        --out) out=${2:?--out needs a folder}; shift 2 ;;
        --records) records=${2:?--records needs a folder}; shift 2 ;;
        --quick) quick=1; shift ;;
        *) echo "paper: '$1' (unknown). Use --out FOLDER, --records FOLDER, --quick" >&2; exit 2 ;;
    esac
done
[ -z "$records" ] || [ -d "$records" ] || { echo "paper: --records $records (no such folder). Name that of your records" >&2; exit 2; }

overturn=${OVERTURN:-$(command -v overturn || echo "$campaigns/../.build/release/src/overturn")}
[ -x "$overturn" ] || { echo "paper: no overturn at $overturn. Build it (campaigns/quickstart.sh), or set OVERTURN" >&2; exit 2; }
python=${OVERTURN_PYTHON:-/usr/bin/python3}
[ -x "$python" ] || python=python3

# One machine: more ranks than cores are no error, no rank is bound to a core, messages go through shared memory.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader
ranks=${OVERTURN_RANKS:-$(nproc)}
launch=()
[ "$ranks" = 1 ] || ! command -v mpirun > /dev/null || launch=(mpirun -n "$ranks")

mkdir -p "$out"

# All that a study's numbers hang on, as one number.
asked() {
    { "$overturn" --version; printf '%s\n' "$@"; cat "$campaigns/$1.toml" "$campaigns"/bodies/*.toml
      [ "$1" != records_one_axis ] || find "$records" -type f -print0 | sort -z | xargs -0 cat; } | sha256sum
}
# study NAME CAMPAIGN WAVES [--set key=value ...]: OUT/NAME.h5, unless it is there, complete and what is asked.
study() {
    local name=$1 campaign=$2 waves=$3 same
    shift 3
    [ -z "$quick" ] || [ "$waves" = all ] || set -- "$@" --set "waves.count=$waves"
    same=$(asked "$campaign" "$@")
    [ "$(cat "$out/$name.asked" 2> /dev/null)" = "$same" ] && "$overturn" status "$out/$name.h5" > /dev/null 2>&1 && return
    rm -rf "$out/$name.h5" "$out/$name.h5.parts" "$out/$name.runtime.json" "$out/$name.asked"
    echo "paper: $name"
    "${launch[@]}" "$overturn" run "$campaigns/$campaign.toml" -o "$out/$name.h5" "$@" > "$out/$name.txt" 2> "$out/$name.said" ||
        { cat "$out/$name.said" >&2; exit 1; }
    echo "$same" > "$out/$name.asked"
}
# Beside every study: its fits as JSON.
fit() { "$overturn" fit "$out/$1.h5" --json > "$out/$1.json"; }

study prototype similarity_prototype 4
study model similarity_model 4
study vertical_mode vertical_mode 2
study one_axis one_axis_types_a_b 3
study published one_axis_types_a_b 6 --set 'levels.values=["892 gal", "1406 gal"]'
study horizontal_vertical horizontal_vertical 3
study sinusoids harmonic_type_a all
study sinusoids_linear harmonic_type_a all --set accuracy.restoring=linear
study axes multi_axis 1
study space criterion_in_space 1
for name in one_axis published horizontal_vertical sinusoids axes space; do fit "$name"; done

# Figures 7 and 8: V_E at 10 % of all waves in one picture, in kine.
few=100
[ -z "$quick" ] || few=3
"$overturn" spectra "$campaigns/one_axis_types_a_b.toml" --waves $few --velocities kine --plot "$out/figure_7.svg" --json > "$out/figure_7.json"
rm -f "$out"/figure_8.*
if [ -n "$records" ]; then
    study records records_one_axis all --set "waves.folder=$(cd "$records" && pwd)"
    fit records
    "$overturn" spectra "$campaigns/records_one_axis.toml" --set "waves.folder=$(cd "$records" && pwd)" --velocities kine \
        --plot "$out/figure_8.svg" --json > "$out/figure_8.json"
fi

# Figure 10: of the histories of its sinusoids, up to 230 MB each, only the largest rotation of the last steady 20 s is kept
# (campaigns/harmonic_type_a.toml: 120 s, of which the last 20 fade), which the page compares with Eq. 1; also with its
# linearised equation.
history=$out/history.csv
trap 'rm -f "$history"' EXIT
largest='NR == 1 { for (i = 1; i <= NF; i++) if ($i == "rotation_rad" || $i == "tilt_rad") angle = i; next }
    $1 > 80 && $1 < 100 { a = $angle < 0 ? -$angle : $angle; if (most == "" || a > most) most = a }
    END { printf "%.17g", most == "" ? "nan" : most }'
echo study,wave,rotation_rad > "$out/steady.csv"
for wave in $(seq 0 9); do
    for name in sinusoids sinusoids_linear; do
        "$overturn" replay "$out/$name.h5" --trial $((2 * wave + 1)) --history "$history" > /dev/null
        echo "$name,$wave,$(awk -F, "$largest" "$history")" >> "$out/steady.csv"
    done
done

# Figure 11: V_WES(t) and V_resp(t) of A at 1406 gal and of B at 892 gal, and of both on a round rim, under the waves that
# the page chooses.
"$python" -B "$campaigns/paper_page.py" "$out" --choose | while read -r name study trial; do
    "$overturn" replay "$out/$study.h5" --trial "$trial" --velocities kine --plot "$out/$name.svg" > /dev/null
done

"$python" -B "$campaigns/paper_page.py" "$out" --program "$("$overturn" --version | head -1)" ${quick:+--quick}
echo "paper: $out/paper.html"
