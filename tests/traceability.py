#!/usr/bin/env python3
"""Which requirement is shown by which test, and how the test ended.

tests/traceability.py                    prints the matrix without results
tests/traceability.py --check            prints nothing
tests/traceability.py --results X.xml    prints the matrix with the results of `ctest --output-junit X.xml`

All three fail where a requirement of tests/requirements.md is cited by no test, or a test cites none or an unknown one.
The first comment of every test file begins with `// Requirement R-101, R-102: what it shows of them` (in a script: #);
all tests of the file show those. The comment right above a single test may name further ones (R-103)."""

import dataclasses
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
PAGE = HERE / "requirements.md"
CHECKS = ROOT / "src" / "qualify"

TEST = re.compile(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)\(\s*(\w+)\s*,\s*(\w+)\s*\)", re.M)
NUMBER = re.compile(r"\bR-\d+\b")
CHECK = re.compile(r"\b[A-Z]-\d\d\b")
ROW = re.compile(r"\| (R-\d+) \| ([^|]+) \| ([^|]+) \| ([^|]*)\|")
FIRST_COMMENT = re.compile(r"Requirement (R-\d+(?:, R-\d+)*): (.+)")
CITED_FIRST = re.compile(r"^R-\d+(?:, R-\d+)*[:.] ?")
ENDED = ("FAILED", "passed", "skipped", "not run")  # the order in which a line tells them


@dataclasses.dataclass
class Requirement:
    number: str
    sentence: str
    source: str
    checks: list
    line: int


@dataclasses.dataclass
class Test:
    name: str
    shows: str
    further: list  # numbers that its own comment cites
    line: int

    def disabled(self):
        return "DISABLED_" in self.name


@dataclasses.dataclass
class File:
    path: pathlib.Path
    shows: str
    numbers: list
    tests: list


class Faults(list):
    """Everything that is wrong, one line each: file:line:col: problem (why) what to do."""

    def add(self, path, line, column, text):
        self.append(f"{path.relative_to(ROOT)}:{line}:{column}: {text}")

    def end_if_any(self):
        if self:
            sys.exit("\n".join(self))


def read_page(faults):
    """(groups of requirements by their heading, {number: why it is not shown yet})"""
    groups, not_shown, known = {}, {}, {}
    heading, last = "", None
    for at, line in enumerate(PAGE.read_text(encoding="utf-8").splitlines(), 1):
        row = ROW.fullmatch(line)
        listed = re.match(r"- (R-\d+): (.+)", line)
        if line.startswith("## "):
            heading, last = line[3:], None
        elif row:
            one = Requirement(row[1], row[2], row[3], CHECK.findall(row[4]), at)
            if one.number in known:
                faults.add(PAGE, at, 3, f"{one.number}: stated twice (first in line {known[one.number].line}). "
                                        "Give this one a number of its own")
            known[one.number] = one
            groups.setdefault(heading, []).append(one)
        elif line.startswith("| R-"):
            faults.add(PAGE, at, 1, "no requirement (a row is | number | sentence | source | checks |). Mend the row")
        elif listed:
            last = listed[1]
            not_shown[last] = (listed[2], at)
        elif last and line.startswith("  "):
            not_shown[last] = (f"{not_shown[last][0]} {line.strip()}", not_shown[last][1])
    return groups, not_shown


def comment_lines(source, path):
    """(line, text) of the first comment; a script's ends where its usage begins."""
    mark = "#" if path.suffix == ".sh" else "//"
    for at, line in enumerate(source.splitlines(), 1):
        if line.startswith("#!"):
            continue
        if not line.startswith(mark) or path.name in line:
            return
        yield at, line.lstrip("/# ").strip()


def comment_above(source, at):
    """The comment right above a test, as one line."""
    lines = []
    for line in reversed(source[:at].splitlines()):
        if not line.startswith("//"):
            break
        lines.insert(0, line.lstrip("/ ").strip())
    return " ".join(lines)


def read_file(path, faults):
    source = path.read_text(encoding="utf-8")
    said = list(comment_lines(source, path))
    first = FIRST_COMMENT.fullmatch(" ".join(text for _, text in said))
    if not first:
        at = said[0][0] if said else 1
        faults.add(path, at, 1, "cites no requirement (every test says which one it shows). Begin it with a comment "
                                "'Requirement R-101: ...'; tests/requirements.md has the numbers")
        return None
    if path.suffix == ".sh":
        return File(path, first[2], NUMBER.findall(first[1]), [Test(path.stem, "", [], 1)])
    tests = []
    for match in TEST.finditer(source):
        comment = comment_above(source, match.start())
        tests.append(Test(f"{match[1]}.{match[2]}", CITED_FIRST.sub("", comment), NUMBER.findall(comment),
                          source.count("\n", 0, match.start()) + 1))
    return File(path, first[2], NUMBER.findall(first[1]), tests)


def test_files(faults):
    found = [read_file(path, faults) for path in sorted([*HERE.rglob("*_test.cpp"), *HERE.rglob("*_test.sh")])]
    return [file for file in found if file]


def find_faults(groups, not_shown, files, faults):
    known = {one.number: one for group in groups.values() for one in group}
    shown = set()
    for file in files:
        for test in file.tests:
            cited = {*file.numbers, *test.further}
            shown |= set() if test.disabled() else cited
            for number in sorted(set(test.further) - set(known)):
                faults.add(file.path, test.line, 1, f"{test.name}: {number} (no such requirement). "
                                                    "Cite one of tests/requirements.md")
        for number in sorted(set(file.numbers) - set(known)):
            faults.add(file.path, 1, 1, f"{number} (no such requirement). Cite one of tests/requirements.md")
    for number, one in known.items():
        if number not in shown and number not in not_shown:
            faults.add(PAGE, one.line, 3, f"{number}: shown by no test (nothing cites it, or only what is disabled). "
                                          "Cite it in the test that shows it, or list it under 'Not shown yet'")
    for number, (_, line) in not_shown.items():
        if number not in known:
            faults.add(PAGE, line, 3, f"{number} (no such requirement). Strike it there")
        elif number in shown:
            faults.add(PAGE, line, 3, f"{number}: said not to be shown (a test cites it). Strike it there")
    find_check_faults(known, faults)


def find_check_faults(known, faults):
    """Every check of `overturn qualify` shows a requirement."""
    stated = {check: one.line for one in known.values() for check in one.checks}
    made = {}
    for path in sorted(CHECKS.glob("*.cpp")):
        for at, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            made.update({found[1]: (path, at, found.start(1) + 1) for found in re.finditer(r'"([A-Z]-\d\d)"', line)})
    for check in sorted(set(made) - set(stated)):
        faults.add(*made[check], f"{check}: in no row of tests/requirements.md (every check shows a requirement). "
                                 "Name it in the last column of the one that it shows")
    for check in sorted(set(stated) - set(made)):
        faults.add(PAGE, stated[check], 3, f"{check} (no such check in src/qualify). Strike it")


def results_of(path):
    """How every test ended, by the name that ctest gives it."""
    ended = {}
    for case in xml.parse(path).getroot().iter("testcase"):
        ended[case.get("name")] = {"run": "passed", "fail": "FAILED"}.get(case.get("status"), "skipped")
    return ended


def result(ended, file, test):
    """Instances of one test (by rank count or parameter) count together: the worst is what is said."""
    folder = file.path.relative_to(HERE).parts[0]
    name = test.name.replace("DISABLED_", "").removesuffix("_test")
    mine = re.compile(rf"{re.escape(folder)}/(?:np\d+|(?:\w+/)?{re.escape(name)}(?:/.*)?)")
    found = [status for key, status in ended.items() if mine.fullmatch(key)]
    return next((status for status in ("FAILED", "skipped", "passed") if status in found), "not run")


class Matrix:
    """The page that is written; `ended` is None where no results are asked for."""

    def __init__(self, groups, not_shown, files, ended):
        self.groups, self.not_shown, self.files, self.ended = groups, not_shown, files, ended

    def status(self, file, test):
        return "" if self.ended is None else result(self.ended, file, test)

    def told(self, file, tests):
        """Tests that say what they show, one a line; the others' names together."""
        lines = []
        for test in tests:
            if test.shows:
                status = self.status(file, test)
                lines.append("  - " + (f"**{status}** " if status else "") + f"{test.name}: {test.shows}")
        silent = [test for test in tests if not test.shows]
        for status in ENDED if self.ended is not None else ("",):
            names = [test.name for test in silent if self.status(file, test) == status]
            if names:
                lines.append("  - " + (f"**{status}** " if status else "") + ", ".join(names))
        return lines

    def count(self, file, tests):
        said = "1 test" if len(tests) == 1 else f"{len(tests)} tests"
        if self.ended is None:
            return said
        found = [self.status(file, test) for test in tests]
        return said + ": " + ", ".join(f"{found.count(status)} {status}" for status in ENDED if status in found)

    def shown_in(self, file, number):
        """A file's tests stand in full under the first of its numbers, under the others they are counted."""
        path = f"- `tests/{file.path.relative_to(HERE)}`"
        if number == file.numbers[0]:
            return [f"{path}: {file.shows}", *self.told(file, file.tests)]
        if number in file.numbers:
            return [f"{path}: {file.shows} ({self.count(file, file.tests)}, under {file.numbers[0]})"]
        further = [test for test in file.tests if number in test.further]
        return [path, *self.told(file, further)] if further else []

    def state(self, number):
        found = [self.status(file, test) for file in self.files for test in file.tests
                 if number in file.numbers or number in test.further]
        if number in self.not_shown:
            return "not shown yet"
        if "FAILED" in found:
            return f"failed, {found.count('FAILED')} of {len(found)} tests"
        if "passed" not in found:
            return "not run"
        left = len(found) - found.count("passed")
        return "shown" + (f", {left} of {len(found)} tests not run" if left else "")

    def section(self, one):
        state = "" if self.ended is None else f" ({self.state(one.number)})"
        source = f"*{one.source}*" + (f"; qualify: {', '.join(one.checks)}" if one.checks else "")
        lines = [f"### {one.number}{state}", "", one.sentence, "", source, ""]
        for file in self.files:
            lines += self.shown_in(file, one.number)
        return [*lines, *(["**Not shown yet.**"] if one.number in self.not_shown else []), ""]

    def text(self):
        lines = ["# Requirements and the tests that show them", "",
                 "Made by `tests/traceability.py` from `tests/requirements.md` and the tests themselves;",
                 "`tests/run.sh` writes the same with results into `.build/dev/traceability.md`.", ""]
        if self.ended is not None:
            states = [self.state(one.number).split(",")[0] for group in self.groups.values() for one in group]
            counted = [f"{states.count(state)} {state}" for state in ("shown", "failed", "not run", "not shown yet")]
            lines += [f"Of {len(states)} requirements: {', '.join(counted)}.", ""]
        if self.not_shown:
            lines += ["**Not shown yet:**", ""]
            lines += [f"- {number}: {why}" for number, (why, _) in self.not_shown.items()] + [""]
        for heading, group in self.groups.items():
            lines += [f"## {heading}", ""]
            for one in group:
                lines += self.section(one)
        return "\n".join(lines)


def main(arguments):
    asked = arguments[0] if arguments else ""
    if asked not in ("", "--check", "--results") or len(arguments) != {"": 0, "--check": 1, "--results": 2}[asked]:
        sys.exit(__doc__)
    faults = Faults()
    groups, not_shown = read_page(faults)
    files = test_files(faults)
    find_faults(groups, not_shown, files, faults)
    if asked != "--check":
        print(Matrix(groups, not_shown, files, results_of(arguments[1]) if asked else None).text())
    faults.end_if_any()


if __name__ == "__main__":
    main(sys.argv[1:])
