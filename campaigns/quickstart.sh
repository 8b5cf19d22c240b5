#!/bin/bash
# From a fresh Debian 12 machine to a first fragility curve: installs what is missing, builds, and runs
# campaigns/quickstart.toml on all cores. Question, sources and cost of the study stand in that file.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

.cmake/setup.sh
cmake --preset release
CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)} cmake --build --preset release --target overturn

overturn=.build/release/src/overturn
result=.build/quickstart.h5
rm -rf "$result" "$result.parts" "${result%.h5}.runtime.json"
# One machine: more ranks than cores are no error, no rank is bound to a core, messages go through shared memory.
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 \
    OMPI_MCA_hwloc_base_binding_policy=none OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader \
    mpirun -n "$(nproc)" "$overturn" run campaigns/quickstart.toml -o "$result"

cat <<END

The folder:    $PWD
The result:    $result (statistics, every trial, the campaign itself)
How it ran:    ${result%.h5}.runtime.json
Try next, in that folder:
  $overturn fit $result
  $overturn report $result -o .build/quickstart.html      # needs python3-matplotlib and python3-h5py
  $overturn replay $result --trial 118 --history .build/trial.csv
  $overturn wave campaigns/quickstart.toml --wave 7 -o .build/wave.csv
END
