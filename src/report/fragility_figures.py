"""Figures of how likely a body is to overturn: fragility, and the energy criterion on trial."""

import style
from style import BLUE, BODIES, GREY, INK, ORANGE, PURPLE, VERMILION

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

MEASURES = {"pga": ("PGA", "m/s²"), "pgv": ("PGV", "m/s"), "pgd": ("PGD", "m"), "vector-pga": ("PGA of both axes", "m/s²"),
            "factor": ("factor", ""),
            "v_wes": ("V_WES", "m/s"), "ou_v_e": ("ouV_E", "m/s"), "v_wes_ratio": ("V_WES / V_Ereq", ""),
            "v_wes_other_unit": ("V_WES, other unit of R", "m/s"), "ou_v_e_other_unit": ("ouV_E, other unit of R", "m/s")}
MOST_POINTS = 4000  # of a scatter: more cannot be told apart


def probit_curve(x, median, beta):
    """The lognormal distribution function."""
    from math import erfc, sqrt
    return np.array([0.5 * erfc(-(np.log(v / median)) / (beta * sqrt(2))) for v in x])


def draw_curve(axes, results, fit):
    """The fitted curve, solid where there are data and dashed beyond them, with its band."""
    lowest, highest = fit["data_range"]
    x = np.geomspace(0.5 * lowest, 1.6 * highest, 240)
    p = probit_curve(x, fit["median"], fit["beta"])
    inside = (x >= lowest) & (x <= highest)
    shown, _ = results.in_units(x)
    if fit.get("band"):
        at, _ = results.in_units([point["amplitude"] for point in fit["band"]])
        axes.fill_between(at, [point["lower"] for point in fit["band"]], [point["upper"] for point in fit["band"]],
                          color=BLUE, alpha=0.15, lw=0, zorder=1)
    axes.plot(shown[inside], p[inside], color=BLUE, zorder=3)
    for outside in (x < lowest, x > highest):
        axes.plot(shown[outside], p[outside], color=BLUE, ls=(0, (4, 3)), lw=0.9, zorder=3)


def numbers(rows, key):
    """A column of rows of JSON, NaN where nothing is known."""
    return np.array([np.nan if row[key] is None else row[key] for row in rows], dtype=float)


def fragility(results, fits, stripes, what, path):
    """Stripes with their exact intervals, the lognormal curve, the isotonic estimate, design basis and HCLPF."""
    style.use()
    bodies = results.bodies
    figure, panels = plt.subplots(1, len(bodies), figsize=(1.6 + 3.0 * len(bodies), 3.1), sharey=True,
                                  squeeze=False, layout="constrained")
    for axes, body in zip(panels[0], bodies):
        mine = [s for s in stripes if s["body"] == body.name]
        amplitude, unit = results.in_units(numbers(mine, "amplitude"))
        p, lower, upper = (numbers(mine, key) for key in ("probability", "lower", "upper"))
        known = np.isfinite(p)
        p = p[known]
        bars = np.abs(np.array([p - lower[known], upper[known] - p]))
        axes.errorbar(amplitude[known], p, yerr=bars, fmt="o", ms=3.6, color=INK, elinewidth=0.8, capsize=2, zorder=4)
        fit = fits.get((body.name, results.measure))
        if fit and fit["identifiable"]:
            draw_curve(axes, results, fit)
        if fit and fit.get("isotonic"):
            for block in fit["isotonic"]:
                ends, _ = results.in_units([block["from"], block["to"]])
                axes.plot(ends, [block["probability"]] * 2, color=ORANGE, lw=1.6, marker="_", ms=9, zorder=2)
        lines = [(results.design_basis(body), "design basis", "-")]
        if fit and fit.get("hclpf"):
            lines.append((fit["hclpf"], "HCLPF", "-."))
        for value, label, dash in lines:
            if value is not None:
                at, _ = results.in_units(value)
                axes.axvline(at, color=GREY, lw=0.8, ls=dash, zorder=1)
                axes.annotate(label, (at, 0.97), xytext=(2, 0), textcoords="offset points", rotation=90, va="top",
                              fontsize=6.5, color=GREY)
        axes.set_title(style.literal(body.name))
        axes.set_xlabel(f"{MEASURES[results.measure][0]}" + (f" [{unit}]" if unit else ""))
        axes.set_ylim(-0.03, 1.03)
        axes.set_xlim(0, 1.06 * float(np.max(amplitude)))
    panels[0][0].set_ylabel(style.literal(f"probability of {what}"))
    handles = [Line2D([], [], color=INK, marker="o", ms=3.6, lw=0.8, label="stripe, exact interval"),
               Line2D([], [], color=BLUE, label="lognormal fit"),
               Line2D([], [], color=BLUE, ls=(0, (4, 3)), label="beyond the data"),
               Patch(color=BLUE, alpha=0.15, lw=0, label="its band"),
               Line2D([], [], color=ORANGE, lw=1.6, marker="_", ms=9, label="isotonic estimate")]
    panels[0][-1].legend(handles=handles, loc="center left", bbox_to_anchor=(1.02, 0.5))
    style.save(figure, path)


def responses(results, rows, limits, path):
    """Median, 84 % and 95 % of a response over the levels with their intervals, and the limits set to it."""
    style.use()
    figure, axes = plt.subplots(figsize=(5.6, 2.8), layout="constrained")
    amplitude, unit = results.in_units(numbers(rows, "amplitude"))
    for (key, label), colour in zip((("median", "median"), ("p84", "84 %"), ("p95", "95 %")), (BLUE, ORANGE, VERMILION)):
        value, lower, upper = (numbers([row[key] for row in rows], end) for end in ("value", "lower", "upper"))
        bars = np.nan_to_num(np.abs(np.array([value - lower, upper - value])))
        axes.errorbar(amplitude, value, yerr=bars, fmt="o-", ms=3, color=colour, elinewidth=0.8, capsize=2, label=label)
    for limit in limits:
        axes.axhline(limit["threshold"], color=GREY, lw=0.8, ls="--")
        axes.annotate(style.literal(limit["name"]), (1, limit["threshold"]), xycoords=("axes fraction", "data"),
                      xytext=(-2, 2), textcoords="offset points", ha="right", fontsize=6.5, color=GREY)
    quantity, units = rows[0]["quantity"], rows[0]["units"]
    label = {"peak_slip": "peak slip", "peak_rotation_ratio": "peak rotation / α"}[quantity]
    axes.set(xlabel=MEASURES[results.measure][0] + (f" [{unit}]" if unit else ""),
             ylabel=label + (f" [{units}]" if units != "1" else ""))
    axes.set_xlim(0, 1.06 * float(np.max(amplitude)))
    axes.set_ylim(0, 1.25 if quantity == "peak_rotation_ratio" and np.nanmax(numbers([r["p95"] for r in rows], "value")) > 1.25
                  else None)
    axes.legend(loc="upper left")
    style.save(figure, path)


def sample(count):
    """Which of many points are drawn: evenly spread, always the same."""
    return np.arange(0, count, max(1, -(-count // MOST_POINTS)))


def said(axes, name, ratio, stood, fell, top):
    """How often an energy measure over its limit was what it was, by what came of it."""
    axes.hist([ratio[stood], ratio[fell]], bins=np.linspace(0, 1.03 * top, 36), stacked=True,
              color=[style.SKY, VERMILION], label=["stood", "overturned"])
    axes.axvline(1, color=GREY, lw=0.8, ls="--")
    axes.set(xlim=(0, 1.03 * top), xlabel=f"{name} / V_Ereq", ylabel="trials")


def criterion(results, body, path):
    """V_resp against V_WES, the paper's figure 12, and what V_WES and ouV_E said: where they are wrong, on which side."""
    style.use()
    figure, axes = plt.subplot_mosaic([["response", "window"], ["response", "whole"]], figsize=(6.8, 3.8),
                                      layout="constrained")
    left = axes["response"]
    lost = body.ended("moved") & ~body.ended("decided")  # neither stood nor fell
    moved = body.ended("moved") & body.ended("decided")
    limit = body.trials("v_ereq")
    ratio, response = body.trials("v_wes") / limit, body.trials("v_resp") / limit
    slipped = body.trials("peak_slip") > 0
    fell = body.ended("fell")
    kinds = [("stood", moved & ~fell & ~slipped, BLUE, "o"), ("stood, slipped", moved & ~fell & slipped,
             style.GREEN, "^"), ("overturned", fell, VERMILION, "x"), ("undecided", lost, PURPLE, "v")]
    for label, which, colour, marker in kinds:
        at = np.flatnonzero(which)
        at = at[sample(len(at))] if len(at) else at
        if len(at):
            left.plot(ratio[at], response[at], marker, ms=2.4, mew=0.6, color=colour, alpha=0.5, label=label,
                      rasterized=len(at) > 1000)
    whole = body.trials("ou_v_e") / limit
    top, whole_top = (max(1.2, float(np.nanmax(x[moved])) if moved.any() else 1.2) for x in (ratio, whole))
    left.plot([0, 1], [0, 1], color=GREY, lw=0.8)
    left.axvline(1, color=GREY, lw=0.8, ls="--")
    left.set(xlim=(0, 1.03 * top), ylim=(-0.02, 1.08), xlabel="V_WES / V_Ereq", ylabel="V_resp / V_Ereq",
             title="response against energy offered")
    left.legend(loc="lower right", markerscale=1.6)
    said(axes["window"], "V_WES", ratio, moved & ~fell, fell, top)
    said(axes["whole"], "ouV_E", whole, moved & ~fell, fell, whole_top)
    axes["window"].annotate("criterion", (1, 0.98), xycoords=("data", "axes fraction"), xytext=(3, 0), va="top",
                            textcoords="offset points", color=GREY, fontsize=7)
    axes["window"].set_title("what the energy measures said")
    axes["window"].legend(loc="upper left")
    style.save(figure, path)


def measures(results, fits, path):
    """How far each intensity measure tells overturning from standing: dispersion of its fragility, and ranks (AUC)."""
    style.use()
    names = [name for name in MEASURES if any((body.name, name) in fits for body in results.bodies)]
    figure, (left, right) = plt.subplots(1, 2, figsize=(6.8, 0.9 + 0.34 * len(names)), sharey=True,
                                         layout="constrained")
    drawn = 0
    for b, (body, (colour, _)) in enumerate(zip(results.bodies, BODIES * len(results.bodies))):
        for n, name in enumerate(names):
            fit = fits.get((body.name, name))
            y = n + 0.22 * (b - (len(results.bodies) - 1) / 2)
            if fit and fit["identifiable"]:
                low, high = fit["beta_interval"]
                reach = [[fit["beta"] - low], [(high if high is not None else fit["beta"]) - fit["beta"]]]
                left.errorbar(fit["beta"], y, xerr=np.abs(reach), fmt="o", ms=4, color=colour, elinewidth=0.9, capsize=2)
                drawn += 1
            if fit and fit.get("rank_area") is not None:
                low, high = fit["rank_interval"]
                right.errorbar(fit["rank_area"], y, xerr=np.abs([[fit["rank_area"] - low], [high - fit["rank_area"]]]), fmt="o",
                               ms=4, color=colour, elinewidth=0.9, capsize=2)
    left.set_yticks(range(len(names)), [MEASURES[name][0] for name in names])
    left.invert_yaxis()
    left.set(xlabel="beta of the fit", title="dispersion: less is better")
    left.set_xlim(left=0)
    right.set(xlabel="AUC", title="rank: more is better", xlim=(0.45, 1.02))
    right.legend(handles=[Line2D([], [], color=colour, marker="o", ls="", label=style.literal(body.name))
                          for body, (colour, _) in zip(results.bodies, BODIES)],
                 loc="center left", bbox_to_anchor=(1.02, 0.5))
    if drawn:
        style.save(figure, path)
    else:
        plt.close(figure)
    return drawn > 0
