#!/usr/bin/env python3
"""What two builds of the program need for the same work, in one run, beside a goal.

    revisions.py OLD NEW [--campaigns DIR] [--repetitions N] [--only WORD] [--into README.md]

OLD and NEW are build trees with src/overturn and tests/overturn_benchmarks. Both run the campaigns of --campaigns (of this checkout by
default; give those of the older one where it does not know a key). Campaigns and benchmarks run in turn, old, new, old, new; printed
are medians, their ratio, the goal, and the error that the newer build's benchmark states. All times are CPU times: a neighbour on the
machine moves them less than it moves the clock. What a campaign needs for each further wave is the difference of two runs; its commits and
its share of the merge are in it. "From the last trial to the end" is `merge` after a run in two parts. Of what the older build
does not have only the newer one's time is printed."""

import argparse
import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

import campaigns as of_a_benchmark

CAMPAIGNS = {  # name: waves
    "quickstart": 400, "natural_variability": 100, "multi_axis": 4, "pad_strength": 8, "base_shape": 16,
    "similarity_model": 40, "beyond_design": 40}
MERGED = ("quickstart", "natural_variability")  # whose ends are measured too
BENCHMARKS = ("rare/|match/(five_percent|two_percent|srp|judge)|window_energy/(both|second)|spectrum/response/ours|contact_in_lanes"
              "|spatial_in_lanes|rocking/batched/")
GOALS = {  # milliseconds
    "quickstart, each further wave": 2.5, "quickstart, from the last trial to the end": 300,
    "natural_variability, from the last trial to the end": 300, "multi_axis, each further wave": 600,
    "pad_strength, each further wave": 300, "base_shape, each further wave": 100, "rare/campaign_trial_unmeasured": 0.060,
    "rare/campaign_trial_measured": 0.180, "rare/plain_trial": 0.025, "rare/weighted_trial": 0.032, "match/five_percent": 2.5,
    "match/two_percent": 4, "match/srp-3.7.1": 3.5, "window_energy/both/ours": 0.4, "window_energy/second_body/ours": 0.15,
    "spectrum/response/ours": 0.5, "contact_in_lanes/corners": 1.2, "contact_in_lanes/flat_bed": 3, "spatial_in_lanes/corners": 5,
    "spatial_in_lanes/rim": 12, "spatial_in_lanes/flat_bed": 20, **{f"{name}, plan": 2000 for name in CAMPAIGNS}}


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
    name = campaign.stem
    program, few, cpu = build / "src" / "overturn", max(waves // 4, 1), []
    with tempfile.TemporaryDirectory() as folder:
        plan, _ = seconds_of([program, "plan", campaign], folder)
        for count in (few, waves):
            seconds, _ = seconds_of([program, "run", campaign, "--set", f"waves.count={count}", "-o", f"{count}.h5"], folder)
            cpu.append(seconds)
        if name in MERGED:
            for part in ("1/2", "2/2"):
                seconds_of([program, "run", campaign, "--set", f"waves.count={waves}", "-o", "parts.h5", "--part", part], folder)
            end, _ = seconds_of([program, "merge", "parts.h5"], folder)
    each = (cpu[1] - cpu[0]) / (waves - few)
    rows = {f"{name}, from the last trial to the end": 1e3 * end} if name in MERGED else {}
    return rows | {f"{name}, each further wave": 1e3 * each, f"{name}, beside its waves": 1e3 * (cpu[0] - few * each),
                   f"{name}, {waves} waves": 1e3 * cpu[1], f"{name}, plan": 1e3 * plan}


def benchmark_rows(build, only, errors):
    """{row: milliseconds}, of one trajectory where a benchmark counts those; `errors` takes what the rows say of theirs."""
    _, out = seconds_of([build / "tests" / "overturn_benchmarks", f"--benchmark_filter={only or BENCHMARKS}",
                         "--benchmark_format=json", "--benchmark_min_time=0.1"], None)
    to_ms = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}
    rows = {}
    for row in json.loads(out)["benchmarks"]:
        if row.get("run_type", "iteration") == "iteration":
            each = row.get("us_per_trajectory")
            rows[row["name"]] = 1e-3 * each if each else row["cpu_time"] * to_ms[row["time_unit"]]
            if "max_relative_error" in row:
                errors[row["name"]] = f"{row['max_relative_error']:.0e}"
    return rows


def text_of(milliseconds):
    if milliseconds is None:
        return ""
    unit, of_a_ms = next((unit, of_a_ms) for unit, of_a_ms in (("s", 1e-3), ("ms", 1), ("us", 1e3)) if milliseconds * of_a_ms >= 1 or unit == "us")
    return f"{milliseconds * of_a_ms:.3g} {unit}"


def print_rows(table, seen, errors):
    """Of the newer build's rows the medians of both."""
    for name, times in seen[1].items():
        new = statistics.median(times)
        old = statistics.median(seen[0][name]) if name in seen[0] else None
        table.add(name, text_of(old), text_of(new), f"{new / old:.2f}" if old else "", text_of(GOALS.get(name)), errors.get(name, ""))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("builds", nargs=2, type=lambda text: pathlib.Path(text).resolve(), metavar="BUILD")
    of_a_benchmark.add_options(parser, seconds=None, repetitions=20)
    options = parser.parse_args()
    errors = {}
    jobs = [lambda build, name=name, waves=waves: campaign_rows(build, options.campaigns.resolve() / f"{name}.toml", waves)
            for name, waves in CAMPAIGNS.items() if options.only in name]
    if not options.only or not any(options.only in name for name in CAMPAIGNS):
        jobs.append(lambda build: benchmark_rows(build, options.only, errors))
    old, new = (of_a_benchmark.revision(build / "src" / "overturn") for build in options.builds)
    table = of_a_benchmark.Table("revisions", ["work (CPU time)", f"before ({old})", f"now ({new})", "now / before", "goal", "error"], options,
                                 f"Medians of {options.repetitions} in turn.")
    for job in jobs:
        seen = [{}, {}]
        for _ in range(options.repetitions):
            for build, rows in zip(options.builds, seen):
                for name, value in job(build).items():
                    rows.setdefault(name, []).append(value)
        print_rows(table, seen, errors)
    table.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
