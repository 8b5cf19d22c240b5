"""Figure of real outcomes: falls over PGV beside what was predicted, and how well each measure orders the tests."""

from . import style
from .style import BLUE, INK, VERMILION

import matplotlib.pyplot as plt
import numpy as np


def shares(axes, judged):
    """Share of falls in bins of PGV with its exact interval, and the predicted share."""
    low, high, n, k, lower, upper, predicted = np.array(judged["bins"]).T
    middle, share = np.sqrt(low * high), k / np.maximum(n, 1)
    axes.errorbar(style.speed(middle), share, xerr=style.speed(np.array([middle - low, high - middle])),
                  yerr=np.abs([share - lower, upper - share]), fmt="o", ms=3.4, color=INK, elinewidth=0.8, label="fell, exact 95 %", zorder=3)
    axes.plot(style.speed(middle), predicted / np.maximum(n, 1), "s", ms=4, mfc="none", color=VERMILION, label="predicted", zorder=4)
    axes.set_xscale("log")
    axes.set_xlabel(f"PGV [{style.speed_unit()}]")
    axes.set_ylabel("share of tests that fell")
    axes.set_ylim(-0.03, 1.03)
    axes.set_title("Falls over PGV")


def reliability(axes, judged):
    """Of tests with about one predicted chance: how many fell."""
    rows = np.array([row for row in judged["reliability"] if row[1]], float)
    axes.plot([0, 1], [0, 1], color=style.GREY, lw=0.7, ls=(0, (4, 3)))
    axes.plot(rows[:, 0] + 0.1, rows[:, 2] / rows[:, 1], "o-", ms=3.4, color=BLUE)
    for low, n, k in rows:
        axes.annotate(f"{int(k)} / {int(n)}", (low + 0.1, k / n), textcoords="offset points", xytext=(4, -9), fontsize=6.5)
    axes.set_xlim(0, 1)
    axes.set_ylim(-0.06, 1.06)
    axes.set_xlabel("predicted chance")
    axes.set_title("Reliability")


def areas(axes, judged, name_of):
    """How well each measure orders the tests, best above."""
    rows = sorted(judged["areas"].items(), key=lambda item: item[1][0])
    for at, (_, (value, low, high)) in enumerate(rows):
        if low is not None:
            axes.plot([low, high], [at, at], color=INK, lw=0.8)
        axes.plot(value, at, "o", ms=3.4, color=BLUE)
    axes.set_yticks(range(len(rows)), [name_of(measure) for measure, _ in rows])
    axes.axvline(0.5, color=style.GREY, lw=0.7, ls=(0, (4, 3)))
    axes.set_xlim(0.45, 1.005)
    axes.set_xlabel("area under the curve")
    axes.set_title("Order of the tests")


def draw(specimen, name_of, path):
    judged = specimen.judged
    panels = [shares]
    panels += [reliability] if len(specimen.bodies) > 1 else []
    panels += [lambda axes, of: areas(axes, of, name_of)] if judged["areas"] else []
    style.use()
    figure, axes = plt.subplots(1, len(panels), figsize=(2.9 * len(panels), 2.6), squeeze=False, layout="constrained")
    for panel, of in zip(panels, axes[0]):
        panel(of, judged)
    handles, labels = axes[0][0].get_legend_handles_labels()
    style.legend_below(figure, handles, labels)
    style.save(figure, path)
