#!/bin/bash
# Requirement R-1103: a program of other sources, compiler flags or build type is another one, whose blocks are not mixed
# with this one's. (Compiler, libraries and machine: campaign_input_test.cpp.)
# identity_test.sh BUILD_TREE SOURCE_TREE
set -u
build=$1 source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "identity: $1" >&2; exit 1; }

identity() {  # FLAGS
    cmake -DSOURCE_DIR="$source" -DHEADER="$scratch/header" "-DFLAGS=$1" -P "$source/.cmake/revision.cmake" || fail "not written"
    sed -n 's/.*OVERTURN_SOURCES_SHA256 //p' "$scratch/header"
}
base=$(identity "-O2")
[ -n "$base" ] || fail "no hash"
[ "$(identity "-O2")" = "$base" ] || fail "the same flags make another program"
[ "$(identity "-O2 -mfma")" != "$base" ] || fail "other flags make the same program"

# What the build hands over: flags of its own and those of its type.
value() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }
kind=$(value CMAKE_BUILD_TYPE)
handed=$(ninja -C "$build" -t commands overturn_revision | grep -o -- '-DFLAGS=[^"]*' | tr -d '\\' | sed 's/ -P .*//') || fail "no command"
for flags in "$(value CMAKE_CXX_FLAGS)" "$(value "CMAKE_CXX_FLAGS_${kind^^}")"; do
    [[ "$handed" == *"$flags"* ]] || fail "$flags is not among what identifies the program: $handed"
done
[ -n "$(value "CMAKE_CXX_FLAGS_${kind^^}")" ] || fail "a build of no type"
echo "identity: sources, flags and build type make the program"
