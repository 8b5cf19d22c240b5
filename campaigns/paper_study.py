"""A results file as the paper's page reads it, and the trials that its figure 11 shows, in a plane and in space."""

import csv
import math

import h5py
import numpy as np

GAL, KINE = 0.01, 0.01
PUBLISHED = (("type-a", 1406, "stood"), ("type-b", 892, "overturned"))  # under AW01: body, gal, how it ended
IN_SPACE = (("a-round-xy", 1100), ("b-round-xy", 900))  # body and level of campaigns/criterion_in_space.toml, next to those


class Study:
    """A results file, by body and level."""

    def __init__(self, path):
        self.file = h5py.File(path, "r")
        self.trials = self.file["trials"]
        kinds = h5py.check_enum_dtype(self.trials["verdict"].dtype)
        bodies = h5py.check_enum_dtype(self.trials["body"].dtype)
        self.bodies = [name for name, _ in sorted(bodies.items(), key=lambda item: item[1])]
        ends, self.body = self.trials["verdict"][()], self.trials["body"][()]
        self.is_ = {name: ends == value for name, value in kinds.items()}
        if "slid-and-rocked" in self.is_:  # here it is asked whether a body rocked, slid or not
            self.is_["rocked"] = self.is_["rocked"] | self.is_["slid-and-rocked"]
        self.amplitude = self.trials["amplitude"][()]

    def column(self, name):
        return self.trials[name][()]

    def number(self, body, name):
        """A property of the body [SI]."""
        return float(self.file[f"bodies/{body}/{name}"][0])

    def of(self, body):
        return self.body == self.bodies.index(body)

    def at(self, body, gal):
        """Its trials at one level."""
        return self.of(body) & (np.abs(self.amplitude - gal * GAL) < 1e-9)

    def fell(self, body):
        mine = self.of(body)
        return int(np.sum(self.is_["overturned"] & mine)), int(np.sum(mine))

    def stood(self):
        return self.is_["rocked"] | self.is_["at-rest"] | self.is_["slid"]

    def rocked(self, body, above=0):
        """The trials of a body that rocked and stood, under waves of a V_WES above this [m/s]: waves, V_WES, V_resp."""
        offered, answer = self.column("v_wes"), self.column("v_resp")
        moved = self.of(body) & self.is_["rocked"] & (offered > above) & (answer > 0)
        return self.column("wave")[moved], offered[moved], answer[moved]

    def before_the_most(self, body):
        """Of the trials of a body that fell: whether each falls before its wave offers most (V_WES)."""
        fell = self.of(body) & self.is_["overturned"]
        return self.column("overturn_time")[fell] < self.file[f"waves/{body}/v_wes_time"][()][self.column("wave")[fell]]

    def landings(self, body):
        """Angular velocity of what fell, when it lies, over that from balance at rest: potential energy alone."""
        alpha, p = (self.number(body, name) for name in ("alpha", "p"))
        spin = self.column("landing_spin")[self.of(body) & self.is_["overturned"]]
        return spin[np.isfinite(spin) & (spin > 0)] / (p * math.sqrt(2 * (1 - math.sin(alpha))))

    def pair(self, one, other):
        """For words.Pair: waves, and which trials of either body fell."""
        fell, waves = self.is_["overturned"], self.column("wave")
        return waves[self.of(one)], fell[self.of(one)], fell[self.of(other)]


def ended_as(study, published):
    return study.stood() if published == "stood" else study.is_[published]


def published_trials(folder):
    """Of figure 11: A at 1406 gal where it rocked furthest of what stood in the middle of the sample, B at 892 gal falling."""
    study = Study(folder / "published.h5")
    peak = study.column("peak_rotation_ratio")
    chosen = []
    for name, (body, gal, published) in zip(("figure_11_a", "figure_11_b"), PUBLISHED):
        level = study.at(body, gal)
        trials = np.flatnonzero(level & (study.is_["rocked"] if published == "stood" else study.is_[published]))
        if not len(trials):  # nothing ended as published under these waves
            trials = np.flatnonzero(level)
        ordered = trials[np.argsort(peak[trials], kind="stable")]
        chosen.append((name, int(ordered[len(ordered) // 2])))
    return chosen


def space_trials(folder):
    """Of figure 11 on a round rim under two components: of each body, at its level, one that falls."""
    study = Study(folder / "space.h5")
    chosen = []
    for name, (body, gal) in zip(("figure_11_space_a", "figure_11_space_b"), IN_SPACE):
        level = study.at(body, gal)
        trials = np.flatnonzero(level & study.is_["overturned"])
        trials = trials if len(trials) else np.flatnonzero(level)
        ordered = trials[np.argsort(study.column("overturn_time")[trials], kind="stable")]
        chosen.append((name, int(ordered[len(ordered) // 2])))
    return chosen


def steady_rotations(folder):
    """The largest rotation of the last steady 20 s of each sinusoid [rad], by study and wave; campaigns/paper.sh took them from
    the histories."""
    with open(folder / "steady.csv", encoding="utf-8", newline="") as file:
        return {(row["study"], int(row["wave"])): float(row["rotation_rad"] or math.nan) for row in csv.DictReader(file)}
