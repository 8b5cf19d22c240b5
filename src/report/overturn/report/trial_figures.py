"""Figures of what the trials did: peak rotation, slip, effects that ran, and the waves' quality."""

from . import style
from .fragility_figures import level_label
from .style import BLUE, GREEN, GREY, INK, ORANGE, PALE, PURPLE, SKY, VERMILION

import matplotlib.pyplot as plt
import numpy as np
from matplotlib import colormaps

MODEL_COLOURS = [PALE, SKY, ORANGE, PURPLE, GREEN, BLUE]  # the first is rest
ENDS = {"at-rest": PALE, "slid": ORANGE, "rocked": SKY, "slid-and-rocked": SKY, "overturned": VERMILION, "contact-lost": PURPLE, "failed": INK}
LEAST_SLIP = 1e-4  # [m] that anyone asks about
MOST_STEPS = 400  # of a distribution function: finer than print


def steps_of(values):
    """A distribution function thinned to what print can show."""
    ordered = np.sort(values)
    at = np.unique(np.linspace(0, len(ordered) - 1, min(len(ordered), MOST_STEPS)).astype(int))
    return ordered[at], (at + 1) / len(ordered)


def by_level(results, body, axes, values, levels):
    """One distribution function a level, light to dark with rising amplitude; the levels that were drawn."""
    level = body.trials("level")
    drawn = []
    for place, number in enumerate(levels):
        chosen = values[level == number]
        chosen = chosen[np.isfinite(chosen)]
        if not len(chosen):
            continue
        x, share = steps_of(chosen)
        colour = colormaps["viridis_r"](0.12 + 0.85 * place / max(1, len(levels) - 1))
        amplitude, unit = results.in_units(body.stripes["amplitude"][number])
        axes.step(x, share, where="post", color=colour, lw=1, label=f"{float(amplitude):.4g} {unit}".strip())
        drawn.append((number, len(chosen)))
    return drawn


def chosen_levels(body, most=7):
    """Levels evenly spread over those at which the body moves and does not nearly always overturn."""
    stripes = body.stripes
    telling = (stripes["at_rest"] < stripes["trials"]) & ~(stripes["probability"] > 0.98)
    levels = np.flatnonzero(telling) if telling.any() else np.arange(len(telling))
    places = np.linspace(0, len(levels) - 1, min(most, len(levels)))
    return [int(level) for level in levels[np.unique(places.round().astype(int))]]


def of_levels(body, drawn):
    """Which part of the levels is shown."""
    return f", {len(drawn)} of {len(body.stripes['amplitude'])} levels"


def rotations(results, body, path, fewest, confidence=0.95):
    """Distribution of the peak rotation per level with the Dvoretzky-Kiefer-Wolfowitz band of the middle one. fewest: trials
    of which a band is drawn."""
    style.use()
    figure, axes = plt.subplots(figsize=(5.4, 2.3), layout="constrained")
    ratio = np.where(body.ended("fell"), np.inf, body.trials("peak_rotation_ratio"))
    ratio = np.where(body.ended("decided"), ratio, np.nan)
    shown = np.where(np.isinf(ratio), 1.2, np.minimum(ratio, 1.2))  # what overturns leaves the picture on the right
    drawn = by_level(results, body, axes, shown, chosen_levels(body))
    if drawn and drawn[len(drawn) // 2][1] >= fewest:
        number, count = drawn[len(drawn) // 2]
        x, share = steps_of(shown[(body.trials("level") == number) & np.isfinite(shown)])
        reach = np.sqrt(np.log(2 / (1 - confidence)) / (2 * count))
        amplitude, unit = results.in_units(body.stripes["amplitude"][number])
        axes.fill_between(x, np.clip(share - reach, 0, 1), np.clip(share + reach, 0, 1), step="post", color=GREY, alpha=0.25,
                          lw=0, label=f"{100 * confidence:g} % band (Dvoretzky, Kiefer, Wolfowitz) of {float(amplitude):.4g} {unit}".strip())
    axes.axvline(1, color=GREY, lw=0.8, ls="--", label="critical angle")
    axes.set(xlim=(0, 1.15), ylim=(0, 1.02), xlabel="peak rotation / α", ylabel="share of trials",
             title=f"peak rotation{of_levels(body, drawn)}")
    style.legend_below(figure, *axes.get_legend_handles_labels(), columns=4)
    style.name(figure, body.name)
    style.save(figure, path)


def slips(results, body, path):
    """Distribution of the peak slip per level; False if nothing slipped."""
    slip, unit = style.shown("slip", body.trials("peak_slip")), style.unit("slip")
    if not np.any(slip > 0):
        return False
    style.use()
    figure, axes = plt.subplots(figsize=(5.4, 2.3), layout="constrained")
    least = max(np.min(slip[slip > 0]), min(style.shown("slip", LEAST_SLIP), 0.1 * np.nanmax(slip)))
    drawn = by_level(results, body, axes, np.where(np.isfinite(slip), np.maximum(slip, 0.5 * least), np.nan), chosen_levels(body))
    axes.set(ylim=(0, 1.02), xlabel=f"peak slip [{unit}]; at the left edge: below {style.plain(least, 1)} {unit}", ylabel="share of trials",
             title=f"peak slip{of_levels(body, drawn)}")
    axes.set_xscale("log")
    axes.set_xlim(left=least)
    style.legend_below(figure, *axes.get_legend_handles_labels(), columns=4)
    style.name(figure, body.name)
    style.save(figure, path)
    return True


def shares(axes, results, body, title, parts):
    """Bars of the shares of each level's trials, stacked: (label, which trials, colour) a part."""
    level, count = body.trials("level"), len(body.stripes["amplitude"])
    amplitude, _ = results.in_units(body.stripes["amplitude"])
    trials = np.maximum(np.bincount(level, minlength=count), 1)
    places, below = np.arange(count), np.zeros(count)
    for label, which, colour in parts:
        share = np.bincount(level[which], minlength=count) / trials
        if share.any():
            axes.bar(places, share, bottom=below, width=0.82, color=colour, label=label)
        below += share
    every = max(1, -(-count // 7))
    axes.set_xticks(places[::every], [f"{value:.4g}" for value in amplitude[::every]])
    axes.set(title=title, ylim=(0, 1), xlabel=level_label(results))
    axes.grid(axis="x", visible=False)


def ends(results, body, path):
    """How the trials of each level ended, and the model that they needed."""
    style.use()
    figure, (left, right) = plt.subplots(1, 2, figsize=(5.8, 2.8), sharey=True, layout="constrained")
    shares(left, results, body, "verdicts",
           [(name, which, ENDS.get(name, GREEN)) for name, which in body.kinds("verdict")])
    shares(right, results, body, "model used",
           [(name, which, MODEL_COLOURS[n % len(MODEL_COLOURS)]) for n, (name, which) in enumerate(body.kinds("rung"))])
    for axes in (left, right):
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.24), ncols=2)
    left.set_ylabel("share of trials")
    style.name(figure, body.name)
    style.save(figure, path)


def wave_quality(results, path):
    """How well the waves meet their target and how far they end from rest; False for waves without a target."""
    waves = results.waves
    if "match_mean_ratio" not in waves:
        return False
    matched = waves["match_mean_ratio"] > 0
    if not matched.any():
        return False
    style.use()
    figure, panels = plt.subplots(1, 3, figsize=(5.8, 2.1), layout="constrained")
    kinds = [("match_mean_misfit", "mean misfit [%]", 100, BLUE), ("match_worst_decade", "worst decade [%]", 100, BLUE),
             ("duration_5_75", "5–75 % duration [s]", 1, GREEN)]
    for axes, (column, label, factor, colour) in zip(panels, kinds):
        axes.hist(factor * waves[column][matched], bins=24, color=colour)
        axes.set(xlabel=label)
    panels[0].set_ylabel("waves")
    style.save(figure, path)
    return True


def axes_compared(results, path):
    """V_resp over V_WES, in units of V_Ereq, for bodies under one, two and three components; False if all are the same, or nothing was
    measured."""
    shaken = {}
    for body in results.bodies:
        shaken.setdefault(int(body.numbers["axes"]), []).append(body)
    if len(shaken) < 2 or not results.measured_energy:
        return False
    style.use()
    names = {1: "one axis", 2: "two axes", 3: "three axes"}
    figure, panels = plt.subplots(1, len(shaken), figsize=(5.8, 3.0), sharex=True, sharey=True, layout="constrained")
    for axes, (count, bodies_of_it) in zip(np.atleast_1d(panels), sorted(shaken.items())):
        for n, body in enumerate(bodies_of_it):
            known = np.isfinite(body.trials("v_resp"))
            limit = body.numbers["v_ereq_mps"]
            fell = body.ended("fell")[known]
            x, y = body.trials("v_wes")[known] / limit, body.trials("v_resp")[known] / limit
            colour = style.SERIES[n % len(style.SERIES)]
            axes.plot(x[~fell], y[~fell], ".", ms=2.5, color=colour, label=style.literal(body.name))
            axes.plot(x[fell], y[fell], "x", ms=3, mew=0.7, color=colour)
        axes.axhline(1, color=GREY, lw=0.7, ls="--")
        axes.set(title=names[count], xlabel="V_WES / V_Ereq", ylim=(0, 1.5))
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), markerscale=2)
    np.atleast_1d(panels)[0].set_ylabel("V_resp / V_Ereq (×: overturned)")
    style.save(figure, path)
    return True


def reasons(results, body, path):
    """Why trials of each level needed a dearer model; False where none did."""
    kinds = [(name, which) for name, which in body.kinds("reason") if name != "none" and which.any()]
    if not kinds:
        return False
    style.use()
    figure, axes = plt.subplots(figsize=(5.2, 2.4), layout="constrained")
    shares(axes, results, body, "why a more detailed model was required",
           [(name, which, style.SERIES[n % len(style.SERIES)]) for n, (name, which) in enumerate(kinds)])
    axes.set_ylabel("share of trials")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.24), ncols=2)
    style.name(figure, body.name)
    style.save(figure, path)
    return True
