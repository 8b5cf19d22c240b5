"""Would V_WES gain if its periods were those of the body's own free rocking, instead of 0.05 to 0.5 sqrt(R in cm)?

The rule: T1 is the period of free rocking from the rotation phi alpha, without loss, by the body's own alpha and p; T0 is T1 / 10
as before. Its only free choice is phi. It is chosen on one half of the motions: of the phi that call no more tests safe which fell
than the fixed band does, the one with the fewest false alarms, and of equals the largest; none of them: the largest. The other
half judges. All tests of a motion lie in one half, and intervals resample motions with their tests."""

import math

import numpy as np
from overturn.report import outcomes

BAND_S = 5.0  # T1 = 5 s times sqrt(R in m): the program's own rule, by which a body of another R measures any other T1
SHARE = 10    # T1 / T0 of that rule
NODES = 64    # of a quadrature; the integrand is smooth


def period_times_p(alpha, phi):
    """Of free rocking from phi alpha on, of the nonlinear block without loss (linear: 4 acosh(1 / (1 - phi)))."""
    # theta'' = -p^2 sin(alpha - theta), with theta = phi alpha (1 - s^2), so that the integrand has no pole
    nodes, weights = np.polynomial.legendre.leggauss(NODES)
    s, first = 0.5 * (nodes + 1), alpha * phi
    fall = 2 * np.sin(alpha - first + 0.5 * first * s**2) * np.sin(0.5 * first * s**2)  # cos(alpha - first) - cos(alpha - theta)
    return 4 * float(np.sum(0.5 * weights * 2 * first * s / np.sqrt(2 * fall)))


def radius_m(period_s):
    """R of a body whose T1 by the program's rule is this."""
    return (period_s / BAND_S)**2


def choosing(motions):
    """Tests of the half that chooses: of the motions in the order of their names the first, third, fifth ..."""
    return np.isin(motions, sorted(set(motions))[::2])


def called_unsafe(measure, limit, voters):
    """By the majority of these bodies: measure and limit by test and body."""
    return (measure[:, voters] >= limit[voters]).mean(1) > 0.5


def choose(fixed, own, fell):
    """phi, of {phi: called unsafe} beside what the fixed band calls unsafe, of the tests that choose."""
    most = int((~fixed & fell).sum())
    wrong = {phi: (int((~unsafe & fell).sum()), int((unsafe & ~fell).sum())) for phi, unsafe in own.items()}
    allowed = [phi for phi, (missed, _) in wrong.items() if missed <= most]
    return min(allowed, key=lambda phi: (wrong[phi][1], -phi)) if allowed else max(own)


def conclusion(false_safe, false_alarm):
    """Of the intervals of the own period's share of tests less that of the fixed band."""
    if [*false_safe, *false_alarm] == [0, 0, 0, 0]:
        return "no gain: every test is predicted the same"
    if false_alarm[1] < 0:
        return "gain: fewer false alarms, and no more false safe" if false_safe[1] <= 0 else \
            "no gain: fewer false alarms are paid for with false safe" if false_safe[0] > 0 else \
            "cannot be decided: fewer false alarms, and whether more are false safe these tests do not tell"
    if false_safe[0] > 0 or false_alarm[0] > 0:
        return "no gain: more are wrong"
    return "cannot be decided with these tests"


def compare(one, other, fell, motions, random):
    """Counts of two rules on the same tests; intervals of each share and of their difference, `other` less `one`."""
    parts = {"false_safe": lambda unsafe: ~unsafe & fell, "false_alarm": lambda unsafe: unsafe & ~fell}

    def interval(wrong):
        return outcomes.interval(motions, lambda i: wrong[i].mean(), random)
    told = {name: {**outcomes.counted(unsafe, fell), **{f"{part}_interval": interval(wrong(unsafe).astype(float))
                                                        for part, wrong in parts.items()}}
            for name, unsafe in (("fixed", one), ("own", other))}
    told["difference"] = {part: interval(wrong(other).astype(float) - wrong(one)) for part, wrong in parts.items()}
    return told


def study(specimens, motions, random):
    """Chooses on one half and judges on the other.

    specimens: by name `fell` by test; `agrees` by test and body (whether its time history did); `fixed` by test and body and `own`
    {phi: the same}: V_WES; `limit` by body. Bodies vote as for the time history, chosen by it on the half that chooses."""
    chooses = choosing(motions)
    kept, judged = np.flatnonzero(chooses), np.flatnonzero(~chooses)
    fixed, own, area, fell = [], [], [], []
    for told in specimens:
        voters = outcomes.as_good_as_the_best(told["agrees"][kept])
        fixed.append(called_unsafe(told["fixed"], told["limit"], voters))
        own.append({phi: called_unsafe(v, told["limit"], voters) for phi, v in told["own"].items()})
        area.append({name: np.log(v / told["limit"])[:, voters].mean(1) for name, v in [("fixed", told["fixed"]), *told["own"].items()]})
        fell.append(told["fell"])

    def of_all(parts, tests):
        return np.concatenate([part[tests] for part in parts])
    phi = choose(of_all(fixed, kept), {phi: of_all([o[phi] for o in own], kept) for phi in own[0]}, of_all(fell, kept))
    names = np.concatenate([motions[judged]] * len(specimens))
    told = compare(of_all(fixed, judged), of_all([o[phi] for o in own], judged), of_all(fell, judged), names, random)
    told["areas"] = [{name: float(outcomes.Area(a[key][judged], f[judged])(np.arange(len(judged)))) for name, key in
                      (("fixed", "fixed"), ("own", phi))} for a, f in zip(area, fell)]
    told["phi"], told["tests"], told["motions"] = phi, len(names), len(set(names))
    told["choosing"] = {"fixed": outcomes.counted(of_all(fixed, kept), of_all(fell, kept)),
                        "own": {p: outcomes.counted(of_all([o[p] for o in own], kept), of_all(fell, kept)) for p in own[0]}}
    told["conclusion"] = conclusion(told["difference"]["false_safe"], told["difference"]["false_alarm"])
    return told


def tell(told):
    def counts(k):
        return f"{k['false_safe']:3} false safe, {k['false_alarm']:3} false alarms, {k['safe'] + k['false_safe']:3} called safe"

    def spread(ends):
        return f"[{ends[0]:+.3f}, {ends[1]:+.3f}]"
    print("V_WES over the body's own periods (T1: free rocking from phi alpha) instead of 0.05 to 0.5 sqrt(R in cm)")
    print(f"  choosing half, fixed band: {counts(told['choosing']['fixed'])}")
    for phi, k in told["choosing"]["own"].items():
        print(f"    phi {phi:<5g}: {counts(k)}" + ("  <- chosen" if phi == told["phi"] else ""))
    print(f"  judging half ({told['tests']} tests of both specimens, {told['motions']} motions), shares with 95 % intervals:")
    for name in ("fixed", "own"):
        k = told[name]
        print(f"    {name:5}: {counts(k)}; false safe {spread(k['false_safe_interval'])}, false alarm {spread(k['false_alarm_interval'])}")
    print("    own less fixed: " + ", ".join(f"{part.replace('_', ' ')} {spread(ends)}" for part, ends in told["difference"].items()))
    print("    area under the curve, fixed and own: " + "; ".join(f"{a['fixed']:.3f}, {a['own']:.3f}" for a in told["areas"]))
    print(f"  {told['conclusion']}")


def scans(stated, gravity):
    """Bodies of a measured inertia: R, alpha, T1 of the fixed rule and T1 by p alone (the fixed rule's share of a uniform block's)."""
    found = []
    for half_width in stated["half_width_m"]:
        height = stated["centre_height_m"]
        radius = math.hypot(half_width, height)
        p = math.sqrt(gravity * radius / (stated["inertia_over_mass_m2"] + radius**2))
        fixed = BAND_S * math.sqrt(radius)
        found.append({"half_width_m": half_width, "fixed_t1_s": fixed, "own_t1_s": fixed * math.sqrt(0.75 * gravity / radius) / p,
                      "limit_mps": math.sqrt(2 * gravity * (radius - height))})
    return found
