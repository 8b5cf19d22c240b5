#!/bin/bash
# Builds the manual as pages that need no network: build.sh SOURCE FOLDER [options of sphinx-build]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source=$1 folder=$2
command -v sphinx-build >/dev/null || { echo "manual: no Sphinx here. Run apt-get install python3-sphinx furo python3-myst-parser libjs-mathjax" >&2; exit 1; }
sphinx-build -q -b html -c "$here" -d "$folder.state" "${@:3}" "$source" "$folder"
rm -rf "$folder.state"
printf '<meta http-equiv="refresh" content="0; url=README.html">\n' > "$folder/index.html"
# Of MathJax what its one setting here loads.
mathjax=/usr/share/javascript/mathjax
for part in MathJax.js config/TeX-AMS_CHTML.js jax/element jax/input/TeX jax/output/CommonHTML extensions/TeX fonts/HTML-CSS/TeX/woff; do
    [ -e $mathjax/$part ] || continue
    mkdir -p "$folder/_static/mathjax/$(dirname $part)"
    cp -rL $mathjax/$part "$folder/_static/mathjax/$(dirname $part)"
done
echo "manual: $folder/index.html"
