#!/usr/bin/env python3
"""Requirement R-1303: one slow rank among several changes no byte of the file.

    slow_rank.py PROGRAM [--waves N] [--ranks N] [--slow N] [--times N] [--after S] [--pairs N] [--mpirun MPIRUN]

Runs one campaign of rigid bodies on --ranks ranks, in turns with all equal and with rank --slow held up by SIGSTOP and SIGCONT so that
it may run for one part in --times (20) of the time that a rank has: where cores are fewer than ranks, of its share of them. It is held up
from --after seconds (1) on: starting takes each rank the same, and all wait for the last. Prints wall time, and the CPU time of the slow
rank beside the median of the others. Ends with 1 where the files differ, or where the slow rank was not slow: it must have used less than
half of what the others did. Times are printed, never judged.
"""

import argparse
import hashlib
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

from kills import BODY, CAMPAIGN, MPI, SMALL

PERIOD_S = 0.1  # of one stop and one turn


def environment_of(pid):
    try:
        text = pathlib.Path(f"/proc/{pid}/environ").read_bytes()
    except OSError:
        return {}
    return dict(entry.split(b"=", 1) for entry in text.split(b"\0") if b"=" in entry)


def ranks_of(mark):
    """Process of each rank, by the environment that the launcher gives it."""
    found = {}
    for entry in pathlib.Path("/proc").iterdir():
        if entry.name.isdigit():
            variables = environment_of(entry.name)
            if variables.get(b"SLOW_RANK_RUN") == mark.encode() and b"OMPI_COMM_WORLD_RANK" in variables:
                found[int(variables[b"OMPI_COMM_WORLD_RANK"])] = int(entry.name)
    return found


def cpu_s(pid):
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="ascii").rpartition(")")[2].split()
    except OSError:
        return None
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def hold_up(pid, share, over):
    try:
        while not over.is_set():
            os.kill(pid, signal.SIGSTOP)
            over.wait(PERIOD_S * (1 - share))
            os.kill(pid, signal.SIGCONT)
            over.wait(PERIOD_S * share)
    except ProcessLookupError:
        return
    finally:
        try:
            os.kill(pid, signal.SIGCONT)
        except ProcessLookupError:
            pass


def run(program, campaign, output, arguments, slowed):
    """Wall time, CPU time by rank, and the digest of the file."""
    mark = f"{os.getpid()}-{output.name}"
    share = min(1, len(os.sched_getaffinity(0)) / arguments.ranks) / arguments.times
    command = [arguments.mpirun, "--oversubscribe", "-n", str(arguments.ranks), program, "run", str(campaign), "-o", str(output)]
    begin = time.monotonic()
    with subprocess.Popen(command, env={**os.environ, **MPI, "OMPI_MCA_mpi_yield_when_idle": "1", "SLOW_RANK_RUN": mark},
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as launched:
        over, holder, used, ranks = threading.Event(), None, {}, {}
        while launched.poll() is None:
            if len(ranks) < arguments.ranks:
                ranks = ranks_of(mark)
            if slowed and holder is None and arguments.slow in ranks:
                if time.monotonic() - begin < arguments.after:
                    time.sleep(0.02)
                    continue
                holder = threading.Thread(target=hold_up, args=(ranks[arguments.slow], share, over))
                holder.start()
            for rank, pid in ranks.items():
                seconds = cpu_s(pid)
                used[rank] = used.get(rank, 0) if seconds is None else seconds
            time.sleep(0.02)
        over.set()
        if holder:
            holder.join()
        wall = time.monotonic() - begin
        if launched.returncode != 0:
            sys.exit(f"the run ended with {launched.returncode}: {launched.stderr.read()}")
    return wall, used, hashlib.sha256(output.read_bytes()).hexdigest()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--mpirun", default="mpirun")
    parser.add_argument("--waves", type=int, default=32768)
    parser.add_argument("--ranks", type=int, default=8)
    parser.add_argument("--slow", type=int, default=5)
    parser.add_argument("--times", type=float, default=20)
    parser.add_argument("--after", type=float, default=1)
    parser.add_argument("--pairs", type=int, default=3)
    arguments = parser.parse_args()
    walls, digests, failed = {False: [], True: []}, set(), False
    with tempfile.TemporaryDirectory() as folder:
        campaign = pathlib.Path(folder, "campaign.toml")
        campaign.write_text(CAMPAIGN.format(**SMALL | {"waves": arguments.waves, "body": BODY}), encoding="utf-8")
        for pair in range(arguments.pairs):
            for slowed in (False, True):
                wall, used, digest = run(arguments.program, campaign, pathlib.Path(folder, f"{pair}{'slow' if slowed else 'equal'}.h5"),
                                         arguments, slowed)
                walls[slowed].append(wall)
                digests.add(digest)
                others = statistics.median(seconds for rank, seconds in used.items() if rank != arguments.slow)
                own = used.get(arguments.slow, 0)
                print(f"{'one slow' if slowed else 'all equal'}: {wall:.1f} s; CPU time of rank {arguments.slow} {own:.2f} s,"
                      f" of the others {others:.2f} s (median)", flush=True)
                failed |= slowed and own >= others / 2
    equal, slow = statistics.median(walls[False]), statistics.median(walls[True])
    print(f"{arguments.ranks} ranks, one {arguments.times:g} times slower: {slow:.1f} s, all equal {equal:.1f} s ({100 * (slow / equal - 1):+.0f} %)")
    if len(digests) != 1:
        sys.exit("the files differ")
    if failed:
        sys.exit("the slow rank was not slow")


main()
