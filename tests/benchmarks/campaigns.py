"""Campaigns that a benchmark runs, what their plans say, and the tables of README.md: for forecasts.py, two_ranks.py and revisions.py."""

import datetime
import os
import pathlib
import re
import subprocess

os.environ.update({"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})


def program(text):
    return pathlib.Path(text).resolve()


def add_options(parser, seconds, repetitions):
    parser.add_argument("--campaigns", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2] / "campaigns")
    if seconds is not None:
        parser.add_argument("--seconds", type=float, default=seconds)
    parser.add_argument("--repetitions", type=int, default=repetitions)
    parser.add_argument("--only", default="")
    parser.add_argument("--into", type=pathlib.Path, metavar="PAGE",
                        help="puts the table into this page, in place of its own; with --only its rows alone")


def chosen(options):
    return [campaign for campaign in sorted(options.campaigns.resolve().glob("*.toml")) if options.only in campaign.stem]


def counts_waves(campaign):
    """Can the number of its waves be stated?"""
    return bool(re.search(r"^count\b", campaign.read_text(), re.MULTILINE))


def one_rank(plan):
    return next(ranks for ranks in plan["ranks"] if ranks["ranks"] == 1)


def machine():
    """The processor, as its maker names it."""
    names = re.findall(r"^model name\s*:\s*(.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return f"{names[0] if names else 'unknown processor'}, {os.cpu_count()} cores"


def revision(program):
    """The revision that a program was built from, and whether its sources were others."""
    text = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    return "".join(part or "" for part in re.search(r"\((\w{8})\w*(-dirty)?", text).groups())


class Table:
    """Prints a table row by row as it is measured; at the end puts it into a page, between its marks there.

    The lines between <!-- NAME --> and <!-- /NAME --> are the script's own: what was run where, and the table."""

    def __init__(self, name, head, options, of):
        self.name, self.options = name, options
        self.head = [f"| {' | '.join(head)} |", "|" + "---|" * len(head)]
        self.rows = {}
        self.of = of
        self.load = os.getloadavg()[0]
        print("\n".join(self.head), flush=True)

    def add(self, *cells):
        self.rows[cells[0]] = f"| {' | '.join(cells)} |"
        print(self.rows[cells[0]], flush=True)

    def close(self):
        if self.options.into is None:
            return
        text = self.options.into.read_text()
        begin, end = f"<!-- {self.name} -->\n", f"<!-- /{self.name} -->"
        if text.count(begin) != 1 or text.count(end) != 1:
            raise SystemExit(f"{self.options.into}: no place {begin.strip()} to {end}")
        before, rest = text.split(begin)
        old, after = rest.split(end)
        lines = old.splitlines()
        kept = {line.split(" | ")[0].removeprefix("| "): line for line in lines if line.startswith("| ")} if self.options.only else {}
        kept.pop(self.head[0].split(" | ")[0].removeprefix("| "), None)
        shared = self.options.only and self.head[0] in lines
        rows = {**kept, **self.rows} if shared else self.rows
        told = f"{datetime.date.today()}, {machine()}, load {self.load:.1f} before and {os.getloadavg()[0]:.1f} after. {self.of}"
        if shared:
            told = f"{lines[0]}\nRows of {self.options.only}: {told}"
        self.options.into.write_text(before + begin + "\n".join([told, "", *self.head, *rows.values(), ""]) + end + after)
