#!/usr/bin/env python3
"""Lists what a person may shorten in the pages: sentences of more than 25 words, headings that begin with What, Of or That.

.ci/sentences.py [PAGE...]; default: all pages of the project but the changelog. Never fails: a person decides."""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST = 25


def pages():
    names = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, text=True, capture_output=True, check=True).stdout.split()
    return [ROOT / name for name in names if not name.endswith(("CHANGELOG.md", "KEYS.md", "COLUMNS.md"))]


def sentences(text):
    """Of paragraphs and lists; code, tables, headings, quotations and displayed formulas have none. A formula or code is one word."""
    text = re.sub(r"^```.*?^```$|^\$\$.*?\$\$$|^( {4}|\||#|>|\*`|!\[).*?$", "", text, flags=re.M | re.S)
    text = re.sub(r"(?<!\$)\$[^$]+\$|`[^`]+`", lambda part: re.sub(r"\s+", "_", part[0]), text)
    for paragraph in re.split(r"\n\s*\n|\n\s*(?:[-*]|\d+\.) ", text):
        yield from re.split(r"(?<=[.!?])\s+(?=[A-Z`$*\[])", " ".join(paragraph.split()))


for page in [pathlib.Path(name).resolve() for name in sys.argv[1:]] or pages():
    text = page.read_text(encoding="utf-8")
    for heading in re.findall(r"^#+ (?:What|Of|That)\b.*$", text, re.M):
        print(f"{page.relative_to(ROOT)}: {heading}")
    for sentence in sentences(text):
        if len(sentence.split()) > MOST:
            print(f"{page.relative_to(ROOT)}: {len(sentence.split())} words: {sentence}")
