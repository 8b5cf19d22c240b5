#!/bin/bash
# Builds the manual as pages that need no network: build.sh PROGRAM SOURCE FOLDER [options of sphinx-build]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$1 source=$(cd "$2" && pwd) folder=$3
command -v sphinx-build >/dev/null || { echo "manual: no Sphinx here. Run apt-get install python3-sphinx furo python3-myst-parser libjs-mathjax" >&2; exit 1; }
# Its source: the tree, and the reference that the program prints of itself.
pages="$folder.pages"
trap 'rm -rf "$pages" "$folder.state"' EXIT
rm -rf "$pages"
mkdir -p "$pages"
ln -s "$source"/{README.md,.github,campaigns,generators,slurm,src,tests} "$pages"
/usr/bin/python3 -B "$here/reference.py" "$program" "$pages/reference"
sphinx-build -q -b html -c "$here" -d "$folder.state" "${@:4}" "$pages" "$folder"
printf '<meta http-equiv="refresh" content="0; url=README.html">\n' > "$folder/index.html"
# Of MathJax what its one setting here loads.
mathjax=/usr/share/javascript/mathjax
for part in MathJax.js config/TeX-AMS_CHTML.js jax/element jax/input/TeX jax/output/CommonHTML extensions/TeX fonts/HTML-CSS/TeX/woff; do
    [ -e $mathjax/$part ] || continue
    mkdir -p "$folder/_static/mathjax/$(dirname $part)"
    cp -rL $mathjax/$part "$folder/_static/mathjax/$(dirname $part)"
done
echo "manual: $folder/index.html"
