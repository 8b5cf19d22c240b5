#!/usr/bin/env python3
"""Writes the manual's reference of verbs, measures, names and assumptions, as the program prints them.

reference.py PROGRAM FOLDER"""

import json
import pathlib
import re
import subprocess
import sys

DIRECTIONS = {"unsafe": "more bodies overturn than computed", "safe": "fewer bodies overturn than computed",
              "unknown": "the direction of the error is not known"}
ENTRY = re.compile(r"  (\S.*)")
# Lists of `overturn list` beside the measures; `limits` are measures of a trial's response.
NAMES = ["sources", "targets", "damping-rules", "envelopes", "acceptance", "formats", "effects", "verdicts"]
MEASURES = ["measures", "limits"]


def printed(*arguments):
    return subprocess.run([PROGRAM, *arguments], text=True, capture_output=True, check=True).stdout


def cell(text):
    """Text as it is, in a table's cell."""
    return re.sub(r"([\\*_|<>\[\]`$])", r"\\\1", text)


def rows(lines, parted_by):
    """(name, text) of lines "  name  text", whose text goes on in lines that are indented deeper."""
    found = []
    for line in lines:
        if entry := ENTRY.fullmatch(line):
            found.append((*re.split(parted_by, entry[1], maxsplit=1), "")[:2])
        elif line.strip() and found:
            found[-1] = (found[-1][0], f"{found[-1][1]} {line.strip()}".strip())
    return found


def table(head, entries):
    lines = [f"| {head} | meaning |", "|---|---|", *("| `" + name.replace("|", "\\|") + f"` | {cell(text)} |" for name, text in entries)]
    return "\n".join(lines) + "\n"


def groups(text):
    """(heading, lines) of lists, whose headings are not indented."""
    for part in re.split(r"\n(?=\S)", text.rstrip()):
        heading, *lines = part.splitlines()
        yield heading, lines


def lists(names):
    return "\n".join(f"## {cell(heading[0].upper() + heading[1:])}\n\n{table('name', rows(lines, ' +'))}"
                     for name in names for heading, lines in groups(printed("list", name)))


def verb_page():
    page = "# Verbs of the program\n\n`overturn VERB --help` prints the same.\n"
    verbs = re.search(r"^Subcommands:\n(.*?)\n\n?\Z", printed("--help") + "\n", re.M | re.S)[1]
    for verb, _ in rows(verbs.splitlines(), "  +"):
        meaning, usage, *rest = printed(verb, "--help").splitlines()
        page += f"\n## {verb}\n\n{cell(meaning[0].upper() + meaning[1:])}.\n\n    {usage.removeprefix('Usage: ')}\n"
        for heading, lines in groups("\n".join(rest).lstrip("\n")):
            page += f"\n{table(heading.rstrip('s:').lower(), rows(lines, '  +'))}"
    return page


def assumption_page():
    page = "# Assumptions of the model\n\n`overturn list assumptions` prints the same. \"Not measured\": no study of this project has measured the effect.\n"
    for one in json.loads(printed("list", "assumptions", "--json")):
        page += f"\n## {one['name']}\n\n{cell(one['assumed'][0].upper() + one['assumed'][1:])}.\n\n"
        page += f"- If this is false, {DIRECTIONS[one['direction']]}.\n- Key that replaces it: {cell(one['key'])}\n"
        page += f"- Effect: {cell(one['effect'])} ({cell(one['evidence'])})\n"
    return page


PROGRAM, folder = sys.argv[1], pathlib.Path(sys.argv[2])
folder.mkdir(parents=True, exist_ok=True)
PAGES = {"verbs": verb_page(), "assumptions": assumption_page(),
         "measures": "# Measures\n\n`overturn list measures` and `overturn list limits` print the same.\n\n" + lists(MEASURES),
         "names": "# Names in a campaign\n\n`overturn list` prints the same.\n\n" + lists(NAMES)}
for name, page in PAGES.items():
    (folder / f"{name}.md").write_text(page, encoding="utf-8")
