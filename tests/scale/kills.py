"""Requirement R-1101, R-1107: kills runs at random instants while they compute, extend and merge, and holds what is there against unbroken runs.

    kills.py PROGRAM [KILLS] [--mpirun MPIRUN] [--seed N]

Each round takes one campaign through growth: begun with some waves, killed, gone on with, then extended by waves, a body or
levels, killed again, until it is complete. Every kill is SIGKILL, of all processes at once, of one rank, or of mpirun alone. After
each the finished file that was there must be there still, byte by byte, or be the larger one; every block that was committed
must be there still; and at the end the file must have the bytes of the larger campaign run at once. Ends with 1 at the first loss.
"""

import argparse
import collections
import hashlib
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

CAMPAIGN = """seed = 11
[waves]
source = 'spectrum-compatible'
count = {waves}
duration = '20.48 s'
time_step = '0.02 s'
match = 'each'
match_iterations = 2
[waves.target]
spectrum = 'mlit-ch1'
longest = '6 s'
time_scale = 0.632
[waves.envelope]
shape = 'jennings'
rise = '2 s'
level_end = '10 s'
end = '18 s'
[[bodies]]
name = 'type-b'
mass = '12.6 t'
base_width = '0.9 m'
centre_height = '1.045 m'
inertia = 'uniform-block'
{body}[levels]
measure = 'pga'
values = [{levels}]
"""
BODY = """[[bodies]]
name = 'type-a'
mass = '12.6 t'
base_width = '1.36 m'
centre_height = '1.045 m'
inertia = 'uniform-block'
friction = 0.5
"""
FEW, MORE = "'300 gal', '600 gal', '1200 gal'", "'300 gal', '450 gal', '600 gal', '900 gal', '1200 gal'"
SMALL = {"waves": 12, "body": "", "levels": FEW}
GROWTHS = {"waves": {"waves": 30}, "a body": {"body": BODY}, "levels": {"levels": MORE},
           "all of these": {"waves": 20, "body": BODY, "levels": MORE}}
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
       "OMPI_MCA_hwloc_base_binding_policy": "none", "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self,vader"}


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.exists() else None


def blocks_in(folder):
    """Committed blocks below a folder of blocks, those set aside too, with what they hold."""
    found = {}
    for path in folder.rglob("*.block"):
        try:
            found[hashlib.sha256(path.read_bytes()).hexdigest()] = path.name
        except FileNotFoundError:  # merged and removed meanwhile
            pass
    return found


def children(parent):
    found = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(stat.read_text().rsplit(")", 1)[1].split()[1]) == parent:
                found.append(int(stat.parent.name))
        except (OSError, IndexError):
            pass
    return found


class Kills:
    def __init__(self, program, mpirun, seed):
        self.program, self.mpirun, self.random = program, mpirun, random.Random(seed)
        self.count = collections.Counter()
        self.started = 0

    def command(self, folder, campaign, *more):
        run = [self.program, "run", f"{campaign}.toml", "-o", "c.h5", *more]
        ranks = self.random.randint(1, 3)
        return run if ranks == 1 or not self.mpirun else [self.mpirun, "-n", str(ranks), *run]

    def environment(self, folder):
        """mpirun's own files go into a place of their own: what a killed one leaves can keep the next from starting."""
        self.started += 1
        place = folder / f"mpirun-{self.started}"
        place.mkdir()
        places = {name: str(place) for name in ("TMPDIR", "OMPI_MCA_btl_vader_backing_directory", "OMPI_MCA_osc_sm_backing_directory")}
        return os.environ | MPI | places

    def whole(self, folder, campaign, name):
        """The bytes of the campaign run at once, and how long that takes."""
        begin = time.monotonic()
        launch = [self.mpirun, "-n", "2"] if self.mpirun else []
        subprocess.run([*launch, self.program, "run", f"{campaign}.toml", "-o", name], cwd=folder, check=True, capture_output=True,
                       env=self.environment(folder))
        return digest(folder / name), time.monotonic() - begin

    def kill_one(self, folder, campaign, life_s):
        """Starts a run and kills it; true if there was something to kill."""
        process = subprocess.Popen(self.command(folder, campaign, "--extend"), cwd=folder, env=self.environment(folder),
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(life_s * self.random.random())
        ranks = children(process.pid) or [process.pid]
        victim = self.random.choice(("all", "one rank", "the launcher"))
        hit = process.poll() is None
        victims = {"all": [process.pid, *ranks], "one rank": [self.random.choice(ranks)], "the launcher": [process.pid]}[victim]
        for pid in victims:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        parts, merging = folder / "c.h5.parts", folder / "c.h5.merging"
        when = "while merging" if merging.exists() else "among blocks" if blocks_in(parts) else "elsewhere"
        process.wait()
        for rank in ranks:  # they outlive a killed mpirun for some seconds
            while pathlib.Path(f"/proc/{rank}").exists() and time.sleep(0.02) is None:
                pass
        if hit:
            self.count["kills"] += 1
            self.count[f"of {victim}"] += 1
            self.count[when] += 1
        return hit

    def go_on(self, folder, campaign, wanted, before, life_s, kills):
        """Kills so many runs of the campaign and lets one end. \\return what was lost; empty: nothing."""
        parts, output = folder / "c.h5.parts", folder / "c.h5"
        known = blocks_in(parts)
        for _ in range(kills):
            self.kill_one(folder, campaign, life_s)
            now = digest(output)
            if now not in (before, wanted):
                return f"the file of before is gone or another one: {now}"
            if now == wanted:
                known = {}
                continue
            after = blocks_in(parts)
            lost = {name for key, name in known.items() if key not in after}
            if lost:
                return f"committed blocks are gone: {sorted(lost)}"
            known = after
        ended = subprocess.run(self.command(folder, campaign, "--extend"), cwd=folder, env=self.environment(folder),
                               stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if ended.returncode != 0:
            return f"the run that goes on ends with {ended.returncode}: {ended.stderr[-500:]}"
        if digest(output) != wanted:
            return "the file differs from that of the campaign run at once"
        if parts.exists():
            return f"left behind: {[path.name for path in parts.rglob('*')]}"
        return ""

    def round(self, folder, kinds, wholes):
        growth = self.random.choice(kinds)
        first = self.go_on(folder, "small", wholes["small"][0], None, wholes["small"][1], self.random.randint(0, 2))
        if first:
            return f"begun: {first}"
        then = self.go_on(folder, growth, wholes[growth][0], wholes["small"][0], wholes[growth][1], self.random.randint(1, 4))
        (folder / "c.h5").unlink(missing_ok=True)
        self.count[f"grown by {growth}"] += 1
        return f"grown by {growth}: {then}" if then else ""


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("program")
    options.add_argument("kills", type=int, nargs="?", default=6)
    options.add_argument("--mpirun", default="")
    options.add_argument("--seed", type=int, default=2013)
    asked = options.parse_args()
    kills = Kills(os.path.abspath(asked.program), asked.mpirun, asked.seed)
    with tempfile.TemporaryDirectory(prefix="overturn-kills-") as place:
        folder = pathlib.Path(place)
        (folder / "small.toml").write_text(CAMPAIGN.format(**SMALL))
        for name, change in GROWTHS.items():
            (folder / f"{name}.toml").write_text(CAMPAIGN.format(**SMALL | change))
        wholes = {}
        for name in ["small", *GROWTHS]:
            # Of one name in the file, whatever it was extended from.
            wholes[name] = kills.whole(folder, name, "whole.h5")
            (folder / "whole.h5").unlink()
        while kills.count["kills"] < asked.kills:
            lost = kills.round(folder, list(GROWTHS), wholes)
            print(f"{kills.count['kills']} of {asked.kills} kills", file=sys.stderr)
            if lost:
                print(f"LOST after {kills.count['kills']} kills: {lost}")
                return 1
    print(", ".join(f"{key} {number}" for key, number in sorted(kills.count.items())))
    print(f"{kills.count['kills']} kills, nothing lost")
    return 0


if __name__ == "__main__":
    sys.exit(main())
