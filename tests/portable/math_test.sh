#!/bin/bash
# Requirement R-1002: sin, exp, log and all else that glibc may round otherwise on another CPU come from the program
# itself, for our code and for the libraries that it calls.
# math_test.sh PROGRAM
set -euo pipefail
program=$1
fail() { echo "math: $1" >&2; exit 1; }
libm=$(ldd "$program" | awk '$1 ~ /^libm[.]so/ { print $3 }')
[ -n "$libm" ] || fail "$program does not use libm (this test knows no other)"
names() { awk '{ sub(/@.*/, "", $NF); print $NF }' | sort -u; }
of_libm=$(nm -D --defined-only "$libm" | names)
own=$(nm -D --defined-only "$program" | names)

# IEEE 754 fixes these to the last bit, or they move bits about: every libm gives the same.
exact='^(ceil|copysign|fabs|fdim|fe[a-z]*|floor|fma|fmax|fmin|fmod|frexp|ldexp|ll?rint|ll?round|logb|modf|nearbyint|nextafter|rint|round|scalbn|sqrt|trunc)[fl]?$'
checked=0
for file in "$program" $(ldd "$program" | awk '$1 ~ /^lib(gsl|gslcblas|fftw3|hdf5.*|tomlplusplus)[.]so/ { print $3 }'); do
    imports=$(nm -D --undefined-only "$file" | names)
    inexact=$(comm -12 <(echo "$imports") <(echo "$of_libm") | grep -vE "$exact" || true)
    for name in $inexact; do
        case $file:$name in */libhdf5*:powf) continue ;; esac  # of filters that no file of ours uses
        [ "$file" != "$program" ] || fail "$name is taken from $libm. Add it to .cmake/portable_math.cmake"
        grep -qx "$name" <<< "$own" || fail "$file takes $name from $libm. Add it to .cmake/portable_math.cmake"
        checked=$((checked + 1))
    done
done
[ "$checked" -ge 20 ] || fail "only $checked functions of GSL and FFTW were found"  # 2.7.1 and 3.3.10 take 22
grep -qx fftw_have_simd_avx <<< "$own" || fail "FFTW does not ask the program for its instructions"

# What the loader says it bound, not what it ought to.
bound=$(LD_DEBUG=bindings LD_BIND_NOW=1 "$program" --version 2>&1 | grep "binding file .*/lib\(gsl\|fftw3\)[.]so.*\`\(log\|sin\|sincos\|exp\|fftw_have_simd_avx\)'")
[ "$(wc -l <<< "$bound")" -ge 6 ] || fail "the loader says too little: $bound"
! grep -v " to $program " <<< "$bound" || fail "bound elsewhere than to the program"
echo "math: $checked functions of other libraries come from the program"
