#!/usr/bin/env python3
"""Does `plan` say what a run then takes? Every campaign, on one rank.

    forecasts.py PROGRAM [--campaigns DIR] [--seconds 300] [--repetitions 1] [--only WORD] [--into README.md]

A plan and a run follow each other at once, so that neighbours on the machine slow both alike. Printed are what the plan says for one rank, what
the run takes from the start of its program to its end, their ratio, what the run's FILE.runtime.json says, and the run's CPU time: where that
is far below the run's time, a neighbour had the core. Of a campaign whose plan exceeds --seconds so few waves are taken that it does not: its
row says how many. With more repetitions each figure is a median."""

import argparse
import json
import pathlib
import resource
import statistics
import subprocess
import tempfile
import time

import campaigns


def seconds_of(command, folder):
    """Wall and CPU time of a command, and what it printed; no output where it refused its input."""
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    wall, after = time.perf_counter() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip().splitlines()[-1])
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def fewer_waves(campaign, plan, seconds):
    """Settings under which the plan is of so many seconds; none where it is of fewer."""
    one = campaigns.one_rank(plan)
    if one["wall_s"] <= seconds or not campaigns.counts_waves(campaign):
        return []
    return ["--set", f"waves.count={max(2, int(plan['waves'] * seconds / one['wall_s']))}"]


def compared(program, campaign, seconds):
    with tempfile.TemporaryDirectory() as folder:
        def planned(settings):
            return json.loads(seconds_of([program, "plan", campaign, "--json", *settings], folder)[2])

        plan = planned([])
        settings = fewer_waves(campaign, plan, seconds)
        plan = planned(settings) if settings else plan
        wall, cpu, _ = seconds_of([program, "run", campaign, "-o", "r.h5", *settings], folder)
        told = json.loads((pathlib.Path(folder) / "r.runtime.json").read_text())["wall_s"]
    return plan["waves"], bool(settings), campaigns.one_rank(plan), wall, told, cpu


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", metavar="PROGRAM", type=campaigns.program)
    campaigns.add_options(parser, seconds=300, repetitions=1)
    options = parser.parse_args()
    table = campaigns.Table("forecasts", ["campaign", "waves", "plan", "run", "run / plan", "`wall_s`", "CPU time"], options,
                            f"Revision {campaigns.revision(options.program)}, `--seconds {options.seconds:g} --repetitions {options.repetitions}`.")
    for campaign in campaigns.chosen(options):
        try:
            rows = [compared(options.program, campaign, options.seconds) for _ in range(options.repetitions)]
        except RuntimeError as error:
            table.add(campaign.stem, f"not run: {error}", "", "", "", "", "")
            continue
        waves, fewer = rows[0][:2]
        plan, run, told, cpu = (statistics.median(times) for times in zip(*((r[2]["wall_s"], *r[3:]) for r in rows)))
        table.add(campaign.stem, f"{waves}{' (fewer)' if fewer else ''}", f"{plan:.2f} s", f"{run:.2f} s", f"{run / plan:.2f}", f"{told:.2f} s",
                  f"{cpu:.2f} s")
    table.close()


if __name__ == "__main__":
    main()
