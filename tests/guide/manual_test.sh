#!/bin/bash
# Requirement R-1407: the manual is built without a warning, every link of it leads somewhere, its formulas are drawn, and it needs no
# network.
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
# As many formulas on a page of the theory as its text has, and none that MathJax cannot read.
if command -v chromium >/dev/null; then
    for page in src/{rocking,contact,spectra,rare,stats} generators; do
        timeout 120 chromium --headless --no-sandbox --disable-gpu --allow-file-access-from-files --virtual-time-budget=20000 --dump-dom \
            "file://$scratch/manual/$page/README.html" > "$scratch/page" 2>/dev/null || fail "chromium cannot read $page"
        written=$(grep -c 'class="math notranslate' "$scratch/manual/$page/README.html") || true
        drawn=$(grep -oE 'id="MathJax-Element-[0-9]+-Frame"' "$scratch/page" | wc -l)
        [ "$written" -gt 0 ] && [ "$drawn" -ge "$written" ] || fail "$page: $drawn formulas drawn of $written"
        ! grep -qE '<merror>|<[a-z]+ mathcolor="red"' "$scratch/page" || fail "$page: a formula that MathJax cannot read"
    done
else
    echo "manual: no chromium here: formulas were not drawn"
fi
echo "manual: $(find "$scratch/manual" -name '*.html' | wc -l) pages"
