"""What a model says of real tests, held against how they ended.

Tests of one motion resemble each other: whatever is chosen on outcomes (the bodies that vote, a threshold) is chosen on the
other motions alone, and intervals resample motions with all their tests."""

import math

import numpy as np

RESAMPLES = 2000
MOST_BINS = 6  # of PGV, of equally many tests
LEAST_IN_BIN = 5  # tests
STEPS = (0.0, 0.2, 0.4, 0.6, 0.8)  # of predicted chance
FLOOR = 1e-9  # of ratios, before their logarithm


def counted(predicted, fell):
    """False safe first: it fell and was predicted to stand."""
    return {"false_safe": int((~predicted & fell).sum()), "false_alarm": int((predicted & ~fell).sum()),
            "safe": int((~predicted & ~fell).sum()), "fell": int((predicted & fell).sum()),
            "agreement": float((predicted == fell).mean())}


def exact(k, n, confidence=0.95):
    """Clopper and Pearson (1934): the exact interval of a share, by bisection of the binomial's tails."""
    def tail_above(p, least):  # P(X >= least)
        return sum(math.exp(math.lgamma(n + 1) - math.lgamma(j + 1) - math.lgamma(n - j + 1) + j * math.log(p)
                            + (n - j) * math.log1p(-p)) for j in range(least, n + 1))

    def solve(value, wanted):
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if value(middle) < wanted else (low, middle)
        return 0.5 * (low + high)
    miss = 0.5 * (1 - confidence)
    return [0.0 if k == 0 else solve(lambda p: tail_above(p, k), miss),
            1.0 if k == n else solve(lambda p: tail_above(p, k + 1), 1 - miss)]


class Area:
    """Chance that a test which overturned the body has more of x than one which did not (Mann and Whitney 1947)."""

    def __init__(self, x, fell):
        self.fell = fell
        one, other = x[fell][:, None], x[~fell][None, :]
        self.above = (one > other) + 0.5 * (one == other)

    def __call__(self, indices):
        weight = np.bincount(indices, minlength=len(self.fell)).astype(float)
        fell, stood = weight[self.fell], weight[~self.fell]
        return fell @ self.above @ stood / (fell.sum() * stood.sum()) if fell.any() and stood.any() else math.nan


def left_out(motions, choose, predict):
    """For every test what the other motions choose says of it; and what each motion's others chose."""
    predicted, chosen = np.zeros(len(motions)), []
    for motion in sorted(set(motions)):
        out = motions == motion
        chosen.append(choose(~out))
        predicted[out] = predict(chosen[-1])[out]
    return predicted, chosen


def as_good_as_the_best(agreement):
    """Bodies whose agreement with these tests is within a standard error of the best (Breiman et al. 1984)."""
    share = agreement.mean(0)
    best = share.max()
    return np.flatnonzero(share >= best - math.sqrt(best * (1 - best) / len(agreement)))


def best_threshold(x, fell):
    """Above which value of x falls are to be expected, to be right most often; minus infinity: always."""
    at = np.concatenate([[-math.inf], np.sort(x)])
    return at[int(np.argmax([((x > t) == fell).mean() for t in at]))]


def interval(motions, value, random):
    """95 %, motions resampled with all their tests; None where one motion is all there is, or no resample has an answer."""
    groups = [np.flatnonzero(motions == motion) for motion in sorted(set(motions))]
    if len(groups) < 2:
        return None
    found = np.array([value(np.concatenate([groups[g] for g in random.integers(0, len(groups), len(groups))]))
                      for _ in range(RESAMPLES)], float)
    found = found[np.isfinite(found)]
    return [float(end) for end in np.percentile(found, [2.5, 97.5])] if len(found) else None


def judge(tests, motions, fell, random):
    """What to tell of one specimen.

    tests: `fell` and `energy` (peak energy over that of the limit, or None), by test and body; `pga`, `pgv`, by test;
    `measured`, name to measure by test and body; `limit`, by body. motions: by test. fell: whether the specimen did."""
    agreement = tests["fell"] == fell[:, None]
    bodies = tests["fell"].shape[1]

    def vote(votes):
        return left_out(motions, lambda kept: as_good_as_the_best(agreement[kept]) if kept.any() else np.arange(bodies),
                        lambda chosen: votes[:, chosen].mean(1))
    chance, chosen = vote(tests["fell"])
    predicted, everyone = chance > 0.5, np.arange(len(fell))
    judged = {"tests": len(fell), "falls": int(fell.sum()), "motions": len(set(motions)), "chance": chance,
              "votes": {int(b): sum(b in of for of in chosen) for b in sorted(set(np.concatenate(chosen)))},
              "by_time_history": counted(predicted, fell),
              "agreement_interval": interval(motions, lambda i: (predicted[i] == fell[i]).mean(), random),
              "false_safe_interval": interval(motions, lambda i: (~predicted[i] & fell[i]).mean(), random)}
    if judged["motions"] > 1:
        for measure in ("pgv", "pga"):
            x = tests[measure]
            by, _ = left_out(motions, lambda kept, x=x: best_threshold(x[kept], fell[kept]), lambda t, x=x: x > t)
            judged[f"by_threshold_on_{measure}"] = counted(by > 0.5, fell)
    near = as_good_as_the_best(agreement)
    ordering = {name: np.log(np.maximum(x / tests["limit"], FLOOR))[:, near].mean(1) for name, x in tests["measured"].items()}
    ordering.update(pgv=tests["pgv"], pga=tests["pga"])
    if tests["energy"] is not None:
        ordering["peak energy"] = np.log(np.maximum(tests["energy"], FLOOR))[:, near].mean(1)
    areas = {name: Area(x, fell) for name, x in ordering.items()} if fell.any() and not fell.all() else {}
    judged["areas"] = {name: [float(area(everyone)), *(interval(motions, area, random) or [None, None])]
                       for name, area in areas.items()}
    judged["unsafe"] = {name: vote(x >= tests["limit"])[0] > 0.5 for name, x in tests["measured"].items()}
    judged["criteria"] = {name: counted(unsafe, fell) for name, unsafe in judged["unsafe"].items()}
    judged["bins"] = bins(tests["pgv"], chance, fell)
    share = fell.mean()
    judged["brier"] = {"time_history": float(((chance - fell) ** 2).mean()), "always_the_share": float(share * (1 - share))}
    judged["reliability"] = [[low, int(inside.sum()), int(fell[inside].sum())] for low in STEPS
                             for inside in [(chance >= low) & ((chance < low + 0.2) | (low == STEPS[-1]))]]
    return judged


def bins(pgv, chance, fell):
    """Of about equally many tests: lowest and highest PGV, tests, falls, exact interval of their share, predicted falls."""
    count = max(1, min(MOST_BINS, len(pgv) // LEAST_IN_BIN))
    edges = np.unique(np.quantile(pgv, np.linspace(0, 1, count + 1)))
    if len(edges) == 1:  # all alike
        edges = np.repeat(edges, 2)
    rows = []
    for low, high in zip(edges[:-1], edges[1:]):
        inside = (pgv >= low) & ((pgv < high) | (high == edges[-1]))
        n, k = int(inside.sum()), int(fell[inside].sum())
        rows.append([float(low), float(high), n, k, *exact(k, n), float(chance[inside].sum())])
    return rows
