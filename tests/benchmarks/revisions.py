#!/usr/bin/env python3
"""What two builds of the program need for the same work, in one run.

    revisions.py OLD NEW [--campaigns DIR] [--repetitions N] [--only WORD]

OLD and NEW are build trees with src/overturn and tests/overturn_benchmarks. Both run the campaigns of --campaigns (of this checkout by
default; give those of the older one where it does not know a key). Campaigns and benchmarks run in turn, old, new, old, new; printed
are medians and their ratio. All times are CPU times: a neighbour on the machine moves them less than it moves the clock. What a campaign
needs for each further wave is the difference of two runs; its commits and its share of the merge are in it. Rows that one build lacks are
left out."""

import argparse
import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

CAMPAIGNS = {  # name: waves
    "quickstart": 400, "natural_variability": 100, "multi_axis": 4, "pad_strength": 8, "base_shape": 16,
    "similarity_model": 40, "beyond_design": 40}
BENCHMARKS = ("rare/|match/(five_percent|two_percent|srp|judge)|window_energy/both|spectrum/response/ours|contact_in_lanes"
              "|spatial_in_lanes|rocking/batched/")


def seconds_of(command, folder):
    """CPU seconds of a command and its children."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr[-400:]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def campaign_rows(build, campaign, waves):
    """{row: milliseconds} of two runs, one of a quarter of the waves."""
    program, few, cpu = build / "src" / "overturn", max(waves // 4, 1), []
    with tempfile.TemporaryDirectory() as folder:
        plan, _ = seconds_of([program, "plan", campaign], folder)
        for count in (few, waves):
            seconds, _ = seconds_of([program, "run", campaign, "--set", f"waves.count={count}", "-o", f"{count}.h5"], folder)
            cpu.append(seconds)
    each = (cpu[1] - cpu[0]) / (waves - few)
    name = campaign.stem
    return {f"{name}, each further wave": 1e3 * each, f"{name}, beside its waves": 1e3 * (cpu[0] - few * each),
            f"{name}, {waves} waves": 1e3 * cpu[1], f"{name}, plan": 1e3 * plan}


def benchmark_rows(build, only):
    _, out = seconds_of([build / "tests" / "overturn_benchmarks", f"--benchmark_filter={only or BENCHMARKS}",
                         "--benchmark_format=json", "--benchmark_min_time=0.1"], None)
    to_ms = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}
    return {row["name"]: row["cpu_time"] * to_ms[row["time_unit"]] for row in json.loads(out)["benchmarks"]
            if row.get("run_type", "iteration") == "iteration"}


def text_of(milliseconds):
    return f"{milliseconds:.3g} ms" if milliseconds >= 1 else f"{1e3 * milliseconds:.3g} us"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("builds", nargs=2, type=lambda text: pathlib.Path(text).resolve(), metavar="BUILD")
    parser.add_argument("--campaigns", type=lambda text: pathlib.Path(text).resolve(),
                        default=pathlib.Path(__file__).resolve().parents[2] / "campaigns")
    parser.add_argument("--repetitions", type=int, default=20)
    parser.add_argument("--only", default="", help="of campaigns and benchmarks those with this word")
    options = parser.parse_args()
    jobs = [lambda build, name=name, waves=waves: campaign_rows(build, options.campaigns / f"{name}.toml", waves)
            for name, waves in CAMPAIGNS.items() if options.only in name]
    if not options.only or not any(options.only in name for name in CAMPAIGNS):
        jobs.append(lambda build: benchmark_rows(build, options.only))
    print("| work (CPU time) | old | new | new over old |\n|---|---|---|---|")
    for job in jobs:
        seen = [{}, {}]
        for _ in range(options.repetitions):
            for build, rows in zip(options.builds, seen):
                for name, value in job(build).items():
                    rows.setdefault(name, []).append(value)
        for name in seen[1]:
            if name in seen[0]:
                old, new = (statistics.median(rows[name]) for rows in seen)
                print(f"| {name} | {text_of(old)} | {text_of(new)} | {new / old:.2f} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
