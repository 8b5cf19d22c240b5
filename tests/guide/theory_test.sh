#!/bin/bash
# Requirement R-1408: the pages of the theory have their formulas, and name functions, files and sources that the code has.
# theory_test.sh SOURCE
exec /usr/bin/python3 -B "$(dirname "$0")/theory.py" "$1"
