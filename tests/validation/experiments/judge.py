#!/usr/bin/env python3
"""Holds the program against real outcomes: judge.py PROGRAM DATASET.toml [--json OUT.json | --records FOLDER].

Every measured motion is run once under every body of a grid of what cannot be measured (alpha, restitution); those that agree
with the outcomes of all motions but one as well as the best do vote on that one (the single best of them is chosen by
chance: it misses specimen 2 by 5 % more). Thresholds on PGA and PGV are chosen and judged likewise. How it is judged stands in
overturn/report/outcomes.py of the package, which the program's own page uses too. What hangs on the height that is assumed is
shown beside it, by bodies that take no part. Whether V_WES gains from the body's own periods is judged by own_period.py. --records only writes the motions as files, and outcomes.csv for `overturn report --outcomes`, for
campaigns/granite.toml. Exits with 77 where the data are missing: ../shared/experiments, or OVERTURN_EXPERIMENTS."""

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

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "src" / "report"))
import own_period  # noqa: E402
from overturn.report import outcomes  # noqa: E402

GRAVITY = 9.80665

MEASURED = {"v_wes": "v_wes", "v_wes_other_unit": "v_wes, R in m", "ou_v_e": "ou_v_e", "ou_v_e_other_unit": "ou_v_e, R in m"}
SHOWN = ("v_wes", "v_wes, R in m", "ou_v_e", "ou_v_e, R in m", "pgv", "pga", "peak energy")


def motion_of(test):
    return test["motion"].strip("'").removesuffix(".xlsx")


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


def grid_of(dataset):
    """Bodies: (height, alpha, restitution); those at the assumed height first, which vote."""
    fitted, height = dataset["fitted"], dataset["block"]["centre_height_m"]
    others = [h for h in dataset["sensitivity"]["centre_height_m"] if h != height]
    return ([(height, alpha, e) for alpha in fitted["alpha"] for e in fitted["restitution"]]
            + [(h, alpha, 0) for h in others for alpha in fitted["alpha"]])


def periods_of(dataset):
    """T1 that bodies which only measure stand for: of every phi and alpha at the assumed height, then of the scans."""
    height, fitted = dataset["block"]["centre_height_m"], dataset["fitted"]
    own = [own_period.period_times_p(alpha, phi) / math.sqrt(0.75 * GRAVITY * math.cos(alpha) / height)
           for phi in dataset["own_period"]["phi"] for alpha in fitted["alpha"]]
    scans = own_period.scans(dataset["own_period"]["scan"], GRAVITY)
    return own + [scan[key] for scan in scans for key in ("fixed_t1_s", "own_t1_s")]


def measuring(period_s):
    """A body of this T1 that no motion here moves."""
    alpha, radius = 1.5, own_period.radius_m(period_s)
    return (f"base_width = {2 * radius * math.sin(alpha):.12g}\ncentre_height = {radius * math.cos(alpha):.12g}\n"
            "restitution = 0.5")


def campaign(dataset, folder, scratch, tests):
    """Writes records and campaign. Returns its bodies."""
    motions, block = dataset["motions"], dataset["block"]
    files = records(dataset, folder, scratch, tests)
    grid = grid_of(dataset)
    text = [f"title = {json.dumps(dataset['title'])}\nseed = 1\n[waves]\nsource = 'records'\nfiles = {json.dumps(files)}",
            "baseline = {high_pass = '%s'}" % motions["corner"]]
    for number, (height, alpha, e) in enumerate(grid):
        text.append(f"[[bodies]]\nname = 'b{number:03d}'\nmass = {block['mass_kg']}\n"
                    f"base_width = {2 * height * math.tan(alpha):.9g}\n"
                    f"centre_height = {height}\ninertia = 'uniform-block'" + (f"\nrestitution = {e}" if e else ""))
    for number, period_s in enumerate(periods_of(dataset)):
        text.append(f"[[bodies]]\nname = 't{number:03d}'\nmass = 1\ninertia = 'uniform-block'\n{measuring(period_s)}")
    text.append("[levels]\nmeasure = 'factor'\nvalues = [1]\n[measures]\nboth_radius_units = true\nwave_quality = false\n")
    (scratch / "experiment.toml").write_text("\n".join(text), encoding="ascii")
    return grid


def run(program, scratch):
    ended = subprocess.run([program, "run", "experiment.toml", "-o", "experiment.h5"], cwd=scratch, capture_output=True, text=True,
                           check=False)
    if ended.returncode != 0:
        sys.exit(f"validation: the campaign did not run: {ended.stderr.strip()}")
    return h5py.File(scratch / "experiment.h5")


def tests_of(file, count, bodies):
    """What the program says: columns by test and body, as outcomes.judge takes them."""
    trials = file["trials"]
    verdicts = h5py.check_enum_dtype(trials["verdict"].dtype)
    names = [f"b{b:03d}" for b in range(bodies)]
    return {"fell": (trials["verdict"][()] == verdicts["overturned"]).reshape(count, -1)[:, :bodies],
            "energy": trials["peak_energy_ratio"][()].reshape(count, -1)[:, :bodies], "pga": file["waves/pga"][()], "pgv": file["waves/pgv"][()],
            "limit": np.array([file[f"bodies/{name}/v_ereq"][0] for name in names]),
            "measured": {shown: np.array([file[f"waves/{name}/{column}"][()] for name in names]).T
                         for column, shown in MEASURED.items()}}


def v_wes_of(file, dataset, grid, voters):
    """V_WES over own periods: by phi of the voters, by test and body; of the scans over the fixed and over their own T1."""
    periods = periods_of(dataset)
    v = np.array([file[f"waves/t{t:03d}/v_wes"][()] for t in range(len(periods))]).T
    t1 = [file[f"bodies/t{t:03d}/t1"][0] for t in range(len(periods))]
    if not np.allclose(t1, periods, rtol=1e-9):
        sys.exit("validation: bodies that measure have another T1 than they stand for")
    alpha, phis = dataset["fitted"]["alpha"], dataset["own_period"]["phi"]
    of_body = [alpha.index(grid[b][1]) for b in voters]
    own = {phi: v[:, [i * len(alpha) + a for a in of_body]] for i, phi in enumerate(phis)}
    return own, v[:, len(phis) * len(alpha):]


def judge_own_period(dataset, found, own, scanned, voters, motions, fell, random):
    """own_period.study of all specimens, and the scans: of what either T1 calls safe, how many fell."""
    specimens = [{"fell": f, "agrees": found["fell"][:, voters] == f[:, None], "fixed": found["measured"]["v_wes"][:, voters],
                  "own": own, "limit": found["limit"][voters]} for f in fell.values()]
    told = own_period.study(specimens, motions, random)
    stated = dataset["own_period"]["scan"]
    told["scans"] = []
    for i, scan in enumerate(own_period.scans(stated, GRAVITY)):
        said = own_period.compare(*(scanned[:, 2 * i + k] >= scan["limit_mps"] for k in (0, 1)), fell[stated["specimen"]], motions, random)
        told["scans"].append({**scan, **said})
    return told


def some_bodies(tests, chosen):
    """The same of some of the bodies."""
    return {**tests, "fell": tests["fell"][:, chosen], "energy": tests["energy"][:, chosen], "limit": tests["limit"][chosen],
            "measured": {name: x[:, chosen] for name, x in tests["measured"].items()}}


def sensitivity(tests, grid, fell):
    """Of every height, slope and restitution (0: Housner's): what its trials and V_WES said, and how V_WES orders the tests."""
    rows = []
    everyone = np.arange(len(fell))
    for b, (height, alpha, e) in enumerate(grid):
        ratio = tests["measured"]["v_wes"][:, b] / tests["limit"][b]
        own = outcomes.counted(tests["fell"][:, b], fell)
        rows.append([height, alpha, e, own["false_safe"], own["false_alarm"], own["agreement"], int((ratio < 1).sum()),
                     int(((ratio < 1) & fell).sum()), float(outcomes.Area(ratio, fell)(everyone))])
    return rows


def judge(tests, grid, voters, motions, fell, others, random):
    said = outcomes.judge(some_bodies(tests, voters), motions, fell, random)
    del said["chance"], said["unsafe"]
    said["voters"] = [[*grid[voters[b]][1:], count] for b, count in said.pop("votes").items()]
    said["by_others"] = outcomes.counted(others, fell)
    said["sensitivity"] = sensitivity(tests, grid, fell)
    return said


def tell_scans(told):
    for scan in told["scans"]:
        calls = " and ".join(f"{k['safe'] + k['false_safe']} safe, of which {k['false_safe']} fell, {k['false_alarm']} false alarms"
                             for k in (scan["fixed"], scan["own"]))
        print(f"  scan, half width {scan['half_width_m']:g} m: T1 {scan['fixed_t1_s']:.2f} and by its own p {scan['own_t1_s']:.2f} s: {calls}")


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
    print("  area under the curve: " + ", ".join(f"{m} {v:.3f} [{l:.3f}, {h:.3f}]" for m in SHOWN
                                                   for v, l, h in [said["areas"][m]]))
    for measure, k in said["criteria"].items():
        print(f"  {measure} < V_Ereq calls {k['false_safe'] + k['safe']} safe, of which {k['false_safe']} fell")
    print("  height alpha    e: time history false safe, false alarm, agreement; V_WES < V_Ereq safe, of these fell; area under the curve")
    for height, alpha, e, missed, alarms, agreement, safe, wrong, area in said["sensitivity"]:
        print(f"  {height:6.3f} {alpha:5.2f} {e or 'e_H':>4}: {missed:4} {alarms:4} {agreement:.3f}; {safe:4} {wrong:4}; {area:.3f}")
    print("  PGV [m/s]: " + ", ".join(f"{l:.2f}-{h:.2f} {f}/{n} fell [{a:.2f}, {b:.2f}], {p:.0f} predicted"
                                     for l, h, n, f, a, b, p in said["bins"]))
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
        files = records(dataset, folder, to, tests)
        with open(to / "outcomes.csv", "w", encoding="utf-8", newline="") as file:
            table = csv.writer(file, lineterminator="\n")
            bodies = [(body, specimen["outcome"]) for specimen in dataset["specimens"]
                      for body in [specimen["name"], *specimen.get("unfitted", [])]]
            table.writerow(["wave", "motion", *(body for body, _ in bodies)])
            table.writerows([name, motion_of(test), *(test[outcome] for _, outcome in bodies)] for name, test in zip(files, tests))
        return
    motions = np.array([motion_of(test) for test in tests])
    told = {"title": dataset["title"], "doi": dataset["doi"], "specimens": {}}
    with tempfile.TemporaryDirectory() as scratch:
        grid = campaign(dataset, folder, Path(scratch), tests)
        with run(program, Path(scratch)) as file:
            found = tests_of(file, len(tests), len(grid))
            voters = [b for b, (height, _, _) in enumerate(grid) if height == dataset["block"]["centre_height_m"]]
            own, scanned = v_wes_of(file, dataset, grid, voters)
    random = np.random.default_rng(1)
    for specimen in dataset["specimens"]:
        fell = np.array([test[specimen["outcome"]] == "1" for test in tests])
        others = np.array([test[specimen["predicted_by_others"]] == "1" for test in tests])
        told["specimens"][specimen["name"]] = judge(found, grid, voters, motions, fell, others, random)
        tell(specimen["name"], told["specimens"][specimen["name"]])
    fell = {s["name"]: np.array([test[s["outcome"]] == "1" for test in tests]) for s in dataset["specimens"]}
    told["own_period"] = judge_own_period(dataset, found, own, scanned, voters, motions, fell, random)
    own_period.tell(told["own_period"])
    tell_scans(told["own_period"])
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
