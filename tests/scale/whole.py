#!/usr/bin/env python3
"""Requirement R-1303: a whole campaign on many ranks, added up from measured parts: start, work, commits, merge, curves.

    whole.py [--trials 100000000] [--ranks 1 100 1000] [--wave S] [--check] ...     adds up
    whole.py --measure PROGRAM [--mpirun MPIRUN] [--sizes 1000000 2000000 4000000]   measures parts, then adds up with them

The defaults of the parts are those of the tables in README.md; a wave is quickstart's (tests/benchmarks). Work is simulated by the
rule of ranks.py: blocks as a campaign is cut, each with its commit, handed out to ranks that scatter (--scatter). The rest is
arithmetic: ranks share the rows of the merge and the bytes of the file (--bandwidth: what the file system gives to all of them
together, an assumption); each fits whole curves; rank 0 alone receives the trials that are held for curves and writes tables.

Printed for each number of ranks: seconds of each part; wall time; its serial part, which more ranks do not shorten: start, one curve,
rank 0 alone; efficiency: the time that one rank computes waves, over the time of all ranks. Then the shares of the time of all ranks that
each part takes beside the waves: of the work commits, and ranks that wait for the last blocks or hand blocks out.

--measure: CPU times of `run --leave-blocks` and of `merge` on one and on four ranks, of the campaign of ten_million.py in three
sizes, two of them at or above the number of trials that are held. Ten minutes on two free cores, 6 GB below --folder.

--check: ends with 1 where the largest number of ranks has a serial part of 10 s or more."""

import argparse
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

import ranks as rule_of_ranks
import ten_million

CURVES = 10  # of ten_million.py's two bodies
HELD = rule_of_ranks.constants(rule_of_ranks.SOURCE / "results" / "measured_trials.hpp", ("most_trials_held",))["most_trials_held"]
PARTS = {
    "start": (0.3, "of a run until its first block, all ranks at once [s]"),
    "wave": (0.00474, "a wave with its trials [s]"),
    "commit": (0.005, "putting a block to disk [s]"),
    "row": (2.4e-6, "reading, counting, writing and hashing the row of a trial [s]"),
    "fit": (2.0e-6, "fitting all curves, for each trial held [s]"),
    "receive": (0.5e-6, "rank 0, for each trial held for curves [s]"),
    "alone": (0.6, "rank 0: quantiles, criterion, tables, attributes [s]"),
}


def added_up(options, ranks):
    """Seconds by part; of one rank all waves, and all commits."""
    waves = -(-options.trials // options.trials_of_wave)
    draw = random.Random(2013)
    costs = []
    for count in rule_of_ranks.waves_in_blocks(waves):
        scatter = draw.lognormvariate(-0.5 * options.scatter**2, options.scatter)
        costs.append(options.wave * count * scatter + options.commit)
    rule = rule_of_ranks.constants(rule_of_ranks.WORKER, rule_of_ranks.RULE)
    held = min(options.trials, HELD)
    rounds = -(-CURVES // ranks)
    parts = {
        "start": options.start,
        "work": rule_of_ranks.Run(rule, ranks, costs, [1.0] * ranks, True).wall(),
        "rows": options.row * options.trials / ranks,
        "file": 2 * options.bytes * options.trials / (1e9 * min(options.bandwidth, ranks * options.bandwidth_of_rank)),
        "curves": options.fit * held * rounds / CURVES,
        "rank 0": options.receive * held * (1 if ranks > 1 else 0) + options.alone,
    }
    return parts, options.wave * waves, options.commit * len(costs)


def lost(parts, work, commits, ranks):
    """Shares of the time of all ranks that are no waves, by what they are, in the order in which they come."""
    idle = parts["work"] - (work + commits) / ranks
    seconds = {"start": parts["start"], "commits": commits / ranks, "last blocks": idle} | \
        {name: parts[name] for name in ("rows", "file", "curves", "rank 0")}
    return {name: value / sum(parts.values()) for name, value in seconds.items()}


def table(options):
    print(f"{options.trials} trials, {-(-options.trials // options.trials_of_wave)} waves of {1e3 * options.wave:g} ms; file of "
          f"{options.bytes * options.trials / 1e9:.3g} GB, written once and read once at {options.bandwidth:g} GB/s at most\n")
    columns = ("start", "work", "rows", "file", "curves", "rank 0")
    print("| ranks | " + " | ".join(columns) + " | wall time | serial part | efficiency |\n|" + "---|" * (len(columns) + 4))
    serial, losses = 0.0, []
    for ranks in options.ranks:
        parts, work, commits = added_up(options, ranks)
        losses.append((ranks, lost(parts, work, commits, ranks)))
        wall = sum(parts.values())
        serial = parts["start"] + parts["curves"] / -(-CURVES // ranks) + parts["rank 0"]
        cells = [f"{parts[name]:.3g} s" for name in columns]
        print(f"| {ranks} | " + " | ".join(cells) + f" | {wall:.4g} s | {serial:.2g} s | {100 * work / (ranks * wall):.0f} % |")
    print("\n| ranks | waves | " + " | ".join(losses[0][1]) + " |\n|" + "---|" * (len(losses[0][1]) + 2))
    for ranks, shares in losses:
        print(f"| {ranks} | {100 * (1 - sum(shares.values())):.1f} % | " + " | ".join(f"{100 * share:.1f} %" for share in shares.values()) + " |")
    return serial


class Measured:
    """CPU times of real runs in a folder."""

    def __init__(self, program, mpirun, folder):
        self.program, self.mpirun, self.folder = os.path.abspath(program), mpirun, folder

    def cpu_s(self, ranks, *arguments):
        """Of each rank, by its shell."""
        shell = 'n=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-0}}; "$@" >told.$n 2>&1 || exit 1; times >times.$n'
        launcher = [self.mpirun, "-n", str(ranks)] if ranks > 1 else []
        ended = subprocess.run([*launcher, "bash", "-c", shell, "bash", self.program, *arguments], cwd=self.folder,
                               env=os.environ | ten_million.MPI, capture_output=True, text=True, check=False)
        if ended.returncode != 0:
            raise SystemExit(f"{' '.join(arguments)} ended with {ended.returncode}: {ended.stderr}{(self.folder / 'told.0').read_text()}")
        seconds = []
        for rank in range(ranks):
            used = (self.folder / f"times.{rank}").read_text().splitlines()[1].split()
            seconds.append(sum(60 * float(part.split("m")[0]) + float(part.split("m")[1].rstrip("s")) for part in used))
        return seconds

    def campaign(self, trials, levels=50):
        """CPU seconds of a run; of merges on one and on four ranks, each rank's; runtime file; bytes of the results."""
        text = ten_million.CAMPAIGN.format(waves=trials // (ten_million.BODIES * levels), levels=levels)
        (self.folder / "c.toml").write_text(text)
        run = self.cpu_s(1, "run", "c.toml", "-o", "one.h5", "--leave-blocks")[0]
        shutil.copytree(self.folder / "one.h5.parts", self.folder / "four.h5.parts")
        blocks = sum(1 for _ in (self.folder / "one.h5.parts").rglob("*.block"))
        one = self.cpu_s(1, "merge", "one.h5")[0]
        four = self.cpu_s(4, "merge", "four.h5")
        runtime = json.loads((self.folder / "one.runtime.json").read_text())
        size = (self.folder / "one.h5").stat().st_size
        for name in ("one.h5", "four.h5"):
            (self.folder / name).unlink()
        print(f"{trials} trials, CPU time: run {run:.1f} s; merge {one:.1f} s, of four ranks {' '.join(f'{s:.1f}' for s in four)} s; "
              f"{blocks} blocks, {size / trials:.0f} bytes a trial", flush=True)
        return run, one, four, runtime, blocks, size


def measure(options, folder):
    """Puts the parts found into the options."""
    small, held, large = options.sizes
    if not small < held <= large or held < HELD or held == large:
        raise SystemExit(f"--sizes: the second and the third must be {HELD:.0f} or more, and rise")
    measured = Measured(options.measure, options.mpirun, folder)
    of = {trials: measured.campaign(trials) for trials in options.sizes}
    row = (of[large][1] - of[held][1]) / (large - held)
    if row <= 0:
        raise SystemExit("merge takes no longer with more trials (other programs disturb it, or --sizes are too small). Measure again")
    each_held = (of[held][1] - of[small][1] - row * (held - min(small, held))) / (HELD - small)
    alone = of[held][1] - row * held - each_held * HELD
    # Rank 0 of four fits three of ten curves.
    fit = (alone + row * held / 4 + each_held * HELD - of[held][2][0]) / (HELD * (1 - 3 / CURVES))
    _, _, _, runtime, blocks, size = of[large]
    rank = runtime["ranks"][0]
    print(f"a wave of this campaign: {sum(rank[part] for part in ('waves_s', 'measures_s', 'response_s')) / (large / 100) * 1e3:.2f} ms")
    options.start, options.commit = runtime["segments"][0]["start_s"], rank["store_s"] / blocks
    options.row, options.fit, options.receive, options.alone = row, max(0.0, fit), max(0.0, each_held - fit), max(0.0, alone)
    options.bytes = size / large
    for name, (_, meaning) in PARTS.items():
        print(f"--{name} {getattr(options, name):.3g}  {meaning}")
    print()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trials", type=int, default=100_000_000)
    parser.add_argument("--trials-of-wave", type=int, default=24)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 100, 1000])
    parser.add_argument("--scatter", type=float, default=0.3)
    parser.add_argument("--bytes", type=float, default=620, help="of the plain file, for each trial")
    parser.add_argument("--bandwidth", type=float, default=50, help="GB/s, of all ranks together")
    parser.add_argument("--bandwidth-of-rank", type=float, default=1, help="GB/s")
    for name, (default, meaning) in PARTS.items():
        parser.add_argument(f"--{name}", type=float, default=default, help=meaning)
    parser.add_argument("--measure", metavar="PROGRAM")
    parser.add_argument("--mpirun", default="mpirun")
    parser.add_argument("--sizes", type=int, nargs=3, default=[1_000_000, 2_000_000, 4_000_000])
    parser.add_argument("--folder", default=None)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.measure:
        with tempfile.TemporaryDirectory(prefix="overturn-whole-", dir=options.folder) as folder:
            measure(options, pathlib.Path(folder))
    serial = table(options)
    return 1 if options.check and serial >= 10 else 0


if __name__ == "__main__":
    sys.exit(main())
