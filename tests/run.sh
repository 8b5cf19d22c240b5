#!/bin/bash
# Builds and tests everything, from a fresh Debian 12 machine on: tests/run.sh [arguments for ctest]
# e.g. tests/run.sh -L mpi, tests/run.sh -R store
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

.cmake/setup.sh tests
cmake --preset dev
CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)} cmake --build --preset dev
ended=0
ctest --preset dev --output-junit results.xml "$@" || ended=$?
# Which requirement is shown by which test, and how it ended.
python3 tests/traceability.py --results .build/dev/results.xml > .build/dev/traceability.md
exit $ended
