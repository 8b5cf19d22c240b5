#!/usr/bin/env python3
"""Which requirement is shown by which test, and how the test ended.

tests/traceability.py                    writes tests/traceability.md, the matrix without results
tests/traceability.py --check            fails if that file is not what it would write
tests/traceability.py --results X.xml    prints the matrix with the results of `ctest --output-junit X.xml`

The requirement stands in the first comment of every test file; what a test shows in the comment above it."""

import pathlib
import re
import sys
import xml.etree.ElementTree as xml

HERE = pathlib.Path(__file__).resolve().parent
MATRIX = HERE / "traceability.md"
TEST = re.compile(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)\(\s*(\w+)\s*,\s*(\w+)\s*\)", re.M)


def requirement_of(source, path):
    lines = []
    for line in source.splitlines():
        mark = "#" if path.suffix == ".sh" else "//"
        if line.startswith("#!"):
            continue
        if not line.startswith(mark) or path.name in line:
            break
        lines.append(line.lstrip("/# ").strip())
    said = " ".join(lines)
    cited = re.match(r"Requirement(?: R-\d+(?:, R-\d+)*)?: ", said)
    if not cited:
        sys.exit(f"{path.relative_to(HERE.parent)}:1:1: no requirement (every test says what it shows). "
                 "Begin it with a comment '// Requirement: ...'")
    return said[cited.end():]


def shown_by(source, at):
    """The comment right above a test, as one line."""
    lines = []
    for line in reversed(source[:at].splitlines()):
        if not line.startswith("//"):
            break
        lines.insert(0, line.lstrip("/ ").strip())
    return " ".join(lines)


def files():
    return sorted([*HERE.rglob("*_test.cpp"), *HERE.rglob("*_test.sh")])


def matrix():
    """(requirement, file, [(test, what it shows)]) of every file."""
    for path in files():
        source = path.read_text(encoding="utf-8")
        tests = [(f"{match[1]}.{match[2]}", shown_by(source, match.start())) for match in TEST.finditer(source)]
        yield requirement_of(source, path), path.relative_to(HERE), tests


def results_of(path):
    """How every test ended, by the name that ctest gives it."""
    ended = {}
    for case in xml.parse(path).getroot().iter("testcase"):
        status = case.get("status")
        ended[case.get("name")] = {"run": "passed", "fail": "FAILED"}.get(status, "skipped")
    return ended


def result(ended, name, test):
    """Instances of one test (by rank count or parameter) count together: the worst is what is said."""
    folder = name.split("/")[0]
    found = [status for key, status in ended.items()
             if key == name or key.startswith(folder + "/np")
             or re.fullmatch(rf"{re.escape(folder)}/(?:\w+/)?{re.escape(test)}(?:/.*)?", key)]
    return next((status for status in ("FAILED", "skipped", "passed") if status in found), "not run")


def text(ended=None):
    lines = ["# Requirements and the tests that show them", "",
             "Made by `tests/traceability.py` from the tests themselves; `tests/run.sh` writes the same with results into",
             "`.build/dev/traceability.md`.", ""]
    for requirement, path, tests in matrix():
        name = str(path.with_suffix("")).removesuffix("_test")
        lines += [f"## {requirement[0].upper()}{requirement[1:]}", "", f"`tests/{path}`", ""]
        for test, shows in tests or [(path.stem, "")]:
            status = "" if ended is None else f"**{result(ended, name, test)}** "
            lines.append(f"- {status}{test}" + (f": {shows}" if shows else ""))
        lines.append("")
    return "\n".join(lines)


def main(arguments):
    if arguments[:1] == ["--results"] and len(arguments) == 2:
        print(text(results_of(arguments[1])))
    elif arguments == ["--check"]:
        if not MATRIX.exists() or MATRIX.read_text(encoding="utf-8") != text():
            sys.exit(f"{MATRIX.relative_to(HERE.parent)}: not what the tests say. Run tests/traceability.py")
    elif not arguments:
        MATRIX.write_text(text(), encoding="utf-8")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
