#!/usr/bin/env python3
"""Requirement R-1303: a large campaign from end to end: wall time, CPU time, peak memory and bytes of each phase.

    ten_million.py PROGRAM [--trials N] [--levels N] [--ranks N --mpirun MPIRUN] [--folder DIR] [--extend] [--rates]

Two rigid bodies at --levels levels under so many waves that there are --trials trials: 10^7 by default, which need 15 GB of disk
below --folder, where everything is removed again. run leaves its blocks, then follow merge, status, fit, report, replay of the last
trial and verify of a sample; with --extend, one hundredth more waves are added to the finished file. CPU time and memory are those of
the processes of a phase, memory of the largest one. Bytes read and written are those that the processes asked the kernel for, from disk
or from its memory. --rates measures how fast this machine reads, hashes and writes one file, one after the other, for arithmetic beyond.
Ends with 1 where a phase fails, or status counts other than --trials."""

import argparse
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

CAMPAIGN = """seed = 7
title = 'End to end'
[waves]
source = 'spectrum-compatible'
count = {waves}
duration = '2.56 s'
time_step = '0.025 s'
match = 'none'
[waves.target]
spectrum = 'mlit-ch1'
longest = '2 s'
time_scale = 0.632
[waves.envelope]
shape = 'jennings'
rise = '0.5 s'
level_end = '1.5 s'
end = '2.4 s'
[[bodies]]
name = 'narrow'
mass = '12.6 t'
base_width = '0.9 m'
centre_height = '1.045 m'
inertia = 'uniform-block'
[[bodies]]
name = 'wide'
mass = '12.6 t'
base_width = '1.36 m'
centre_height = '1.045 m'
inertia = 'uniform-block'
[levels]
measure = 'pga'
values = {{from = '200 gal', to = '1400 gal', count = {levels}}}
"""
BODIES = 2
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
       "OMPI_MCA_hwloc_base_binding_policy": "none"}


def bytes_below(folder):
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def moved():
    """Bytes that this process and those it has waited for (and those these waited for) have read and written so far."""
    counts = dict(line.split(": ") for line in pathlib.Path("/proc/self/io").read_text().splitlines())
    return int(counts["rchar"]), int(counts["wchar"])


class Phases:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.told = ""  # by the last phase

    def run(self, name, arguments, launcher=()):
        """One line of the table."""
        with open(self.folder / "told", "w+b") as told, open(self.folder / "errors", "w+b") as errors:
            begin, before = time.monotonic(), moved()
            process = subprocess.Popen([*launcher, self.program, *arguments], cwd=self.folder, stdout=told, stderr=errors,
                                       env=os.environ | MPI)
            _, state, used = os.wait4(process.pid, 0)
            wall_s = time.monotonic() - begin
            read, written = (after - earlier for after, earlier in zip(moved(), before))
            process.returncode = os.waitstatus_to_exitcode(state)
            told.seek(0)
            self.told = told.read().decode()
            if process.returncode != 0:
                errors.seek(0)
                sys.stderr.write(errors.read().decode())
                raise SystemExit(f"{name} ended with {process.returncode}")
        (self.folder / "told").unlink()
        (self.folder / "errors").unlink()
        print(f"| `{name}` | {wall_s:.1f} s | {used.ru_utime + used.ru_stime:.1f} s | {used.ru_maxrss / 1024:.0f} MB | "
              f"{read / 1e9:.3g} GB | {written / 1e9:.3g} GB | {bytes_below(self.folder) / 1e9:.2f} GB |", flush=True)


def rates(folder, size):
    """GB/s of writing a file, reading it again and hashing it, once each."""
    block = os.urandom(1 << 20)
    count = max(1, size >> 20)
    begin = time.monotonic()
    with open(folder / "rates", "wb") as file:
        for _ in range(count):
            file.write(block)
        file.flush()
        os.fsync(file.fileno())
    written = time.monotonic()
    with open(folder / "rates", "rb", buffering=0) as file:
        while file.read(1 << 20):
            pass
    read = time.monotonic()
    digest = hashlib.sha256()
    for _ in range(count):
        digest.update(block)
    hashed = time.monotonic()
    (folder / "rates").unlink()
    gigabytes = count * (1 << 20) / 1e9
    print(f"\n{gigabytes:.2f} GB: written and synced at {gigabytes / (written - begin):.2f} GB/s, read again (mostly from memory) at "
          f"{gigabytes / (read - written):.2f} GB/s, SHA-256 at {gigabytes / (hashed - read):.2f} GB/s")


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("program")
    options.add_argument("--trials", type=int, default=10_000_000)
    options.add_argument("--levels", type=int, default=50)
    options.add_argument("--ranks", type=int, default=1)
    options.add_argument("--mpirun", default="mpirun")
    options.add_argument("--folder", default=None)
    options.add_argument("--extend", action="store_true")
    options.add_argument("--rates", action="store_true")
    asked = options.parse_args()
    waves, rest = divmod(asked.trials, BODIES * asked.levels)
    if waves < 1 or rest != 0:
        raise SystemExit(f"--trials {asked.trials} is no multiple of {BODIES * asked.levels}, which a wave has")
    with tempfile.TemporaryDirectory(prefix="overturn-scale-", dir=asked.folder) as place:
        folder = pathlib.Path(place)
        (folder / "c.toml").write_text(CAMPAIGN.format(waves=waves, levels=asked.levels))
        phases = Phases(os.path.abspath(asked.program), folder)
        launcher = [asked.mpirun, "-n", str(asked.ranks)] if asked.ranks > 1 else []
        print(f"{asked.trials} trials ({waves} waves, {BODIES} bodies, {asked.levels} levels), {asked.ranks} ranks on {os.cpu_count()} "
              f"cores, load {os.getloadavg()[0]:.1f} before\n")
        print("| phase | wall time | CPU time | peak memory | read | written | on disk after |\n" + "|---" * 7 + "|")
        phases.run("run --leave-blocks", ["run", "c.toml", "-o", "c.h5", "--leave-blocks"], launcher)
        phases.run("merge", ["merge", "c.h5"], launcher)
        phases.run("status --json", ["status", "c.h5", "--json"])
        counted = json.loads(phases.told)["trials"]["done"]
        if counted != asked.trials:
            raise SystemExit(f"status counts {counted} trials")
        phases.run("fit", ["fit", "c.h5"])
        phases.run("report", ["report", "c.h5", "-o", "c.html"])
        phases.run("replay", ["replay", "c.h5", "--trial", str(asked.trials - 1)])
        phases.run("verify --sample 100", ["verify", "c.h5", "--sample", "100"])
        if asked.extend:
            more = waves + max(1, waves // 100)
            phases.run("run --extend", ["run", "c.toml", "-o", "c.h5", "--extend", "--set", f"waves.count={more}"], launcher)
            phases.run("status --json", ["status", "c.h5", "--json"])
            if json.loads(phases.told)["trials"]["done"] != more * BODIES * asked.levels:
                raise SystemExit("the extended file has other trials")
        print(f"\nload {os.getloadavg()[0]:.1f} after")
        if asked.rates:
            rates(folder, (folder / "c.h5").stat().st_size)
    return 0


if __name__ == "__main__":
    sys.exit(main())
