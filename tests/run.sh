#!/bin/bash
# Builds and tests everything, from a fresh Debian 12 machine on: tests/run.sh [--all | arguments for ctest]
# Alone it leaves out the tests that take long (label "long": emulated CPUs, Slurm, kills, full disks, pages in a browser,
# studies), which --all runs too, as .ci/run does. With arguments ctest chooses: tests/run.sh -L mpi, tests/run.sh -R store
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

chosen=("$@")
case ${1-} in
    "") chosen=(-LE long) ;;
    --all) chosen=("${@:2}") ;;
esac

.cmake/setup.sh tests
cmake --preset dev
CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)} cmake --build --preset dev
# One more than cores: some tests wait for a clock.
export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(($(nproc) + 1))}
ended=0
ctest --preset dev -j "$CTEST_PARALLEL_LEVEL" --output-junit results.xml "${chosen[@]}" || ended=$?
# Which requirement is shown by which test, and how it ended.
python3 tests/traceability.py --results .build/dev/results.xml > .build/dev/traceability.md
if [ $# -eq 0 ]; then
    left=$(ctest --preset dev -N -L long | sed -n 's/^Total Tests: //p')
    echo "$left tests that take long were left out: bash tests/run.sh --all"
fi
exit $ended
