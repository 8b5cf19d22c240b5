"""The manual: pages stay beside what they describe; this gathers them, and the reference of the program itself (target
overturn_manual)."""

import pathlib
import re

from pygments.lexers.special import TextLexer
from sphinx.util import logging

project = "overturn"
author = "the overturn authors"
extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
root_doc = "README"
include_patterns = ["README.md", "campaigns/README.md", "campaigns/KEYS.md", "campaigns/guide/*.md", "slurm/README.md", "generators/README.md", "src/README.md",
                    "src/*/README.md", "src/store/COLUMNS.md", "tests/README.md", "tests/requirements.md", "tests/*/README.md",
                    "tests/validation/experiments/README.md", ".github/*.md", "reference/*.md"]
html_theme = "furo"
html_title = "overturn"
html_show_sphinx = False
smartquotes = False  # it would make one dash of the two of an option
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"  # a copy of the machine's own: no network
myst_update_mathjax = False  # it is for version 3; Debian's is 2.7
mathjax2_config = {"tex2jax": {"inlineMath": [["\\(", "\\)"]], "processClass": "math"}}
suppress_warnings = ["myst.header"]

CONTENTS = {
    "Guide": ["campaigns/guide/README"] + [f"campaigns/guide/{page}" for page in (
        "my-cask", "supports", "my-spectrum", "my-records", "spectra-that-vary", "slip-and-clearance", "limit-states",
        "rare-events", "annual-frequency", "uncertain-bodies", "cluster", "results-file", "checking", "assumptions")],
    "Studies and clusters": ["campaigns/README", "slurm/README"],
    "Reference": ["reference/verbs", "campaigns/KEYS", "reference/names", "reference/measures", "src/store/COLUMNS",
                  "reference/assumptions", "src/report/README", "src/store/README", ".github/CHANGELOG"],
    "Theory": ["src/rocking/README", "src/contact/README", "src/spectra/README", "generators/README", "src/rare/README",
               "src/stats/README"],
    "Code and tests": ["src/README", "src/motion/README", "tests/README", "tests/requirements", "tests/relations/README",
                       "tests/validation/experiments/README", "tests/benchmarks/README", "tests/scale/README",
                       "tests/mutants/README", ".github/CONTRIBUTING", ".github/THIRD_PARTY"],
}


ELSEWHERE = re.compile(r"\[([^\]]*)\]\((?!https?:|#)([^)#]*)(?<![.]md)(?<![.]svg)\)")


def gathered(app, docname, source):
    """Gives the front page its contents, and links to files that are no pages the form of a file's name."""
    text = source[0]
    beside = pathlib.Path(app.srcdir, docname).parent
    for _, target in ELSEWHERE.findall(text):
        if not (beside / target).exists():
            logging.getLogger(__name__).warning("no such file: %s", target, location=docname)
    if docname == root_doc:
        for caption, pages in CONTENTS.items():
            listed = "\n".join(f"/{page}" for page in pages)
            text += f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{listed}\n```\n"
    source[0] = ELSEWHERE.sub(r"`\1`", text)


def setup(app):
    app.add_lexer("csv", TextLexer)
    app.connect("source-read", gathered)
