"""Requirement R-1101, R-1107: kills runs while they compute, extend and merge, and holds what is there against unbroken runs.

    kills.py PROGRAM [KILLS] [--mpirun MPIRUN] [--seed N] [--kinds KIND ...]

Campaigns are plain, packed (of more than 16 384 trials, with --packed), with a target that ends them, or with a rule that refuses waves.
Each round takes one of them through growth by waves, a body or levels: a finished file by --extend; the blocks of a killed run by
--resume; or by two parts and the verb merge (not of waves that a rule refuses: parts may have to be followed by a run). Every kill is SIGKILL, of all processes at once, of one rank, or of mpirun alone, at a
random instant of the run or of its merging. After each the finished file that was there must be there still, byte by byte, or be the
larger one; every block that was committed must be there still; and at the end the file must have the bytes of the larger campaign run
at once. Ends with 1 at the first loss.
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
{rule}[waves.target]
spectrum = 'mlit-ch1'
longest = '{longest}'
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
values = {levels}
{statistics}"""
BODY = """[[bodies]]
name = 'type-a'
mass = '12.6 t'
base_width = '1.36 m'
centre_height = '1.045 m'
inertia = 'uniform-block'
friction = 0.5
"""
FEW, MORE = "['300 gal', '600 gal', '1200 gal']", "['300 gal', '450 gal', '600 gal', '900 gal', '1200 gal']"
SMALL = {"waves": 12, "body": "", "levels": FEW, "rule": "match_iterations = 2\n", "longest": "6 s", "statistics": ""}
GROWTHS = {"waves": {"waves": 30}, "a body": {"body": BODY}, "levels": {"levels": MORE},
           "all of these": {"waves": 20, "body": BODY, "levels": MORE}}


def many_levels(count, step):
    return "[" + ", ".join(f"'{100 + step * place:.1f} gal'" for place in range(count)) + "]"


def target(half_width):
    return f"[statistics]\ntarget_half_width = {half_width}\n"


class Kind:
    """What campaigns of one kind have beside the others, and how they are run."""

    def __init__(self, small=None, growths=None, flags=(), parts=True):
        self.small = SMALL | (small or {})
        self.growths = GROWTHS if growths is None else growths
        self.flags, self.ways = list(flags), ["--extend", "--resume", *(["parts and merge"] if parts else [])]


# Of a target the first look is at 32 waves: with a smaller one more are needed, with the same none less.
KINDS = {
    "plain": Kind(),
    "packed": Kind({"waves": 12, "levels": many_levels(1400, 0.8)}, {"waves": {"waves": 20}, "a body": {"body": BODY},
                   "levels": {"levels": many_levels(2799, 0.4)}}, flags=["--packed"]),
    "target": Kind({"waves": 100, "statistics": target(0.3)},
                   {"waves": {"waves": 300, "statistics": target(0.12)}, "a body": {"body": BODY}, "levels": {"levels": MORE}}),
    "rule": Kind({"rule": "acceptance = 'japan'\n", "longest": "10 s"}, parts=False),
}
SHORT_S = 0.03  # that merging takes, and some blocks
LAUNCHER_ENDS_S = 30  # after its ranks
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


def works(pid):
    """Is the process there, and not one that has ended and waits for its parent?"""
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


class Kills:
    def __init__(self, program, mpirun, seed):
        self.program, self.mpirun, self.random = program, mpirun, random.Random(seed)
        self.count = collections.Counter()
        self.started = 0
        self.way, self.name, self.kind = "", "", None

    def launched(self, verb):
        """The command, on a random number of ranks where the verb has any."""
        ranks = self.random.randint(1, 3)
        alone = ranks == 1 or verb[0] == "merge" or not self.mpirun
        return [self.program, *verb] if alone else [self.mpirun, "-n", str(ranks), self.program, *verb]

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
        subprocess.run([*launch, self.program, "run", f"{campaign}.toml", "-o", name, *self.kind.flags], cwd=folder, check=True, capture_output=True,
                       env=self.environment(folder))
        return digest(folder / name), time.monotonic() - begin

    def wait(self, process, parts, merging, life_s):
        """Until a random instant of the run, of its blocks, or of its merging."""
        aim = self.random.choice((None, lambda: any(parts.glob("*.block")), merging.exists))
        if aim is None:
            time.sleep(life_s * self.random.random())
            return
        while process.poll() is None and not aim() and not merging.exists():
            time.sleep(0.001)
        time.sleep(SHORT_S * self.random.random())

    def kill_one(self, folder, verb, life_s, wanted):
        """Starts a run and kills it, if it has not ended before."""
        parts, merging, output = folder / "c.h5.parts", folder / "c.h5.merging", folder / "c.h5"
        process = subprocess.Popen(self.launched(verb), cwd=folder, env=self.environment(folder), stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait(process, parts, merging, life_s)
        ranks = children(process.pid) or [process.pid]
        victim = self.random.choice(("all", "one rank", "the launcher"))
        hit = process.poll() is None
        victims = {"all": [process.pid, *ranks], "one rank": [self.random.choice(ranks)], "the launcher": [process.pid]}[victim]
        for pid in victims:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        merges = merging.exists()
        self.wait_for_end(process, ranks)
        if hit:
            blocks = parts.exists() and any(parts.rglob("*.block"))
            phase = ("merging" if merges else "removing blocks" if digest(output) == wanted and parts.exists() else
                     "among blocks" if blocks else "before the first block, or after the end")
            self.count["kills"] += 1
            self.count[f"of {victim}"] += 1
            self.count[f"{self.name}, {self.way}: {phase}"] += 1

    def wait_for_end(self, process, ranks):
        """Until no rank works: they outlive a killed mpirun for some seconds. mpirun of Open MPI 4.1.4 may wait for ever for a lock of its
        own after one of its ranks was killed (1 of 150 runs, in PMIx_server_finalize): so it has a limit once all ranks are gone."""
        while any(works(rank) for rank in ranks if rank != process.pid):
            time.sleep(0.02)
        try:
            process.wait(timeout=LAUNCHER_ENDS_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            self.count["launchers that did not end by themselves"] += 1

    def loss(self, folder, before, wanted, known):
        """What is missing of the file that was there before and of the blocks that were known, which are then all that are there."""
        now = digest(folder / "c.h5")
        if now not in (before, wanted):
            return f"the file of before is gone or another one: {now}"
        after = blocks_in(folder / "c.h5.parts")
        lost = {name for key, name in known.items() if key not in after} if now != wanted else {}
        known.clear()
        known.update(after if now != wanted else {})
        return f"committed blocks are gone: {sorted(lost)}" if lost else ""

    def go_on(self, folder, verbs, wanted, before, life_s, kills):
        """Kills so many runs of each verb and lets one end; the last makes the file. \\return what was lost; empty: nothing."""
        known = blocks_in(folder / "c.h5.parts")
        for verb in verbs:
            for _ in range(kills):
                self.kill_one(folder, verb, life_s, wanted)
                lost = self.loss(folder, before, wanted, known)
                if lost:
                    return lost
            ended = subprocess.run(self.launched(verb), cwd=folder, env=self.environment(folder), stdin=subprocess.DEVNULL,
                                   capture_output=True, text=True)
            if ended.returncode != 0:
                return f"the run that goes on ends with {ended.returncode}: {ended.stderr[-500:]}"
            lost = self.loss(folder, before, wanted, known)
            if lost:
                return lost
        if digest(folder / "c.h5") != wanted:
            return "the file differs from that of the campaign run at once"
        left = [path.name for path in folder.glob("c.h5?*") if path.name != "c.h5.runtime.json"]
        return f"left behind: {left}" if left else ""

    def begin(self, folder, wholes):
        """Runs the small campaign as its way asks: to its end, or until it is killed among its blocks."""
        run = ["run", "small.toml", "-o", "c.h5", "--resume", *self.kind.flags]
        wanted, life_s = wholes["small"]
        if self.way == "--extend":
            return self.go_on(folder, [run], wanted, None, life_s, self.random.randint(0, 2))
        if self.way == "--resume":
            self.kill_one(folder, run, life_s, wanted)
            return self.loss(folder, None, wanted, {})
        return ""

    def wholes(self, folder):
        """The campaigns of this kind, each run at once: of one name in the file, whatever it was extended from."""
        found = {}
        for name, change in {"small": {}, **self.kind.growths}.items():
            (folder / f"{name}.toml").write_text(CAMPAIGN.format(**self.kind.small | change))
            found[name] = self.whole(folder, name, "whole.h5")
            (folder / "whole.h5").unlink()
        return found

    def of_kind(self, place, name, kills):
        """Rounds with campaigns of a kind until so many runs were killed. \return what was lost; empty: nothing"""
        folder = place / name
        folder.mkdir()
        self.name, self.kind = name, KINDS[name]
        wholes, before = self.wholes(folder), self.count["kills"]
        while self.count["kills"] < before + kills:
            lost = self.round(folder, wholes)
            print(f"{name}: {self.count['kills'] - before} of {kills} kills", file=sys.stderr)
            if lost:
                return f"{name}, {lost}"
        return ""

    def round(self, folder, wholes):
        self.way = self.random.choice(self.kind.ways)
        growth = self.random.choice(list(self.kind.growths))
        lost = self.begin(folder, wholes)
        if lost:
            return f"{self.way}, begun: {lost}"
        run = ["run", f"{growth}.toml", "-o", "c.h5", *self.kind.flags]
        if self.way == "parts and merge":
            verbs = [[*run, "--resume", "--part", "1/2"], [*run, "--resume", "--part", "2/2"], ["merge", "c.h5", *self.kind.flags]]
        else:  # a small run that was killed too late has made its file
            verbs = [[*run, "--extend" if self.way == "--extend" or (folder / "c.h5").exists() else "--resume"]]
        lost = self.go_on(folder, verbs, wholes[growth][0], digest(folder / "c.h5"), wholes[growth][1], self.random.randint(1, 3))
        if lost:
            return f"{self.way}, grown by {growth}: {lost}"
        for path in folder.glob("c.h5*"):
            path.unlink()
        return ""


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("program")
    options.add_argument("kills", type=int, nargs="?", default=6)
    options.add_argument("--mpirun", default="")
    options.add_argument("--seed", type=int, default=2013)
    options.add_argument("--kinds", nargs="+", choices=list(KINDS), default=["plain"])
    asked = options.parse_args()
    kills = Kills(os.path.abspath(asked.program), asked.mpirun, asked.seed)
    with tempfile.TemporaryDirectory(prefix="overturn-kills-") as place:
        for kind in asked.kinds:
            lost = kills.of_kind(pathlib.Path(place), kind, -(-asked.kills // len(asked.kinds)))
            if lost:
                print(f"LOST after {kills.count['kills']} kills: {lost}")
                return 1
    for key, number in sorted(kills.count.items()):
        print(f"{number:6} {key}")
    print(f"{kills.count['kills']} kills, nothing lost")
    return 0


if __name__ == "__main__":
    sys.exit(main())
