#!/bin/bash
# Requirement R-1407: the manual is built without a warning, every link of it leads somewhere, its formulas are drawn, its reference is
# that of the program, and it needs no network.
# manual_test.sh PROGRAM SOURCE
set -euo pipefail
program=$1 source=$2
fail() { echo "manual: $1" >&2; exit 1; }
[ "$(wc -l < "$source/README.md")" -le 110 ] || fail "README.md has more than 110 lines: what a newcomer does not need belongs to the guide"
command -v sphinx-build >/dev/null && /usr/bin/python3 -c 'import furo, myst_parser' 2>/dev/null \
    || { echo "manual: no Sphinx here (apt-get install python3-sphinx furo python3-myst-parser libjs-mathjax): skipped"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
bash "$source/.cmake/manual/build.sh" "$program" "$source" "$scratch/manual" -n -W --keep-going > "$scratch/log" 2>&1 || fail "$(tail -20 "$scratch/log")"
for page in index.html README.html search.html searchindex.js campaigns/guide/rare-events.html campaigns/KEYS.html; do
    [ -s "$scratch/manual/$page" ] || fail "no $page"
done
! grep -rlE '(src|href)="https?://[^"]*[.](js|css|woff2?)"' --include='*.html' "$scratch/manual" || fail "a page wants the network"
# The reference has what the program has: each verb with its options, each measure, each assumption; the contents lead to each of its pages.
reference=$scratch/manual/reference
has() { grep -qF "$2" "$reference/$1.html" || fail "reference/$1: no $3"; }
for page in verbs measures names assumptions; do
    grep -q "href=\"reference/$page.html\"" "$scratch/manual/README.html" || fail "nothing leads to reference/$page"
done
verbs=$("$program" --help | awk '/^Subcommands:/ { on = 1; next } on && NF { print $1 }')
[ "$(wc -w <<< "$verbs")" -ge 10 ] || fail "$program names no verbs"
for verb in $verbs; do
    has verbs "<section id=\"$verb\">" "verb $verb"
    options=$("$program" "$verb" --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+')
    section=$(sed -n "/<section id=\"$verb\">/,/<\/section>/p" "$reference/verbs.html" | sed 's/<[^>]*>//g')
    for option in $options; do grep -qF -- "$option" <<< "$section" || fail "reference/verbs: $verb has no $option"; done
done
! grep -qE "[–“”]" "$reference/verbs.html" || fail "reference/verbs: quotes or dashes are not those that a user types"
entries() { "$program" list "$@" | grep -oE '^  [^ ]+' | tr -d ' '; }
listed=$(entries measures; entries limits)
[ "$(wc -w <<< "$listed")" -ge 30 ] || fail "$program lists no measures"
for name in $listed; do has measures "<span class=\"pre\">$name</span>" "measure $name"; done
for name in $(for list in sources targets damping-rules envelopes acceptance formats effects verdicts; do entries $list; done); do
    has names "<span class=\"pre\">$name</span>" "name $name"
done
assumed=$("$program" list assumptions --json | grep -oE '"name": "[^"]+"' | cut -d'"' -f4)
[ "$(wc -w <<< "$assumed")" -ge 10 ] || fail "$program lists no assumptions"
for name in $assumed; do has assumptions "<section id=\"$name\">" "assumption $name"; done
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
