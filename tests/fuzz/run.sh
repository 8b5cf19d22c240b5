#!/bin/bash
# Fuzzes every reader for some seconds, one after the other, and says how it went: tests/fuzz/run.sh [SECONDS [READER ...]]
# Needs clang with its libFuzzer (apt-get install clang). Findings lie in .build/fuzz/found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
seconds=${1:-600}
readers=("${@:2}")
[ ${#readers[@]} -gt 0 ] || readers=(toml record tables results)

command -v clang++ >/dev/null || { echo "no clang++ here (apt-get install clang)"; exit 77; }
CXX=clang++ CC=clang cmake -S . -B .build/fuzz -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DOVERTURN_FUZZ=ON \
    -DOVERTURN_CHECKED=ON -DBUILD_TESTING=OFF >/dev/null
cmake --build .build/fuzz --target "${readers[@]/#/fuzz.}"
program=$(ls .build/{release,dev}/src/overturn 2>/dev/null | head -1 || true)
[ -n "$program" ] || { echo "build the program first (tests/run.sh or campaigns/quickstart.sh)"; exit 77; }
mkdir -p .build/fuzz/found

# A results file is bytes of HDF5: the corpus is what the program writes now.
small='seed=1
waves={source="harmonic",amplitude="1 m/s2",frequencies=[1],duration="4 s",time_step="0.02 s",ramp="1 s"}
bodies=[{name="b",mass="1 t",base_width="1 m",centre_height="2 m",inertia="uniform-block"}]
levels={measure="factor",values=[1,9]}'
rm -rf .build/fuzz/seeds
mkdir -p .build/fuzz/seeds/{toml,record,tables,results}
cp tests/fuzz/corpus/toml/* .build/fuzz/seeds/toml
cp tests/fuzz/corpus/record/* .build/fuzz/seeds/record
cp tests/fuzz/corpus/tables/* .build/fuzz/seeds/tables
echo "$small" >.build/fuzz/seeds/toml/small
"$program" run .build/fuzz/seeds/toml/small -o .build/fuzz/seeds/results/small.h5 >/dev/null 2>&1 ||
    { echo "no results file to begin with"; exit 1; }

for reader in "${readers[@]}"; do
    mkdir -p ".build/fuzz/corpus/$reader"
    log=.build/fuzz/$reader.log
    dictionary=()
    [ -f "tests/fuzz/$reader.dict" ] && dictionary=(-dict="tests/fuzz/$reader.dict")
    # HDF5 asks for absurd sizes when a file does, and takes no for an answer.
    ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 nice ".build/fuzz/tests/fuzz/fuzz.$reader" -max_total_time="$seconds" \
        -timeout=20 -rss_limit_mb=6000 -malloc_limit_mb=1000000 -max_len=1000000 -print_final_stats=1 "${dictionary[@]}" -artifact_prefix=".build/fuzz/found/$reader-" \
        ".build/fuzz/corpus/$reader" ".build/fuzz/seeds/$reader" >"$log" 2>&1 && end=clean || end="A FINDING (see $log)"
    runs=$(grep -a 'stat::number_of_executed_units' "$log" | tr -dc '0-9' || true)
    edges=$(grep -ao 'cov: [0-9]*' "$log" | tail -1 || true)
    echo "$reader: $seconds s, ${runs:-?} inputs, ${edges:-no coverage}, $end"
done
