"""Figures of how likely a body is to overturn: fragility, and the energy criterion on trial."""

from . import style
from .style import BLUE, GREY, INK, ORANGE, PURPLE, VERMILION

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

MEASURES = {}  # what axes call each measure: filled from the data of a report
MOST_POINTS = 4000  # of a scatter: more cannot be told apart


def probit_curve(x, median, beta):
    """The lognormal distribution function."""
    from math import erfc, sqrt
    return np.array([0.5 * erfc(-(np.log(v / median)) / (beta * sqrt(2))) for v in x])


def numbers(rows, key):
    """A column of rows of JSON, NaN where nothing is known."""
    return np.array([np.nan if row[key] is None else row[key] for row in rows], dtype=float)


BAND = 0.15  # opacity
FAMILY = (0, (1, 1.5))
FAMILY_MEDIANS = ("median_at_05", "median_at_50", "median_at_95")  # of the curves of 5, 50 and 95 % confidence
MOST_ON_A_PAGE = 4  # bodies, a row each
MOST_COMPARED = 10  # bodies in one picture: more lines are not told apart


def around(fit):
    """Amplitudes from half the lowest to 1.6 times the highest that was tried."""
    return np.geomspace(0.5 * fit["lowest"], 1.6 * fit["highest"], 240)


def draw_curve(axes, results, fit, colour=BLUE, line="-", label=None):
    """Solid where there are data and dashed beyond them."""
    x = around(fit)
    shown, p = results.in_units(x)[0], probit_curve(x, fit["median"], fit["beta"])
    inside = (x >= fit["lowest"]) & (x <= fit["highest"])
    axes.plot(shown[inside], p[inside], color=colour, ls=line, zorder=3, label=label)
    for outside in (x < fit["lowest"], x > fit["highest"]):
        axes.plot(shown[outside], p[outside], color=colour, ls=(0, (4, 3)), lw=0.9, zorder=3)


def draw_band(axes, results, fit, floor):
    at, _ = results.in_units([point["amplitude"] for point in fit["band"]])
    axes.fill_between(at, [max(point["lower"], floor) for point in fit["band"]],
                      [max(point["upper"], floor) for point in fit["band"]], color=BLUE, alpha=BAND, lw=0, zorder=1)


def draw_family(axes, results, fit):
    """The curves believed with 5, 50 and 95 % confidence to lie at or right of the true one: beta_R about medians that
    beta_U scatters."""
    x = around(fit)
    for median in FAMILY_MEDIANS:
        if fit["beta_r"] > 0:
            axes.plot(results.in_units(x)[0], probit_curve(x, fit[median], fit["beta_r"]), color=PURPLE, lw=0.8,
                      ls=FAMILY, zorder=2)


def draw_stripes(axes, results, mine, floor, colour=INK):
    """Shares with their intervals; on a logarithmic axis a triangle at the upper bound where nothing was seen."""
    amplitude, _ = results.in_units(numbers(mine, "amplitude"))
    p, lower, upper = (numbers(mine, key) for key in ("probability", "lower", "upper"))
    shown = np.isfinite(p) & (p > floor)
    bars = np.abs(np.array([p - np.maximum(lower, floor), upper - p]))[:, shown]
    axes.errorbar(amplitude[shown], p[shown], yerr=bars, fmt="o", ms=3.4, color=colour, elinewidth=0.8, capsize=2, zorder=4)
    bound = np.isfinite(p) & ~shown & (floor > 0)
    axes.plot(amplitude[bound], upper[bound], "v", ms=4, mfc="white", color=colour, zorder=4)


def log_floor(stripes, fits):
    """The bottom of a logarithmic axis: below the least share that these stripes could show."""
    trials = [stripe["trials"] for stripe in stripes if stripe["trials"]]
    return 0.3 / max(trials, default=10)


def level_label(results):
    """The levels' measure with the unit that its axis is in."""
    unit = results.in_units(1)[1]
    return MEASURES[results.measure] + (f" [{unit}]" if unit else "")


def level_axis(axes, results, stripes, floor):
    amplitude, _ = results.in_units(numbers(stripes, "amplitude"))
    axes.set_xlabel(level_label(results))
    axes.set_xlim(0, 1.06 * float(np.max(amplitude)))
    if floor > 0:
        axes.set_yscale("log")
        axes.set_ylim(floor, 1.3)
    else:
        axes.set_ylim(-0.03, 1.03)


def fragility(results, bodies, fits, stripes, what, path):
    """A row a body: stripes with their intervals, the lognormal curve, the isotonic estimate, design basis and the lower end of HCLPF,
    over a linear axis and, for the tail, over a logarithmic one."""
    style.use()
    figure, panels = plt.subplots(len(bodies), 2, figsize=(5.8, 0.1 + 2.1 * len(bodies)), squeeze=False, layout="constrained")
    handles = {"stripe with its interval": Line2D([], [], color=INK, marker="o", ms=3.4, lw=0.8)}
    for row, body in zip(panels, bodies):
        mine = [s for s in stripes if s["body"] == body.name]
        fit = fits.get((body.name, results.measure))
        for axes, floor in zip(row, (0, log_floor(mine, fits))):
            draw_stripes(axes, results, mine, floor)
            if any(s["probability"] is not None and s["probability"] <= floor for s in mine) and floor:
                handles["bound where none was seen"] = Line2D([], [], color=INK, marker="v", ms=4, mfc="white", ls="")
            if fit and fit["identifiable"]:
                draw_curve(axes, results, fit)
                handles["lognormal fit"] = Line2D([], [], color=BLUE)
                if fit["beta_u"] > 0 and fit["median_at_50"] is not None:
                    draw_family(axes, results, fit)
                    handles["5, 50, 95 % confidence (beta_U)"] = Line2D([], [], color=PURPLE, lw=0.8, ls=FAMILY)
                handles["beyond the data"] = Line2D([], [], color=BLUE, ls=(0, (4, 3)))
                if fit.get("band"):
                    draw_band(axes, results, fit, floor)
                    handles[f"its {100 * fit['confidence']:g} % band"] = Patch(color=BLUE, alpha=BAND, lw=0)
            for block in (fit or {}).get("isotonic") or []:
                ends, _ = results.in_units([block["from"], block["to"]])
                if block["probability"] > floor or not floor:
                    axes.plot(ends, [block["probability"]] * 2, color=ORANGE, lw=1.6, marker="_", ms=9, zorder=2)
                    handles["isotonic estimate"] = Line2D([], [], color=ORANGE, lw=1.6, marker="_", ms=9)
            for value, label, look in ((results.design_basis(body), "design basis", "-"),
                                       ((fit or {}).get("hclpf_lower"), "HCLPF, lower end", "-."),
                                       ((fit or {}).get("five_percent_point_lower"), "5 % point, lower end", ":")):
                if value:
                    axes.axvline(results.in_units(value)[0], color=GREY, lw=0.8, ls=look, zorder=1)
                    handles[label] = Line2D([], [], color=GREY, lw=0.8, ls=look)
            level_axis(axes, results, mine, floor)
        row[0].set_title(style.literal(body.name))
        for axes in row:  # the right one is read by its own name: it is logarithmic
            axes.set_ylabel(style.literal(f"P of {what}"))
    style.legend_below(figure, list(handles.values()), list(handles))
    style.save(figure, path)


def compared(results, fits, stripes, what, path):
    """The curves of all bodies in one picture, with their stripes; False where there is nothing to compare."""
    bodies = results.bodies
    if not 1 < len(bodies) <= MOST_COMPARED:
        return False
    style.use()
    figure, panels = plt.subplots(1, 2, figsize=(5.8, 2.6), layout="constrained")
    for axes, floor in zip(panels, (0, log_floor(stripes, fits))):
        for body, (colour, line) in zip(bodies, style.looks(len(bodies))):
            fit = fits.get((body.name, results.measure))
            label = style.literal(body.name)
            if fit and fit["identifiable"]:
                draw_curve(axes, results, fit, colour, line, label)
            else:
                axes.plot([], [], color=colour, ls=line, marker="o", ms=3.4, label=f"{label} (no curve)")
            draw_stripes(axes, results, [s for s in stripes if s["body"] == body.name], floor, colour)
        level_axis(axes, results, stripes, floor)
    for axes in panels:
        axes.set_ylabel(style.literal(f"P of {what}"))
    panels[0].set_title("all bodies")
    style.legend_below(figure, *panels[0].get_legend_handles_labels(), columns=2)
    style.save(figure, path)
    return True


FELL = 1.2  # where a percentile that stands for a body that overturned is drawn, in units of alpha


def responses(results, rows, limits, path, overturned):
    """Median, 84 % and 95 % of a response over the levels with their intervals, and the limits set to it. overturned: of each
    percentile, at which levels it is a body that overturned: of a rotation it is drawn as such at the top, of a slip not at all."""
    style.use()
    figure, axes = plt.subplots(figsize=(5.2, 2.3), layout="constrained")
    amplitude, _ = results.in_units(numbers(rows, "amplitude"))
    for (key, label), colour in zip((("median", "median"), ("p84", "84 %"), ("p95", "95 %")), (BLUE, ORANGE, VERMILION)):
        value, lower, upper = (numbers(rows, key + end) for end in ("", "_lower", "_upper"))
        bars = np.nan_to_num(np.abs(np.array([value - lower, upper - value])))
        if np.isfinite(value).any():
            axes.errorbar(amplitude, value, yerr=bars, fmt="o-", ms=3, color=colour, elinewidth=0.8, capsize=2, label=label)
        fell = np.array(overturned[key], dtype=bool)
        if rows[0]["quantity"] == "peak_rotation_ratio" and fell.any():
            axes.plot(amplitude[fell], np.full(fell.sum(), FELL), "^", ms=5, mfc="white", color=colour, label=f"{label}: overturned",
                      zorder=5)
    for n, limit in enumerate(limits):
        axes.axhline(limit["threshold"], color=GREY, lw=0.9, ls=("--", "-.", ":")[n % 3], label=style.literal(f"limit {limit['name']}"))
    quantity, units = rows[0]["quantity"], rows[0]["units"]
    label = {"peak_slip": "peak slip", "peak_rotation_ratio": "peak rotation / α"}[quantity]
    axes.set(xlabel=level_label(results), ylabel=label + (f" [{units}]" if units != "1" else ""))
    axes.set_xlim(0, 1.06 * float(np.max(amplitude)))
    beyond = quantity == "peak_rotation_ratio" and any(map(any, overturned.values()))
    axes.set_ylim(0, 1.06 * FELL if beyond else None)
    style.legend_below(figure, *axes.get_legend_handles_labels())
    style.save(figure, path)


def sample(count):
    """Which of many points are drawn: evenly spread, always the same."""
    return np.arange(0, count, max(1, -(-count // MOST_POINTS)))


def draw_predictions(axes, name, ratio, stood, fell, top):
    """How often an energy measure over its limit was what it was, by what came of it."""
    axes.hist([ratio[stood], ratio[fell]], bins=np.linspace(0, 1.03 * top, 36), stacked=True,
              color=[style.SKY, VERMILION], label=["stood", "overturned"])
    axes.axvline(1, color=GREY, lw=0.8, ls="--")
    axes.set(xlim=(0, 1.03 * top), xlabel=f"{name} / V_Ereq", ylabel="trials")


def criterion(results, body, path):
    """V_resp against V_WES, the paper's figure 12, and what V_WES and ouV_E predicted: where they are wrong, on which side."""
    style.use()
    figure, axes = plt.subplot_mosaic([["response", "response"], ["window", "whole"]], figsize=(5.6, 5.2), height_ratios=[1.5, 1],
                                      layout="constrained")
    left = axes["response"]
    lost = body.ended("moved") & ~body.ended("decided")  # neither stood nor fell
    moved = body.ended("moved") & body.ended("decided")
    limit = body.trials("v_ereq")
    absolute = style.speed_unit() != "m/s"  # as the paper draws it; else in units of V_Ereq
    unit = style.speed(body.numbers["v_ereq_mps"]) if absolute else 1
    ratio, response = body.trials("v_wes") / limit, body.trials("v_resp") / limit
    slipped = body.trials("peak_slip") > 0
    fell = body.ended("fell")
    kinds = [("stood", moved & ~fell & ~slipped, BLUE, "o"), ("stood, slipped", moved & ~fell & slipped,
             style.GREEN, "^"), ("overturned", fell, VERMILION, "x"), ("undecided", lost, PURPLE, "v")]
    for label, which, colour, marker in kinds:
        at = np.flatnonzero(which)
        at = at[sample(len(at))] if len(at) else at
        if len(at):
            left.plot(unit * ratio[at], unit * response[at], marker, ms=2.4, mew=0.6, color=colour, alpha=0.5, label=label,
                      rasterized=len(at) > 1000)
    whole = body.trials("ou_v_e") / limit
    top, whole_top = (max(1.2, float(np.nanmax(x[moved])) if moved.any() else 1.2) for x in (ratio, whole))
    left.plot([0, unit], [0, unit], color=INK, lw=0.9, label="1 : 1")
    left.axvline(unit, color=GREY, lw=0.8, ls="--", label="criterion: V_WES = V_Ereq")
    of = f"[{style.speed_unit()}]" if absolute else "/ V_Ereq"
    left.set(xlim=(0, 1.03 * top * unit), ylim=(-0.02 * unit, 1.08 * unit), xlabel=f"V_WES {of}", ylabel=f"V_resp {of}",
             title="response against window energy")
    draw_predictions(axes["window"], "V_WES", ratio, moved & ~fell, fell, top)
    draw_predictions(axes["whole"], "ouV_E", whole, moved & ~fell, fell, whole_top)
    axes["window"].set_title("trials by energy measure")
    shown = [axes[panel].get_legend_handles_labels() for panel in ("response", "window")]
    style.legend_below(figure, shown[0][0] + shown[1][0], [*shown[0][1], *(f"trials that {w}" for w in shown[1][1])])
    style.save(figure, path)


def measures(results, fits, path):
    """How far each intensity measure tells overturning from standing: dispersion of its fragility, and ranks (AUC)."""
    style.use()
    names = [name for name in MEASURES if any((body.name, name) in fits for body in results.bodies)]
    figure, (left, right) = plt.subplots(1, 2, figsize=(5.6, 0.8 + 0.34 * len(names)), sharey=True,
                                         layout="constrained")
    drawn, hollow = 0, False
    for b, (body, (colour, _)) in enumerate(zip(results.bodies, style.looks(len(results.bodies)))):
        for n, name in enumerate(names):
            fit = fits.get((body.name, name))
            y = n + min(0.22, 0.8 / len(results.bodies)) * (b - (len(results.bodies) - 1) / 2)
            if fit and fit["identifiable"]:
                low, high = fit["beta_lower"], fit["beta_upper"]
                reach = [[fit["beta"] - low], [(high if high is not None else fit["beta"]) - fit["beta"]]]
                rejected = "poor-fit" in fit["flags"]
                left.errorbar(fit["beta"], y, xerr=np.abs(reach), fmt="o", ms=4, color=colour, mfc="white" if rejected else colour,
                              elinewidth=0.9, capsize=2)
                hollow = hollow or rejected
                drawn += 1
            if fit and fit.get("rank_area") is not None:
                low, high = fit["rank_area_lower"], fit["rank_area_upper"]
                right.errorbar(fit["rank_area"], y, xerr=np.abs([[fit["rank_area"] - low], [high - fit["rank_area"]]]), fmt="o",
                               ms=4, color=colour, elinewidth=0.9, capsize=2)
    left.set_yticks(range(len(names)), [MEASURES[name] for name in names])
    left.invert_yaxis()
    left.set(xlabel="beta of the fit", title="dispersion: less is better")
    left.set_xlim(left=0)
    right.set(xlabel="AUC", title="rank: more is better", xlim=(0.45, 1.02))
    handles = {style.literal(body.name): Line2D([], [], color=colour, marker="o", ls="")
               for body, (colour, _) in zip(results.bodies, style.looks(len(results.bodies)))}
    if hollow:
        handles["the data reject the curve"] = Line2D([], [], color=INK, marker="o", mfc="white", ls="")
    style.legend_below(figure, list(handles.values()), list(handles))
    if drawn:
        style.save(figure, path)
    else:
        plt.close(figure)
    return drawn > 0
