"""The overturning spectrum of a pulse as the papers draw it: amplitude over alpha g against omega/p, where the block
stands, and where it overturns with an impact and without."""

from . import style
from .style import BLUE, GREY, INK, ORANGE, PALE, VERMILION

import matplotlib.pyplot as plt
import numpy as np

FATES = {"overturns-with-impact": (ORANGE, "overturns after an impact"),
         "overturns-without-impact": (VERMILION, "overturns without an impact"),
         "undecided": (PALE, "leaves the ground: undecided")}


def edges_of(ratios):
    """Of columns about each ratio, half way to its neighbours."""
    if len(ratios) == 1:
        return 0.95 * ratios, 1.05 * ratios
    middles = 0.5 * (ratios[1:] + ratios[:-1])
    return np.concatenate([ratios[:1], middles]), np.concatenate([middles, ratios[-1:]])


def unbroken(ratios, least, points):
    """The least amplitude with a gap where it jumps to another branch of the boundary."""
    first = [next((r["fate"] for r in point["ranges"] if r["fate"].startswith("overturns")), None) for point in points]
    jumps = [n for n in range(1, len(first)) if first[n] != first[n - 1]]
    return np.insert(ratios, jumps, np.nan), np.insert(least, jumps, np.nan)


def draw(data, path):
    style.use()
    points = sorted(data["points"], key=lambda point: point["omega_over_p"])
    ratios = np.array([point["omega_over_p"] for point in points])
    left, right = edges_of(ratios)
    figure, axes = plt.subplots(figsize=(5.8, 4.2), layout="constrained")
    for fate, (colour, label) in FATES.items():
        bars = [(x, y - x, r["from_over_alpha_g"], r["to_over_alpha_g"] - r["from_over_alpha_g"])
                for point, x, y in zip(points, left, right) for r in point["ranges"] if r["fate"] == fate]
        if bars:
            x, width, bottom, height = np.array(bars).T
            axes.bar(x, height, width, bottom, align="edge", color=colour, lw=0, label=label)
    axes.plot(ratios, [point["uplift_mps2"] / data["alpha_g_mps2"] for point in points], color=INK, lw=1, ls="--",
              label="uplift")
    least = np.array([point["overturning_over_alpha_g"] for point in points], dtype=float)
    axes.plot(*unbroken(ratios, least, points), color=INK, lw=1.2, marker=".", ms=3, label="least that overturns")
    if "closed_form_over_alpha_g" in points[0]:
        axes.plot(ratios, [point["closed_form_over_alpha_g"] for point in points], "o", ms=4, mfc="none", color=BLUE,
                  label="without an impact, closed form")
    axes.plot([], [], "s", ms=7, mfc="white", mec=GREY, label="stands")
    if np.isfinite(least).any():  # so high as its notch is; no higher than the scan went
        seen = [r["from_over_alpha_g"] for point in points for r in point["ranges"]]
        tried = [point["ranges"][-1]["to_over_alpha_g"] for point in points if point["ranges"]]
        axes.set_ylim(0, min(1.15 * max(seen), *tried))
    axes.set(xlabel=r"$\omega / p$", ylabel=r"amplitude over $\alpha g$", xlim=(left[0], right[-1]))
    degrees = np.degrees(data["alpha_rad"])
    pulse = data["shaking"]
    if "gamma" in data:
        pulse += rf" ($\gamma$ {data['gamma']:.4g}, $\nu$ {np.degrees(data['phase_rad']):.4g}°)"
    axes.set_title(f"{pulse}: " + rf"$\alpha$ {degrees:.4g}°, $p$ {data['p_radps']:.4g} rad/s, "
                   f"$e$ {data['restitution']:.3g}{', linearised' if data['linearised'] else ''}")
    style.name(figure, data["body"])
    style.note_below(axes, "not in these numbers: ", data.get("left_out", []))
    style.legend_below(figure, *axes.get_legend_handles_labels(), 2)
    style.save(figure, path)
