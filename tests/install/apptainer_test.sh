#!/bin/bash
# Requirement R-1202: the Apptainer definition builds a container that works; where there is no apptainer its steps are
# checked against this tree instead: the files it copies, the scripts it runs, presets, targets and packages.
# apptainer_test.sh SOURCE_TREE
set -euo pipefail
cd "$1"
definition=slurm/overturn.def
fail() { echo "apptainer: $1" >&2; exit 1; }

section() { awk -v name="%$1" '/^%/ { on = $1 == name; next } on' "$definition"; }

# Every file is there, and every file that configuring reads is copied.
while read -r from to; do
    [ -z "$from" ] || [ -e "$from" ] || fail "copies $from, which is not here"
    [ -z "$from" ] || [ "$to" = /opt/overturn/ ] || fail "copies $from to $to"
done < <(section files)
copied=$(section files | awk '{ print $1 }')
for needed in CMakeLists.txt CMakePresets.json .cmake .github src generators campaigns slurm README.md LICENSE; do
    grep -qx "$needed" <<< "$copied" || fail "does not copy $needed"
done
for part in post runscript test; do section "$part" | bash -n || fail "%$part is no shell script"; done
[ -x .cmake/setup.sh ] && section post | grep -q '^ *\.cmake/setup\.sh$' || fail "%post does not install the build's packages"
for preset in $(section post | grep -oE -- '--preset [a-z]+' | awk '{ print $2 }'); do
    grep -q "\"name\": \"$preset\"" CMakePresets.json || fail "preset $preset is unknown"
done
section test | grep -oE '/usr/local/share/overturn/[a-z_/.]+' | while read -r file; do
    name=${file#/usr/local/share/overturn/}  # the Python package lies beside the sources of the report
    [ -e "${name/#python/src/report}" ] || fail "%test uses $file, which is not installed"
done

# What it copies configures by itself, as %post does it.
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
for file in $copied; do cp -r "$file" "$copy/"; done
configure=$(section post | grep -oE 'cmake --preset release.*')
(cd "$copy" && $configure > configure.log 2>&1) || { tail -5 "$copy/configure.log" >&2; fail "what it copies does not configure"; }

# spack.yaml names something for every library that cmake looks for; "-": one that may be missing, and is not asked of spack.
declare -A spack=([MPI]=openmpi [Eigen3]=eigen [HDF5]=hdf5 [GSL]=gsl [FFTW]=fftw [fmt]=fmt [tomlplusplus]=tomlplusplus [CLI11]=cli11
    [nlohmann_json]=nlohmann-json [OpenSSL]=openssl [RANDOM123]=random123 [HIGHWAY]=highway [GTest]=googletest [MUSL_LIBC]=musl
    [MSEED]=- [XLSX]=-)
for library in $(grep -ohE '^find_package\([A-Za-z0-9_]+|^find_path\([A-Z0-9]+|^find_file\([A-Z_]+' .cmake/packages.cmake .cmake/portable_math.cmake | sed 's/.*(//; s/_INCLUDE_DIR//' | sort -u); do
    name=${spack[$library]:-}
    [ -n "$name" ] || fail "cmake looks for $library, for which this test knows no spack package"
    [ "$name" != - ] || continue
    grep -qE "^  - $name(@|\$| )" slurm/spack.yaml || fail "slurm/spack.yaml lacks $name"
done

runtime=$(command -v apptainer || command -v singularity || true)
if [ -z "$runtime" ]; then
    echo "apptainer: not here, so that nothing was built; the definition's steps fit this tree"
    exit 77  # skipped
fi
image=$(mktemp -d)/overturn.sif
trap 'rm -rf "$copy" "$(dirname "$image")"' EXIT
"$runtime" build "$image" "$definition"  # runs %test too
"$runtime" run "$image" list > /dev/null
echo "apptainer: built and run"
