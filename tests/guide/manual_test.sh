#!/bin/bash
# Requirement R-1407: the manual is built without a warning, every link of it leads somewhere, and it needs no network.
# manual_test.sh SOURCE
set -euo pipefail
source=$1
fail() { echo "manual: $1" >&2; exit 1; }
command -v sphinx-build >/dev/null && /usr/bin/python3 -c 'import furo, myst_parser' 2>/dev/null \
    || { echo "manual: no Sphinx here (apt-get install python3-sphinx furo python3-myst-parser libjs-mathjax): skipped"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
bash "$source/.cmake/manual/build.sh" "$source" "$scratch/manual" -n -W --keep-going > "$scratch/log" 2>&1 || fail "$(tail -20 "$scratch/log")"
for page in index.html README.html search.html searchindex.js campaigns/guide/rare-events.html campaigns/KEYS.html; do
    [ -s "$scratch/manual/$page" ] || fail "no $page"
done
! grep -rlE '(src|href)="https?://[^"]*[.](js|css|woff2?)"' --include='*.html' "$scratch/manual" || fail "a page wants the network"
echo "manual: $(find "$scratch/manual" -name '*.html' | wc -l) pages"
