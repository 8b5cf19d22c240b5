#!/bin/bash
# Requirement R-915, R-905: figures and pages are drawn by the program's own package, whatever PYTHONPATH, PYTHONHOME, working
# folder and settings surround it; where the package is missing one line says what to do.
# isolation_test.sh PROGRAM SOURCE_TREE
set -euo pipefail
program=$1
/usr/bin/python3 -c 'import matplotlib, h5py' 2>/dev/null || { echo "skipped: python3-matplotlib or python3-h5py is missing"; exit 77; }
fail() { echo "isolation: $1" >&2; exit 1; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
awk '/^\[\[limits/ { exit } /^\[\[bodies/ { n++ } /^\[levels/ { n = 0 } n < 2' "$2/tests/package/campaign.toml" > c.toml  # one body
"$program" run c.toml --set waves.count=2 -o c.h5 > run.txt
rm c.runtime.json  # times are no part of the page
rock=(rock --body body.toml --wave wave.csv --unit m/s2 --plot)
printf 'mass = "12.6 t"\nbase_width = "0.9 m"\ncentre_height = "1.045 m"\ninertia = "uniform-block"\n' > body.toml
"$program" wave c.toml --wave 0 -o wave.csv > said.txt 2>&1
"$program" report c.h5 -o clean.html 2> said.txt
"$program" "${rock[@]}" clean.svg > said.txt

# Modules of every name that is imported on the way, each of which would end the script or speak.
mkdir hostile
for module in json matplotlib numpy h5py overturn style csv textwrap sitecustomize usercustomize; do
    echo "raise SystemExit('hijacked by $module')" > "hostile/$module.py"
done
cp hostile/*.py .
printf 'backend: nonsense\nfont.size: 40\n' > matplotlibrc
hostile() { env PYTHONPATH="$scratch/hostile" "$@"; }
! hostile /usr/bin/python3 -c 'import json' 2> hijacked.txt || fail "the hostile folder hijacks nothing: nothing is at stake"
for environment in "PYTHONPATH=$scratch/hostile" "PYTHONHOME=/nowhere" "PYTHONSTARTUP=$scratch/json.py PYTHONUSERBASE=$scratch/hostile" \
                   "MPLBACKEND=nonsense MATPLOTLIBRC=$scratch/matplotlibrc" "PYTHONPATH=$scratch/hostile PYTHONHOME=/nowhere PYTHONSAFEPATH="; do
    read -ra settings <<< "$environment"
    env "${settings[@]}" "$program" "${rock[@]}" hostile.svg > said.txt 2>&1 || fail "$environment: $(cat said.txt)"
    cmp clean.svg hostile.svg || fail "$environment: another figure"
done
env PYTHONPATH="$scratch/hostile" PYTHONHOME=/nowhere "$program" report c.h5 -o hostile.html 2> said.txt || fail "the page: $(cat said.txt)"
cmp clean.html hostile.html || fail "the page: another one"

# A program that was copied without its package.
mkdir -p alone/bin
cp "$program" alone/bin/overturn
code=0
alone/bin/overturn report c.h5 -o alone.html 2> said.txt || code=$?
[ "$code" -eq 1 ] && [ "$(wc -l < said.txt)" -eq 1 ] || fail "without its package: ended with $code, $(cat said.txt)"
grep -q "alone/share/overturn/python: no Python package overturn there .*cmake --install" said.txt || fail "without its package: $(cat said.txt)"
[ ! -e alone.html ] || fail "a page without the package"

# Moved as a whole it draws the same.
mkdir -p alone/share/overturn/python
cp -r "$2/src/report/overturn" alone/share/overturn/python/
mv alone elsewhere
elsewhere/bin/overturn "${rock[@]}" moved.svg > said.txt 2>&1 || fail "moved: $(cat said.txt)"
cmp clean.svg moved.svg || fail "moved: another figure"
[ -z "$(find elsewhere "$2/src/report/overturn" -newer clean.html -name '*.pyc')" ] || fail "drawing writes beside the package"
echo "isolation: all is well"
