#!/bin/bash
# Requirement R-1401: measured motions that overturned real blocks, or did not, are told apart: better than by a
# threshold on PGV, by bodies that other motions chose; V_WES with R in centimetres orders the outcomes better than PGA.
# granite_test.sh OVERTURN (exit 77, skipped, where the data are missing: they are not part of this project)
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
/usr/bin/python3 -c 'import h5py, numpy' 2> /dev/null || { echo "granite: no h5py and numpy to judge with"; exit 77; }
exec /usr/bin/python3 -B "$here/judge.py" "$1" "$here/granite.toml"
