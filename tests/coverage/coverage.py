#!/usr/bin/env python3
"""How often do the stated 95 % intervals of a whole campaign hold the truth?

A cheap campaign with an uncertain body (campaigns/margin.toml) is run with many seeds, each with few
waves; the truth is the fit of the same campaign with very many waves. By hand, since it takes many minutes:

    /usr/bin/python3 tests/coverage/coverage.py [--program F] [--seeds 200] [--waves 100] [--truth 20000] [--jobs 2] [--minutes M]
                                               [--campaign campaigns/natural_variability.toml]

Found (231 seeds of 100 waves, truth from 20000; two standard errors of a share of 95 % are 2.9 %), shares of intervals that
hold the truth, and of the misses how many lie above it and below it:

    over    median         beta           5 % point      HCLPF
    pga     .926  9, 8     .957  6, 4     .961  6, 3     .974  4, 2
    pgv     .948  6, 6     .957  1, 9     .974  4, 2     .970  5, 2
    v_wes   .935  8, 7     .939  3, 11    .956  8, 2     .948  8, 4
    ou_v_e  .974  3, 3     .961  1, 8     .969  6, 1     .965  7, 1

All sixteen lie within two standard errors of 95 %. Misses come nearly equally on both sides of the median; of HCLPF 24 of 919
intervals lie above the truth (2.6 %, the unconservative side, where 2.5 % should) and 9 below. Before percentiles were
corrected for their bias 4.5 % lay above it and 31 of 32 misses of beta over PGV below; before the split was resampled HCLPF
was held in .896 (pga), .887 (pgv), .883 (v_wes) and .905 (ou_v_e) of 230 seeds, and the median, whose replicates kept the
imbalance that resampling puts into a Latin hypercube, in .991 to 1.000: too wide.

Of campaigns/natural_variability.toml (150 seeds of 100 waves, truth from 6000, two standard errors 3.6 %):

    over         median         beta           5 % point
    pga          .940  5, 4     .940  5, 4     .897  12, 3 (told in 146)
    pgv          .947  5, 3     .893  0, 16    .927  10, 1
    sa_average   .933  6, 4     .893  3, 13    .933  9, 1
    sa_1         .947  4, 4     .887  3, 14    .880  14, 4
    sa_2         .927  5, 6     .913  7, 6     .920  5, 7
    v_wes        .953  2, 5     .907  4, 10    .967  4, 1
    ou_v_e       .920  4, 8     .920  2, 10    .927  10, 1

Medians are held as stated; of waves that differ so much a hundred make beta's interval lie too low, and with it the 5 % point's
too high, in some 5 % of campaigns more than stated. Before percentiles were corrected for their bias the 5 % point over pga was
held in .85.

The fast counterpart, whose truth is a closed form, is tests/stats/hclpf_coverage_test.cpp.
"""

import argparse
import json
import math
import pathlib
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

import h5py

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = ["median", "beta", "five_percent_point", "hclpf"]
MEASURES = ["pga", "pgv", "sa_average", "sa_1", "sa_2", "v_wes", "ou_v_e"]  # those of them that a campaign has
STANDARD = 1.6448536269514722  # normal quantile of 95 %


def fitted(program, campaign, folder, seed, waves):
    """Of each measure, of each number: value, lower and upper end; NaN where it is not told."""
    file = folder / f"{seed}.h5"
    subprocess.run([program, "run", str(campaign), "-o", str(file), "--set", f"seed={seed}", "--set",
                    f"waves.count={waves}", "--set", "measures.wave_quality=false"],
                   check=True, capture_output=True)
    with h5py.File(file) as results:
        fits = results["fragility/type-b"]
        assert list(results["waves"]["pga"].shape) == [waves]
        of = {value: name for name, value in h5py.check_enum_dtype(fits["measure"].dtype).items()}
        rows = {of[value]: row for row, value in enumerate(fits["measure"][()]) if of[value] in MEASURES}
        read = {m: {n: tuple(float(fits[n + end][row]) for end in ("", "_lower", "_upper")) for n in NAMES}
                for m, row in rows.items()}
        # Of a curve that very many waves reject neither point is told: it is still what fewer waves estimate.
        for m, row in rows.items():
            median, beta, beta_r, beta_u = (float(fits[n][row]) for n in ("median", "beta", "beta_r", "beta_u"))
            read[m]["points"] = (median * math.exp(-STANDARD * beta), median * math.exp(-STANDARD * (beta_r + beta_u)))
    for path in folder.glob(f"{seed}.*"):
        path.unlink()
    return read


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=str(ROOT / ".build/release/src/overturn"))
    parser.add_argument("--campaign", type=pathlib.Path, default=ROOT / "campaigns/margin.toml", help="of one body, type-b")
    parser.add_argument("--seeds", type=int, default=200)
    parser.add_argument("--waves", type=int, default=100)
    parser.add_argument("--truth", type=int, default=20000)
    parser.add_argument("--jobs", type=int, default=2, help="campaigns at a time")
    parser.add_argument("--minutes", type=float, default=math.inf, help="no seed is begun after so many")
    parser.add_argument("--raw", type=pathlib.Path, help="keep truth and every campaign's numbers here, as JSON")
    options = parser.parse_args()
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(options.jobs) as pool:
        folder = pathlib.Path(name)

        def run(seed):
            late = time.monotonic() - begin > 60 * options.minutes
            return None if late else fitted(options.program, options.campaign, folder, seed, options.waves)

        known = pool.submit(fitted, options.program, options.campaign, folder, 1, options.truth)
        runs = [r for r in pool.map(run, range(1001, 1001 + options.seeds)) if r]
        truth = known.result()
    if options.raw:
        options.raw.write_text(json.dumps({"truth": truth, "runs": runs}))
    print(f"{len(runs)} campaigns of {options.waves} waves, truth from {options.truth}")
    for measure in truth:
        for number in NAMES:
            points = dict(zip(NAMES[2:], truth[measure]["points"]))
            true = points.get(number, truth[measure][number][0])
            ends = [run[measure][number][1:] for run in runs if not math.isnan(run[measure][number][0])]
            if not ends or math.isnan(true):
                print(f"{measure} {number}: told in {len(ends)}")
                continue
            held = sum(low <= true <= high for low, high in ends)
            above = sum(low > true for low, _ in ends)
            error = math.sqrt(0.95 * 0.05 / len(ends))
            print(f"{measure} {number} {true:.4g}: {held} of {len(ends)} = {held / len(ends):.3f} (+- {2 * error:.3f}); above the "
                  f"truth {above}, below it {len(ends) - held - above}", flush=True)


if __name__ == "__main__":
    main()
