#!/usr/bin/env python3
"""Holds the program against real outcomes: judge.py PROGRAM DATASET.toml [--json OUT.json | --records FOLDER].

Every measured motion is run once under every body of a grid of what cannot be measured (alpha, restitution). Those bodies
that agree with the outcomes of all motions but one within a standard error of the best (Breiman et al. 1984) vote on that
one: the single best of them is chosen by chance (it misses specimen 2 by 5 % more). A motion is shaken at many strengths, so
that leaving out single tests would judge a body by the motion that chose it. Thresholds on PGA and PGV are chosen and judged
likewise. Intervals resample motions. --records only writes the motions as files, for campaigns/granite.toml. Exits with 77 where the data are missing: ../shared/experiments, or
OVERTURN_EXPERIMENTS."""

import csv
import hashlib
import json
import math
import os
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import h5py
import numpy as np

RESAMPLES = 2000
BINS = 6  # of PGV, of equally many tests
MEASURES = ["v_wes", "v_wes, R in m", "ou_v_e", "ou_v_e, R in m", "pgv", "pga", "peak energy"]


def missing(why):
    print(f"validation: {why} (set OVERTURN_EXPERIMENTS to the folder of experiments)")
    sys.exit(77)


def data_of(dataset):
    place = os.environ.get("OVERTURN_EXPERIMENTS") or Path(__file__).resolve().parents[4] / "shared" / "experiments"
    folder = Path(place) / dataset["folder"]
    if not folder.is_dir():
        missing(f"no {folder}")
    for name, digest in dataset["files"].items():
        found = hashlib.sha256((folder / name).read_bytes()).hexdigest()
        if found != digest:
            sys.exit(f"validation: {folder / name} is not the file that this data set names ({found}). Get it again")
    return folder


def records(dataset, folder, to, tests):
    """Writes the motions as the program reads them. Returns their names."""
    motions, files = dataset["motions"], []
    accelerations = np.load(folder / "motions.npz")
    for test in tests:
        values = accelerations[f"t{int(test['test']):03d}"]
        files.append(f"t{int(test['test']):03d}.csv")
        with open(to / files[-1], "w", encoding="ascii") as file:
            file.write(f"time_s,acc ({motions['unit']})\n")
            file.writelines(f"{motions['step_s'] * i:.3f},{a:.6g}\n" for i, a in enumerate(values))
    return files


def campaign(dataset, folder, scratch, tests):
    """Writes records and campaign. Returns the grid, a pair of alpha and restitution for each body in their order."""
    motions, block = dataset["motions"], dataset["block"]
    files = records(dataset, folder, scratch, tests)
    grid = [(alpha, e) for alpha in dataset["fitted"]["alpha"] for e in dataset["fitted"]["restitution"]]
    text = [f"title = {json.dumps(dataset['title'])}\nseed = 1\n[waves]\nsource = 'records'\nfiles = {json.dumps(files)}",
            "baseline = {high_pass = '%s'}" % motions["corner"]]
    for number, (alpha, e) in enumerate(grid):
        text.append(f"[[bodies]]\nname = 'b{number:03d}'\nmass = {block['mass_kg']}\n"
                    f"base_width = {2 * block['centre_height_m'] * math.tan(alpha):.9g}\n"
                    f"centre_height = {block['centre_height_m']}\ninertia = 'uniform-block'" + (f"\nrestitution = {e}" if e else ""))
    text.append("[levels]\nmeasure = 'factor'\nvalues = [1]\n[measures]\nboth_radius_units = true\nwave_quality = false\n")
    (scratch / "experiment.toml").write_text("\n".join(text), encoding="ascii")
    return grid


def run(program, scratch):
    ended = subprocess.run([program, "run", "experiment.toml", "-o", "experiment.h5"], cwd=scratch, capture_output=True, text=True,
                           check=False)
    if ended.returncode != 0:
        sys.exit(f"validation: the campaign did not run: {ended.stderr.strip()}")
    return h5py.File(scratch / "experiment.h5")


class Results:
    """What the program says: columns by test and body."""

    def __init__(self, file, tests, bodies):
        shape = (tests, bodies)
        trials = file["trials"]
        verdicts = {name: value for name, value in h5py.check_enum_dtype(trials["verdict"].dtype).items()}
        self.fell = trials["verdict"][()].reshape(shape) == verdicts["overturned"]
        self.energy = trials["peak_energy_ratio"][()].reshape(shape)
        self.pga, self.pgv = file["waves/pga"][()], file["waves/pgv"][()]
        names = [f"b{b:03d}" for b in range(bodies)]
        self.limit = np.array([file[f"bodies/{name}/v_ereq"][0] for name in names])
        self.measured = {key: np.array([file[f"waves/{name}/{column}"][()] for name in names]).T
                         for key, column in (("v_wes", "v_wes"), ("v_wes, R in m", "v_wes_other_unit"), ("ou_v_e", "ou_v_e"),
                                             ("ou_v_e, R in m", "ou_v_e_other_unit"))}

    def by(self, measure, bodies):
        """One number a test: what orders the tests, over what the bodies can bear, as their geometric mean."""
        if measure in ("pga", "pgv"):
            return {"pga": self.pga, "pgv": self.pgv}[measure]
        ratios = self.energy if measure == "peak energy" else self.measured[measure] / self.limit
        return np.log(np.maximum(ratios[:, bodies], 1e-9)).mean(1)


class Area:
    """Chance that a motion which overturned the block has more of x than one which did not (Mann and Whitney 1947)."""

    def __init__(self, x, fell):
        self.fell = fell
        one, other = x[fell][:, None], x[~fell][None, :]
        self.above = (one > other) + 0.5 * (one == other)

    def __call__(self, indices):
        weight = np.bincount(indices, minlength=len(self.fell)).astype(float)
        fell, stood = weight[self.fell], weight[~self.fell]
        return fell @ self.above @ stood / (fell.sum() * stood.sum()) if fell.any() and stood.any() else math.nan


def counted(predicted, fell):
    """False safe first: it fell and was said to stand."""
    return {"false_safe": int((~predicted & fell).sum()), "false_alarm": int((predicted & ~fell).sum()),
            "safe": int((~predicted & ~fell).sum()), "fell": int((predicted & fell).sum()),
            "agreement": float((predicted == fell).mean())}


def left_out(motions, choose, predict):
    """For every test what the other motions choose says of it."""
    said, chosen = np.zeros(len(motions)), []
    for motion in sorted(set(motions)):
        out = motions == motion
        chosen.append(choose(~out))
        said[out] = predict(chosen[-1])[out]
    return said, chosen


def as_good_as_the_best(agreement):
    """Bodies whose agreement with these tests is within a standard error of the best."""
    share = agreement.mean(0)
    best = share.max()
    return np.flatnonzero(share >= best - math.sqrt(best * (1 - best) / len(agreement)))


def best_threshold(x, fell):
    at = np.sort(x)
    return at[int(np.argmax([((x > t) == fell).mean() for t in at]))]


def interval(motions, value, random):
    """95 %, motions resampled with all their tests."""
    groups = [np.flatnonzero(motions == motion) for motion in sorted(set(motions))]
    found = [value(np.concatenate([groups[g] for g in random.integers(0, len(groups), len(groups))])) for _ in range(RESAMPLES)]
    return [float(end) for end in np.nanpercentile(found, [2.5, 97.5])]


def judge(results, grid, motions, fell, others, random):
    agreement = results.fell == fell[:, None]

    def vote(votes):
        return left_out(motions, lambda kept: as_good_as_the_best(agreement[kept]), lambda bodies: votes[:, bodies].mean(1))
    chance, chosen = vote(results.fell)
    predicted = chance > 0.5
    everyone, near = np.arange(len(fell)), as_good_as_the_best(agreement)
    said = {"tests": len(fell), "falls": int(fell.sum()), "motions": len(set(motions)),
            "voters": [[*grid[b], sum(b in bodies for bodies in chosen)] for b in sorted(set(np.concatenate(chosen)))],
            "by_time_history": counted(predicted, fell),
            "agreement_interval": interval(motions, lambda i: (predicted[i] == fell[i]).mean(), random),
            "false_safe_interval": interval(motions, lambda i: (~predicted[i] & fell[i]).mean(), random)}
    for measure, x in (("pgv", results.pgv), ("pga", results.pga)):
        by, _ = left_out(motions, lambda kept, x=x: best_threshold(x[kept], fell[kept]), lambda t, x=x: x > t)
        said[f"by_threshold_on_{measure}"] = counted(by > 0.5, fell)
    said["by_others"] = counted(others, fell)
    said["areas"] = {}
    for measure in MEASURES:
        area = Area(results.by(measure, near), fell)
        said["areas"][measure] = [float(area(everyone)), *interval(motions, area, random)]
    said["criteria"] = {}
    for measure, x in results.measured.items():
        unsafe = vote(x >= results.limit)[0] > 0.5
        said["criteria"][measure] = {**counted(unsafe, fell), "by_alpha": [
            [alpha, int((x[:, b] < results.limit[b]).sum()), int(((x[:, b] < results.limit[b]) & fell).sum())]
            for b, (alpha, e) in enumerate(grid) if e == 0]}
    edges = np.quantile(results.pgv, np.linspace(0, 1, BINS + 1))
    said["bins"] = []
    for low, high in zip(edges[:-1], edges[1:]):
        inside = (results.pgv >= low) & ((results.pgv < high) | (high == edges[-1]))
        said["bins"].append([float(low), float(high), int(inside.sum()), int(fell[inside].sum()), float(chance[inside].sum())])
    share = fell.mean()
    said["brier"] = {"time_history": float(((chance - fell) ** 2).mean()), "always_the_share": float(share * (1 - share))}
    said["reliability"] = [[float(low), int(inside.sum()), int(fell[inside].sum())] for low in (0, 0.2, 0.4, 0.6, 0.8)
                           for inside in [(chance >= low) & ((chance < low + 0.2) | (low == 0.8))]]
    return said


def tell(name, said):
    c, low, high = said["by_time_history"], *said["agreement_interval"]
    print(f"{name}: {said['falls']} falls in {said['tests']} tests of {said['motions']} motions, each predicted by the others")
    print(f"  {'':28} false safe  false alarm  agreement")
    for what, key in (("time history", "by_time_history"), ("threshold on PGV", "by_threshold_on_pgv"),
                      ("threshold on PGA", "by_threshold_on_pga"), ("discrete elements of others", "by_others")):
        print(f"  {what:28} {said[key]['false_safe']:10} {said[key]['false_alarm']:12} {said[key]['agreement']:10.3f}")
    print(f"  agreement of the time history {c['agreement']:.3f} [{low:.3f}, {high:.3f}], false safe "
          f"{c['false_safe'] / said['tests']:.3f} [{said['false_safe_interval'][0]:.3f}, {said['false_safe_interval'][1]:.3f}]")
    print("  voters: " + ", ".join(f"alpha {a:g} e {e or 'Housner'} ({k} times)" for a, e, k in said["voters"]))
    print("  area under the curve: " + ", ".join(f"{m} {v:.3f} [{l:.3f}, {h:.3f}]" for m, (v, l, h) in said["areas"].items()))
    for measure, k in said["criteria"].items():
        safe = k["false_safe"] + k["safe"]
        print(f"  {measure} < V_Ereq calls {safe} safe, of which {k['false_safe']} fell; alpha (safe/fell), Housner: "
              + ", ".join(f"{a:g} ({s}/{f})" for a, s, f in k["by_alpha"]))
    print("  PGV [m/s]: " + ", ".join(f"{l:.2f}-{h:.2f} {f}/{n} fell, {p:.0f} predicted" for l, h, n, f, p in said["bins"]))
    print("  predicted chance from 0, .2, .4, .6, .8 on: " + ", ".join(f"{f}/{n} fell" for _, n, f in said["reliability"]))
    print(f"  Brier score {said['brier']['time_history']:.3f} (the share of falls for every test: {said['brier']['always_the_share']:.3f})")


def main():
    program, path = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    dataset = tomllib.loads(path.read_text(encoding="utf-8"))
    folder = data_of(dataset)
    with open(folder / "outcomes.csv", encoding="utf-8", newline="") as file:
        tests = list(csv.DictReader(file))
    if "--records" in sys.argv:
        to = Path(sys.argv[sys.argv.index("--records") + 1])
        to.mkdir(parents=True, exist_ok=True)
        records(dataset, folder, to, tests)
        return
    motions = np.array([test["motion"].strip("'").removesuffix(".xlsx") for test in tests])
    told = {"title": dataset["title"], "doi": dataset["doi"], "specimens": {}}
    with tempfile.TemporaryDirectory() as scratch:
        grid = campaign(dataset, folder, Path(scratch), tests)
        with run(program, Path(scratch)) as file:
            results = Results(file, len(tests), len(grid))
    random = np.random.default_rng(1)
    for specimen in dataset["specimens"]:
        fell = np.array([test[specimen["outcome"]] == "1" for test in tests])
        others = np.array([test[specimen["predicted_by_others"]] == "1" for test in tests])
        told["specimens"][specimen["name"]] = judge(results, grid, motions, fell, others, random)
        tell(specimen["name"], told["specimens"][specimen["name"]])
    if "--json" in sys.argv:
        Path(sys.argv[sys.argv.index("--json") + 1]).write_text(json.dumps(told, indent=1), encoding="utf-8")
    wrong = [f"{name}: {what}" for name, said in told["specimens"].items() for what, holds in (
        ("the time history agrees no better than a threshold on PGV",
         said["by_time_history"]["agreement"] > said["by_threshold_on_pgv"]["agreement"]),
        ("more than a tenth of the tests is false safe", said["by_time_history"]["false_safe"] <= 0.1 * said["tests"]),
        ("V_WES orders outcomes no better than PGA", said["areas"]["v_wes"][0] > said["areas"]["pga"][0])) if not holds]
    for line in wrong:
        print(f"validation: {line}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
