#!/usr/bin/env python3
"""theory.py SOURCE: the pages that the manual lists as theory. A function, file or key that they name is in the code; a source that they cite is
cited in the code or its tests too, which a page may not invent; each has formulas, all of them closed."""

import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
FEWEST_FORMULAS = 20

contents = (ROOT / ".cmake/manual/conf.py").read_text(encoding="utf-8")
pages = [ROOT / f"{name}.md" for name in re.findall(r'"([^"]+)"', re.search(r'"Theory": \[(.*?)\]', contents, re.S)[1])]
files = [path for room in ("src", "generators", "tests", "campaigns") for ext in ("*.?pp", "*.toml", "*.py", "KEYS.md")
         for path in (ROOT / room).rglob(ext) if ".build" not in path.parts]
code = {path: path.read_text(encoding="utf-8", errors="replace") for path in files}
words = set(re.findall(r"[A-Za-z_]\w*", "\n".join(code.values())))
prose = re.sub(r"\s+(///?|#|//)?\s*", " ", "\n".join(text for path, text in code.items() if path.suffix in (".hpp", ".cpp")))
paths = {str(path.relative_to(ROOT)) for path in files} | {str(path.parent.relative_to(ROOT)) for path in files}
faults = []


def named(name):
    """Is it a file, or are all words of it in the code?"""
    if re.fullmatch(r"\w{3,}(/[\w.-]+)+|\S+[.](hpp|cpp|toml|py)", name):
        return any(path.endswith(name) for path in paths)
    return all(word in words for word in re.findall(r"[A-Za-z_]\w*", name))


def cited(author, year):
    """A year near the author's name, in the code or its tests."""
    return re.search(rf"\b{author}\b.{{0,80}}\b{year}\b", prose)


for page in pages:
    if not page.exists():
        faults.append(f"no page {page.relative_to(ROOT)}")
        continue
    text = page.read_text(encoding="utf-8")
    here = page.relative_to(ROOT)
    plain = re.sub(r"```.*?```", "", text, flags=re.S)
    formulas = re.findall(r"\$\$(.+?)\$\$|\$([^$]+)\$", plain, re.S)
    if len(formulas) < FEWEST_FORMULAS:
        faults.append(f"{here}: {len(formulas)} formulas")
    if plain.count("$") % 2:
        faults.append(f"{here}: a formula is not closed")
    for formula in (first or second for first, second in formulas):
        if formula.count("{") - formula.count("\\{") != formula.count("}") - formula.count("\\}"):
            faults.append(f"{here}: braces of {formula}")
        if re.search(r"(?<!\\)\|", formula):
            faults.append(f"{here}: a bar, which ends a table's cell, in {formula}")
    for name in set(re.findall(r"`([^`\n]+)`", re.sub(r"\$[^$]+\$", "", plain))):
        if not named(name):
            faults.append(f"{here}: `{name}` is not in the code")
    for author, year in set(re.findall(r"([A-Z][a-z]{2,})(?: and others)?,? \(?((?:19|20)\d\d)\b", re.sub(r"\s+", " ", plain))):
        if not cited(author, year):
            faults.append(f"{here}: {author} {year} is cited nowhere in the code")

if faults or len(pages) < 6:
    sys.exit("theory: " + "\ntheory: ".join(faults or ["the manual lists too few pages"]))
print(f"theory: {len(pages)} pages")
