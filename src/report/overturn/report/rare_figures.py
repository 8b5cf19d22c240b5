"""Figures of rare events: the tail beside stripes and curve, and the waves that overturn a body although that is rare."""

from . import style
from .fragility_figures import probit_curve
from .style import BLUE, GREEN, GREY, INK, ORANGE, VERMILION

import matplotlib.pyplot as plt
import numpy as np

METHODS = {"crude": ("o", INK), "subset": ("s", VERMILION), "pulse-mixture": ("D", GREEN)}
MOST_PULSES = 4


def tail(name, limit, stripes, rare, fit, path):
    """P of a limit state on a logarithmic axis: stripes (as `fit --json` has them), the lognormal curve, estimates with
    their replicates, bounds where there is no more than one."""
    style.use()
    figure, axes = plt.subplots(figsize=(5.8, 3.4), layout="constrained")
    amplitude = np.array([s["amplitude"] for s in stripes])
    seen = [s for s in stripes if s["probability"]]
    if seen:
        p, low, high = (np.array([s[key] for s in seen]) for key in ("probability", "lower", "upper"))
        axes.errorbar([s["amplitude"] for s in seen], p, yerr=[p - low, high - p], fmt="_", ms=9, color=GREY, elinewidth=0.8,
                      capsize=2, label=f"stripe, {max(s['trials'] for s in stripes)} trials", zorder=2)
    lowest = [1e-3]
    labelled = set()
    for e in rare:
        marker, colour = METHODS[e["method"]]
        label = None if e["method"] in labelled else f"{e['method']}, 95 %"
        x = e["amplitude"]
        if e["probability"] is None:
            low = e["upper"]
            axes.plot(x, low, "v", ms=6, mfc="white", mec=colour, zorder=4,
                      label=None if "bound" in labelled else "bound: not trusted or not resolved")
            labelled.add("bound")
            lowest.append(low)
            continue
        low, high = e["lower"], e["upper"]
        value = e["probability"]
        axes.errorbar(x, value, yerr=[[max(0, value - low)], [max(0, high - value)]], fmt=marker, ms=4.5, color=colour,
                      elinewidth=1, capsize=3, label=label, zorder=5)
        labelled.add(e["method"])
        dots = [r for r in e["replicates"] if r]
        axes.plot([x] * len(dots), dots, ".", ms=3, color=colour, alpha=0.55, zorder=3)
        lowest += [low, *dots]
    bottom = 0.3 * min(v for v in lowest if v > 0)
    if fit and fit["identifiable"]:
        x = np.geomspace(0.9 * amplitude.min(), 1.1 * amplitude.max(), 200)
        y = probit_curve(x, fit["median"], fit["beta"])
        axes.plot(x[y > bottom], y[y > bottom], color=BLUE, lw=1, ls=(0, (4, 3)), label="lognormal curve of the stripes",
                  zorder=1)
    axes.set_yscale("log")
    axes.set(ylim=(bottom, 1.5), xlabel="factor on all waves", ylabel=f"probability of {style.literal(limit)}",
             title=f"{style.literal(name)}: the tail")
    style.legend_below(axes.figure, *axes.get_legend_handles_labels(), columns=2)
    style.save(figure, path)


def pulses(name, pulses_of_it, path):
    """What failing waves have in common, the commonest first."""
    style.use()
    shown = pulses_of_it[:MOST_PULSES]
    figure, panels = plt.subplots(len(shown), 1, figsize=(5.6, 0.5 + 0.95 * len(shown)), sharex=True, sharey=True,
                                  squeeze=False, layout="constrained")
    for axes, pulse in zip(panels[:, 0], shown):
        axes.axhline(0, color=GREY, lw=0.5)
        axes.plot(pulse["time_s"], style.shown("acceleration", np.asarray(pulse["acceleration_mps2"])), color=BLUE, lw=0.9)
        axes.set_ylabel(style.unit("acceleration"))
        axes.annotate(f"{100 * pulse['share']:.0f} % of failures", (1, 1), xycoords="axes fraction", xytext=(-3, -3),
                      textcoords="offset points", ha="right", va="top", fontsize=7)
    panels[0, 0].set_title(f"{style.literal(name)}: the pulses that overturn it, at factor {shown[0]['factor']:.4g}")
    panels[-1, 0].set_xlabel("time [s]")
    style.save(figure, path)


def failing(name, wave, alpha, path):
    """A wave that overturned the body, and how."""
    style.use()
    figure, (above, below) = plt.subplots(2, 1, figsize=(5.6, 2.8), sharex=True, layout="constrained")
    above.axhline(0, color=GREY, lw=0.5)
    above.plot(wave["time_s"], style.shown("acceleration", np.asarray(wave["acceleration_mps2"])), color=BLUE, lw=0.6)
    above.set(ylabel=style.unit("acceleration"), title=f"{style.literal(name)}: a wave that overturns it at factor {wave['factor']:.4g}")
    tilt = np.asarray(wave["tilt_rad"]) / alpha
    below.plot(wave["tilt_time_s"], np.clip(tilt, -1.6, 1.6), color=ORANGE, lw=0.8)
    for side in (-1, 1):
        below.axhline(side, color=GREY, lw=0.7, ls="--")
    below.set(ylabel="tilt / α", xlabel="time [s]", ylim=(-1.7, 1.7))
    style.save(figure, path)
