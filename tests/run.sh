#!/bin/bash
# Builds and tests everything, from a fresh Debian 12 machine on: tests/run.sh [arguments for ctest]
# e.g. tests/run.sh -L mpi, tests/run.sh -R store
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

.cmake/setup.sh tests
cmake --preset dev
CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)} cmake --build --preset dev
ctest --preset dev "$@"
