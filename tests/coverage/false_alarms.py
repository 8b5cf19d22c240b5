#!/usr/bin/env python3
"""How often does `fit --stripes` find fault with tables that a rising lognormal curve (median 1, beta 0.4) gave?

By hand, some minutes:

    /usr/bin/python3 tests/coverage/false_alarms.py [--program F] [--tables 100] [--designs 20x1,37x1,...]

A flag of the shape (poor-fit, non-monotone) is counted where it is set; none should be in more than 5 % of tables. Where waves
are shared the same is asked by tests/stats/shape_tests_test.cpp (OVERTURN_FALSE_ALARMS=N prints its table, of N tables each).

Found, of 60 tables each:

     levels x trials  poor-fit  non-monotone  either
                 5x1         0             0       0   of 60
                20x1         0             0       0   of 60
                37x1         0             0       0   of 60
               100x1         3             0       3   of 60
              1000x1         2             0       2   of 60
                40x2         0             1       1   of 60
                40x3         1             1       1   of 60
                40x5         0             1       1   of 60
               12x40         2             1       2   of 60
               5x100         0             2       2   of 60
              40x100         0             1       1   of 60
            1000x100         2             1       3   of 60

and of 40 tables each of shared waves (5, 20, 100, 1000 levels by 10, 30, 100 waves): poor-fit 2 at 100 by 30, else none.
Until then chi squared found falls in 45 of 100 tables of 20x1, 91 of 37x1, 40 of 40 of 100x1, 57 of 100 of 40x3 and 36 of 40x5.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import tempfile


def table(rng, levels, trials):
    """Levels spread over the middle of the curve, counts drawn from it."""
    lines = ["amplitude,trials,overturned"]
    for amplitude in sorted(math.exp(rng.uniform(-1.1, 1.1)) for _ in range(levels)):
        p = 0.5 * math.erfc(-math.log(amplitude) / 0.4 / math.sqrt(2))
        lines.append(f"{amplitude:.9g},{trials},{sum(rng.random() < p for _ in range(trials))}")
    return "\n".join(lines) + "\n"


def flags_of(program, text, trials, folder):
    path = folder / "t.csv"
    path.write_text(text)
    answer = subprocess.run([program, "fit", "--stripes", path, "--waves", str(trials), "--json"],
                            capture_output=True, check=True, text=True)
    return set(json.loads(answer.stdout)["fragility"][0]["flags"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default=".build/release/src/overturn")
    parser.add_argument("--tables", type=int, default=100)
    parser.add_argument("--designs", default="5x1,20x1,37x1,100x1,1000x1,40x2,40x3,40x5,12x40,5x100,40x100,1000x100")
    options = parser.parse_args()
    print(f"{'levels x trials':>16} {'poor-fit':>9} {'non-monotone':>13} {'either':>7}")
    with tempfile.TemporaryDirectory() as name:
        for design in options.designs.split(","):
            levels, trials = map(int, design.split("x"))
            rng = random.Random(f"{design}")
            seen = [flags_of(options.program, table(rng, levels, trials), levels * trials, pathlib.Path(name))
                    for _ in range(options.tables)]
            poor, falls = (sum(flag in flags for flags in seen) for flag in ("poor-fit", "non-monotone"))
            either = sum(bool(flags & {"poor-fit", "non-monotone"}) for flags in seen)
            print(f"{design:>16} {poor:>9} {falls:>13} {either:>7}   of {options.tables}", flush=True)


if __name__ == "__main__":
    main()
