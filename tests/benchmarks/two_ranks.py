#!/usr/bin/env python3
"""How many times faster two ranks are than one: every campaign, in one run.

    two_ranks.py PROGRAM... [--mpirun MPIRUN] [--campaigns DIR] [--seconds 8] [--repetitions 3] [--only WORD] [--cpu]
                 [--into README.md]

Campaigns whose waves can be counted take so many waves that one rank needs about --seconds by its plan, and never fewer than eight. A run on
one rank and one on two follow each other --repetitions times, of several programs in turn with the same waves. Printed are medians of wall time, their ratio, and the ratio of the work
alone: start, reading and what one rank does at the end are taken from both by a run of two waves. The machine must have two free cores:
nothing here can tell a slow program from a busy neighbour. With --cpu the times are the CPU time of the rank that has most of it: ranks that
wait sleep, so this is what free cores would take, without what waits for a disk."""

import argparse
import json
import os
import pathlib
import re
import statistics
import subprocess
import tempfile
import time

import campaigns

MPI = {"OMPI_MCA_hwloc_base_binding_policy": "none"}
FEW = 2


def seconds_of(command, folder):
    began = time.perf_counter()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=os.environ | MPI)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr[-400:]}")
    return time.perf_counter() - began, done.stdout


def cpu_seconds_of(command, folder):
    """Of the busiest rank: each leaves its own in a file of the folder."""
    at = command.index("-n") + 2
    keep = 'here=$(mktemp ./cpu.XXXXXX); "$@"; code=$?; times > $here; exit $code'
    seconds_of([*command[:at], "bash", "-c", keep, "rank", *command[at:]], folder)
    of_ranks = []
    for place in pathlib.Path(folder).glob("cpu.*"):
        of_children = place.read_text().splitlines()[1]
        of_ranks.append(sum(60 * int(minutes) + float(rest) for minutes, rest in re.findall(r"(\d+)m([\d.]+)s", of_children)))
    return max(of_ranks)


def waves_for(program, campaign, seconds):
    """As many waves as one rank computes in so many seconds; none where the campaign's waves are not counted."""
    if not campaigns.counts_waves(campaign):
        return None
    plan = json.loads(seconds_of([program, "plan", campaign, "--json"], None)[1])
    return max(8, 2 * round(seconds * plan["waves"] / campaigns.one_rank(plan)["work_s"] / 2))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("programs", metavar="PROGRAM", nargs="+", type=campaigns.program)
    parser.add_argument("--mpirun", default="mpirun")
    campaigns.add_options(parser, seconds=8, repetitions=3)
    parser.add_argument("--cpu", action="store_true")
    options = parser.parse_args()
    of = " and ".join(campaigns.revision(program) for program in options.programs)
    table = campaigns.Table("two_ranks", ["campaign", "waves", "one rank", "two ranks", "times faster", "its work alone"], options,
                            f"Revision {of}, `--seconds {options.seconds:g} --repetitions {options.repetitions}{' --cpu' if options.cpu else ''}`.")
    for campaign in campaigns.chosen(options):
        waves = waves_for(options.programs[0], campaign, options.seconds)
        if waves is None:
            continue
        taken = {(program, count, ranks): [] for count in (FEW, waves) for ranks in (1, 2) for program in options.programs}
        for _ in range(options.repetitions):
            for program, count, ranks in taken:
                with tempfile.TemporaryDirectory() as folder:
                    command = [options.mpirun, "-n", str(ranks), program, "run", campaign, "--set", f"waves.count={count}",
                               "-o", "r.h5"]
                    taken[program, count, ranks].append(cpu_seconds_of(command, folder) if options.cpu else seconds_of(command, folder)[0])
        middle = {run: statistics.median(times) for run, times in taken.items()}
        for program in options.programs:
            one, two = (middle[program, waves, ranks] for ranks in (1, 2))
            alone = [middle[program, waves, ranks] - middle[program, FEW, ranks] for ranks in (1, 2)]
            name = campaign.stem if program == options.programs[0] else f"{campaign.stem}, {campaigns.revision(program)}"
            table.add(name, f"{waves}", f"{one:.2f} s", f"{two:.2f} s", f"{one / two:.2f}", f"{alone[0] / alone[1]:.2f}")
    table.close()


if __name__ == "__main__":
    main()
