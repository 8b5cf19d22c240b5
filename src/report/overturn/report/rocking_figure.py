"""The rocking spectrum of a record: largest rotation over alpha against 2 pi / p, a curve per slenderness."""

from . import style
from .style import INK

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter


def draw(data, path):
    style.use()
    figure, axes = plt.subplots(figsize=(5.8, 4.2), layout="constrained")
    looks = style.looks(len(data["curves"]))
    highest = 1.0
    fallen = []
    for curve, (colour, dashes) in zip(data["curves"], looks):
        points = curve["points"]
        period = np.array([point["rocking_period_s"] for point in points])
        tilt = np.array([point["peak_rotation_ratio"] for point in points], dtype=float)
        highest = max(highest, np.nanmax(tilt, initial=0))
        label = rf"$\alpha$ {np.degrees(curve['alpha_rad']):.4g}°, $e$ {curve['restitution']:.3g}"
        axes.plot(period, tilt, label=label, color=colour, ls=dashes)
        fallen.append((period[[point["fate"] == "overturns" for point in points]], colour))
    for row, (period, colour) in enumerate(fallen):
        axes.plot(period, np.full(len(period), highest * (1.06 + 0.05 * row)), "x", ms=4, color=colour)
    if any(len(period) for period, _ in fallen):
        axes.plot([], [], "x", ms=4, color=INK, label="overturns")
    if "body_rocking_period_s" in data:
        axes.axvline(data["body_rocking_period_s"], color=INK, lw=1, ls=":", label=style.literal(data["body"]))
    axes.set(xlabel=r"$2 \pi / p$ [s]", ylabel=r"largest rotation over $\alpha$", xscale="log",
             ylim=(0, highest * (1.1 + 0.05 * len(fallen))))
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 1.5, 2, 3, 4, 6, 8)))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda period, _: f"{period:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_title(f"PGA {data['pga_mps2']:.4g} m/s²")
    style.name(figure, data["record"])
    style.note_below(axes, "not in these numbers: ", data.get("left_out", []))
    style.legend_below(figure, *axes.get_legend_handles_labels(), 2)
    style.save(figure, path)
