"""What numbers of the paper's page say: which way they tell, or that so few trials tell nothing. No sentence here holds
whatever was found; bounds are exact (signs, order statistics, Clopper and Pearson), at 95 %."""

import math

import numpy as np

REPRODUCED, DIFFERS, UNKNOWN, MISSING = "reproduced", "differs", "cannot be known", "not run"
UNSURE = 0.05  # one minus the confidence
ALIKE = 0.1    # share of waves beyond which a difference matters: bodies stand alike if surely fewer differ


def at_least(count, of, p):
    """The probability of `count` or more of `of` where each comes with p."""
    if count <= 0 or p >= 1:
        return 1.0
    if p <= 0:
        return 0.0
    logs = [math.lgamma(of + 1) - math.lgamma(k + 1) - math.lgamma(of - k + 1) + k * math.log(p) + (of - k) * math.log1p(-p)
            for k in range(count, of + 1)]
    return min(1.0, sum(math.exp(log) for log in logs))


def bounds(count, of, unsure=UNSURE):
    """The interval of a share (Clopper and Pearson 1934); each end is passed with half of `unsure`."""
    def root(rising):
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if rising(middle) < unsure / 2 else (low, middle)
        return (low + high) / 2
    if of == 0:
        return 0.0, 1.0
    return (0.0 if count == 0 else root(lambda p: at_least(count, of, p)),
            1.0 if count == of else 1 - root(lambda p: at_least(of - count, of, p)))


def which_way(more, fewer):
    """The sign test: 1 where more go up than chance sends there, -1 where more go down, 0 where it cannot be told."""
    if 2 * at_least(max(more, fewer), more + fewer, 0.5) > UNSURE:
        return 0
    return 1 if more > fewer else -1


def median_interval(values):
    """Of their median, between two order statistics; nothing where there are too few."""
    ordered, place = sorted(values), 0
    while 2 * at_least(len(ordered) - place, len(ordered), 0.5) <= UNSURE:
        place += 1
    return (ordered[place - 1], ordered[-place]) if place else None


class Pair:
    """Two bodies under the same waves. Trials of one wave are no independent ones: waves are counted, by at how many
    levels each overturned the other body more often, or less."""

    def __init__(self, waves, one, other):
        _, place = np.unique(waves, return_inverse=True)
        change = np.bincount(place, weights=other) - np.bincount(place, weights=one)
        self.fell, self.trials, self.waves = (int(np.sum(one)), int(np.sum(other))), len(waves), len(change)
        self.more, self.fewer = int(np.sum(change > 0)), int(np.sum(change < 0))
        self.way = which_way(self.more, self.fewer)
        self.alike = self.way == 0 and all(bounds(count, self.waves, 2 * UNSURE)[1] <= ALIKE for count in (self.more, self.fewer))

    def counts(self):
        return f"{self.fell[1]} instead of {self.fell[0]} of {self.trials}; more in {self.more} wave{'' if self.more == 1 else 's'}, fewer in {self.fewer}"


def compared(pairs, here, there):
    """Which of the pairs, by name, overturn more `here` than `there`, fewer, or as often, and of which that cannot be told."""
    waves, parts = next(iter(pairs.values())).waves, []
    for head, belongs in ((f"more overturn {here} than {there}", lambda p: p.way > 0),
                          (f"fewer overturn {here} than {there}", lambda p: p.way < 0),
                          (f"as many overturn {here} as {there}, but under {100 * ALIKE:g} % of waves at most", lambda p: p.alike),
                          (f"whether more or fewer overturn {here} than {there} cannot be told from {waves} wave{'s' if waves > 1 else ''}",
                           lambda p: not p.way and not p.alike)):
        told = [f"{name} ({pair.counts()})" for name, pair in pairs.items() if belongs(pair)]
        if told:
            parts.append(f"{head}: {', '.join(told)}")
    return parts


def sentences(parts):
    """One after the other; the page ends the last."""
    return ". ".join(part if number == 0 else part[0].upper() + part[1:] for number, part in enumerate(parts))


def verdict_on_alike(pairs, ways=(1, -1)):
    """Of the claim that none of the pairs, by name, differs in one of these ways."""
    if any(pair.way in ways for pair in pairs.values()):
        return DIFFERS
    return REPRODUCED if all(pair.alike or pair.way for pair in pairs.values()) else UNKNOWN


def powers(waves, x, y):
    """For each wave of three trials or more the power of x that y goes with: least squares over its logarithms."""
    found = []
    for wave in np.unique(waves):
        one, other = np.log(x[waves == wave]), np.log(y[waves == wave])
        if len(one) >= 3 and np.ptp(one) > 0:
            found.append(float(np.polyfit(one, other, 1)[0]))
    return found


NO_POWER, GROWS, PROPORTIONAL, STEEPER, FLATTER = "cannot be told", "grows", "proportional", "steeper", "flatter"
NEARLY_ONE, HARDLY = (0.8, 1.25), 0.5  # powers that pass for proportion, and for a plateau


def shape(found):
    """What a median power, with its interval, makes of a curve: steeper or flatter than proportion, or proportional."""
    ends = median_interval(found)
    if ends is None:
        return NO_POWER
    if NEARLY_ONE[0] <= ends[0] and ends[1] <= NEARLY_ONE[1]:
        return PROPORTIONAL
    return STEEPER if ends[0] > 1 else FLATTER if ends[1] < 1 else NO_POWER


def power_text(found):
    """The median power, its interval and of how many waves."""
    if not found:
        return "no wave of three trials"
    ends = median_interval(found)
    told = f"{ends[0]:.1f} to {ends[1]:.1f}" if ends else "too few for an interval"
    return f"{float(np.median(found)):.1f} ({told}; {len(found)} waves)"


def signed(apart):
    """A range of relative differences: '11 to 16 % below', '-3 to +2 % from'."""
    low, high = 100 * min(apart), 100 * max(apart)
    if low < 0 < high:
        return f"{low:.1f} to {high:+.1f} % from"
    near, far = sorted((abs(low), abs(high)))
    return f"{near:.1f} to {far:.1f} % {'below' if high <= 0 else 'above'}"


def listed(words):
    words = [str(word) for word in words]
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
