#!/usr/bin/env python3
"""Breaks the program one line at a time, and says which tests notice.

tests/mutants/run.py --check | [--only TEXT] [--from N] [--minutes M] [--list FILE] [--report FILE]

Works in a scratch copy of this tree and of .build/dev (which has to be built), seen at this tree's own path in a mount
namespace of its own (root), so that only what a mutant touches is built again. Every mutant of mutants.txt is applied
alone; the test programs named beside it are built and run, the first that fails kills it."""

import argparse
import collections
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
BUILD = ".build/dev"
Mutant = collections.namedtuple("Mutant", "file old new programs why")


def mutants(place):
    """One block of the list each: file, `- old`, `+ new`, `? test programs [filter]`, and `! why it may survive`."""
    for number, block in enumerate(place.read_text(encoding="utf-8").split("\n\n")):
        lines = [line for line in block.splitlines() if line and not line.startswith("#")]
        if not lines:
            continue
        kinds = {line[0]: line[2:] for line in lines[1:]}
        if not {"-", "+", "?"} <= kinds.keys():
            sys.exit(f"{place.name}: block {number}: {lines[0]} (no '-', '+' or '?' line). Complete it")
        source = (ROOT / lines[0]).read_text(encoding="utf-8")
        if source.count(kinds["-"]) != 1:
            sys.exit(f"{place.name}: {lines[0]}: '{kinds['-']}' (is there {source.count(kinds['-'])} times). Mend it")
        yield Mutant(lines[0], kinds["-"], kinds["+"], kinds["?"].split(), kinds.get("!", ""))


def inside(copy, *command, seconds=600):
    """Runs a command with the copy seen at the tree's own path."""
    enter = f'mount --bind "{copy}" "{ROOT}" && cd "{ROOT}" && exec "$@"'
    try:
        return subprocess.run(["unshare", "-m", "bash", "-c", enter, "in", *command], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=seconds).returncode
    except subprocess.TimeoutExpired:
        return "hangs"


def killer_of(copy, mutant):
    for program in mutant.programs:
        program, _, only = program.partition(":")
        if inside(copy, "nice", "cmake", "--build", BUILD, "--target", program) != 0:
            return "the compiler"
        if inside(copy, "nice", f"{BUILD}/tests/{program}", "--gtest_brief=1", "--gtest_fail_fast",
                  f"--gtest_filter={only or '*'}") != 0:
            return program + (f" ({only})" if only else "")
    return None


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--only", default="", help="mutants of files whose name holds TEXT")
    options.add_argument("--from", dest="first", type=int, default=1, help="begin with the N-th of these")
    options.add_argument("--minutes", type=float, default=1e9, help="begin no further mutant after so long")
    options.add_argument("--check", action="store_true", help="run nothing: is every mutant's text there once?")
    options.add_argument("--list", type=pathlib.Path, default=HERE / "mutants.txt", help="another list than mutants.txt")
    options.add_argument("--report", type=pathlib.Path, help="write the table there too")
    options = options.parse_args()
    chosen = [mutant for mutant in mutants(options.list) if options.only in mutant.file][options.first - 1:]
    if options.check:
        print(f"{len(chosen)} mutants stand where the list says")
        return
    begun = time.monotonic()
    rows = []
    with tempfile.TemporaryDirectory(prefix="overturn-mutants.") as scratch:
        copy = pathlib.Path(scratch) / "tree"
        shutil.copytree(ROOT, copy, symlinks=True, ignore=lambda at, names: {"tidy", "tidy-commands", "asan", "release"}
                        if pathlib.Path(at).name == ".build" else set())
        for mutant in chosen:
            if time.monotonic() - begun > 60 * options.minutes:
                print(f"{len(chosen) - len(rows)} not tried: out of time")
                break
            place = copy / mutant.file
            sound = place.read_text(encoding="utf-8")
            place.write_text(sound.replace(mutant.old, mutant.new), encoding="utf-8")
            killer = killer_of(copy, mutant)
            place.write_text(sound, encoding="utf-8")
            rows.append((mutant, killer))
            print(f"{killer or 'SURVIVES':40} {mutant.file}: {mutant.old.strip()} -> {mutant.new.strip()}", flush=True)
    table = ["| file | was | becomes | killed by |", "|---|---|---|---|"]
    for mutant, killer in rows:
        cells = [mutant.file, f"`{mutant.old.strip()}`", f"`{mutant.new.strip()}`", killer or f"**nothing** {mutant.why}"]
        table.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    if options.report:
        options.report.write_text("\n".join(table) + "\n", encoding="utf-8")
    survivors = [mutant for mutant, killer in rows if killer is None]
    unexplained = [mutant for mutant in survivors if not mutant.why]
    print(f"{len(rows)} mutants, {len(survivors)} survive, {len(unexplained)} of them unexplained")
    sys.exit(len(unexplained) > 0.03 * len(rows))


if __name__ == "__main__":
    main()
