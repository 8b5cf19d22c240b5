"""Effect of assumed values: for one body and limit state, how far each moves the median, largest first."""

from . import style
from .style import BLUE, GREY, INK, VERMILION

import matplotlib.pyplot as plt

MOST = 16  # rows
LEAST = 5e-4  # of the median that is drawn


def percent(ratio):
    return 100 * (ratio - 1)


def moves(end):
    return abs((end["median_ratio"] or 1) - 1) >= LEAST


def draw_end(axes, place, end, colour):
    ratio = end["median_ratio"]
    if ratio is None:
        return
    axes.barh(place, percent(ratio), height=0.34, color=colour if end["resolved"] else "white", edgecolor=colour, lw=0.8,
              zorder=3)
    interval = (end["median_ratio_lower"], end["median_ratio_upper"])
    ends = [percent(value) for value in (ratio, *interval) if value is not None]
    axes.plot([min(ends), max(ends)], [place, place], color=INK, lw=0.9, zorder=4)
    above = ratio >= 1
    axes.annotate(end["moved_to"], (max(ends) if above else min(ends), place), zorder=5, fontsize=6.5, va="center",
                  xytext=(4 if above else -4, 0), textcoords="offset points", ha="left" if above else "right")


def draw(data, path):
    style.use()
    ends = data["rows"]  # low and high of each input
    rows = [(low, high) for low, high in zip(ends[::2], ends[1::2]) if moves(low) or moves(high)][:MOST]
    figure, axes = plt.subplots(figsize=(6.4, 0.9 + 0.36 * len(rows)), layout="constrained")
    unmoved, study = data["unmoved"], data["study"]
    axes.set_title(f"change of the median: {unmoved['body']}, {unmoved['limit']}", pad=6)
    for place, (low, high) in enumerate(rows):
        draw_end(axes, -place + 0.19, low, BLUE)
        draw_end(axes, -place - 0.19, high, VERMILION)
    axes.axvline(0, color=GREY, lw=0.8, zorder=2)
    axes.set_yticks([-place for place in range(len(rows))], [low["keys"][0] for low, _ in rows])
    axes.grid(axis="y", visible=False)
    axes.margins(x=0.18)
    unit = "" if study["stated_unit"] == "1" else " " + study["stated_unit"]
    axes.set_xlabel(f"% of {unmoved['median'] / study['stated_unit_si']:.4g}{unit}; hollow: not significant")
    style.save(figure, path)
