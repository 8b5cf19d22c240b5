#!/bin/bash
# Requirement R-1009: the Python package gives every stored number of a file, old ones too, as numpy, pandas and xarray have
# it, with units and names; refuses what is not as it was written; runs the program and raises its errors.
# package_test.sh PROGRAM SOURCE_TREE
set -euo pipefail
program=$1 here=$2/tests/package
/usr/bin/python3 -c 'import h5py, pandas, xarray' 2>/dev/null || { echo "skipped: python3-h5py, python3-pandas or python3-xarray is missing"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
for format in 3 4 5; do gunzip -c "$2/tests/golden/results-$format.h5.gz" > "format-$format.h5"; done
cp "$here/campaign.toml" "$here/rare.toml" .
export PYTHONPATH=$2/src/report PYTHONDONTWRITEBYTECODE=1 OVERTURN=$program
"$program" run campaign.toml > run.txt
"$program" run rare.toml > run.txt
/usr/bin/python3 "$here/reading.py"
/usr/bin/python3 "$here/calling.py"

# What src/store/README.md shows, of Python and of Octave (whose own reader leaves names out: h5dump tells them).
lines_of() { awk -v mark="\`\`\`$1" '$0 == mark { on = 1; next } /^```/ { on = 0 } on' "$2/src/store/README.md" | sed 's/FILE.h5/campaign.h5/; s/type-b/flat/'; }
lines_of python "$2" > shown.py
[ -s shown.py ] && /usr/bin/python3 shown.py > shown.txt
grep -q rad shown.txt || { echo "package: the lines of the README print no unit"; exit 1; }
command -v octave-cli >/dev/null || { echo "package: all is well, but for Octave, which is not here"; exit 0; }
lines_of octave "$2" > shown.m
[ -s shown.m ]
cat >> shown.m <<'END'
printf('%d %.17g\n', sum(fell), sum(results.trials.peak_rotation(fell)));
END
/usr/bin/python3 -c "
import overturn
trials = overturn.open('campaign.h5').trials
fell = trials['verdict'].names == 'overturned'
print(fell.sum(), trials['peak_rotation'].values[fell].sum())" > python.txt
octave-cli --quiet shown.m 2>octave.log | tail -1 > octave.txt
/usr/bin/python3 -c "
one, other = (open(name).read().split() for name in ('python.txt', 'octave.txt'))
assert one[0] == other[0] != '0' and abs(float(one[1]) - float(other[1])) < 1e-9, (one, other)"
echo "package: all is well"
