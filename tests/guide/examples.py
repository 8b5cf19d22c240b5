"""Requirement R-1407: every example of the guide runs as it is printed, and prints what the guide says.

examples.py PROGRAM CAMPAIGNS [PAGE...] [--update]

Each page is tried in a copy of CAMPAIGNS of its own. A block of `console` holds commands behind "$ " and what they print; "..."
stands for any text, alone on a line for any lines. A block of `toml` or `csv` whose first line is "# FILE" is written to FILE
first. --update writes what is printed now into the blocks that differ."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^```(console|toml|csv)\n(.*?)^```$", re.M | re.S)


def pattern_of(lines):
    """What is expected, as a regular expression of the whole text."""
    text = ""
    for line in lines:
        if line.strip() == "...":
            text += r"(?:.*\n)*?"
        else:
            text += r"[^\n]*?".join(re.escape(part) for part in line.rstrip().split("...")) + r"[ ]*\n"
    return re.compile(text + r"\Z")


def commands_of(block):
    """Pairs of a command and the lines that it is said to print."""
    pairs = []
    for line in block.splitlines():
        if line.startswith("$ "):
            pairs.append((line[2:], []))
        elif line.startswith("> ") and not pairs[-1][1]:
            pairs[-1] = (pairs[-1][0] + "\n" + line[2:], [])
        else:
            pairs[-1][1].append(line)
    return pairs


def printed_by(command, folder, program):
    places = {"PATH": os.path.dirname(program) + os.pathsep + os.environ["PATH"], "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    ended = subprocess.run(["bash", "-c", command], cwd=folder, env=os.environ | places, text=True, timeout=600,
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return ended.stdout + (ended.stderr if ended.returncode or not ended.stdout else "")


def try_page(page, program, campaigns, update):
    """How many examples of a page differ."""
    text = page.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "campaigns"
        shutil.copytree(campaigns, folder, ignore=shutil.ignore_patterns("*.h5", "*.parts"))
        wrong = 0
        tried = 0

        def checked(found):
            nonlocal wrong, tried
            kind, block = found.groups()
            if kind != "console":
                if name := re.match(r"# (\S+[.](?:toml|csv))\n", block):
                    (folder / name[1]).write_text(block[name.end():], encoding="utf-8")
                return found[0]
            now = ""
            for command, expected in commands_of(block):
                tried += 1
                printed = printed_by(command, folder, program)
                same = pattern_of(expected).match(printed if printed.endswith("\n") or not printed else printed + "\n")
                if not same:
                    wrong += 1
                    print(f"{page}: $ {command}\nexpected\n" + "\n".join(expected) + f"\nprinted\n{printed}", file=sys.stderr)
                lines = expected if same else [line.rstrip() for line in printed.splitlines()]
                now += "\n".join(["$ " + command.replace("\n", "\n> "), *lines]) + "\n"
            return f"```{kind}\n{now}```"

        renewed = BLOCK.sub(checked, text)
    if update:
        page.write_text(renewed, encoding="utf-8")
    print(f"{page.name}: {tried} examples, {wrong} differ")
    return wrong


def main(program, campaigns, *rest):
    campaigns = pathlib.Path(campaigns).resolve()
    pages = [pathlib.Path(name) for name in rest if name != "--update"] or sorted((campaigns / "guide").glob("*.md"))
    if not pages:
        sys.exit("no page")
    sys.exit(min(1, sum(try_page(page, os.path.abspath(program), campaigns, "--update" in rest) for page in pages)))


if __name__ == "__main__":
    main(*sys.argv[1:])
