"""One wave on one page: its history, what it does to oscillators, and how much energy it offers each body."""

import textwrap

from . import style
from .style import BLUE, BODIES, GREEN, GREY, INK, ORANGE, SKY, number, speed

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter


FURTHER = {"transverse": (GREEN, ":"), "vertical": (SKY, "-.")}  # components beside the rocking plane


def mark_peak(axes, time, values, text):
    """A dot at the largest magnitude, its value beyond the curve."""
    at = int(np.argmax(np.abs(values)))
    up = values[at] >= 0
    axes.plot(time[at], values[at], "o", ms=3.5, color=INK, zorder=5)
    right = time[at] > 0.72 * time[-1]
    axes.annotate(text, (time[at], values[at]), xytext=(-6 if right else 6, 2 if up else -2),
                  textcoords="offset points", ha="right" if right else "left", va="bottom" if up else "top", zorder=6)


def grouped(bodies):
    """Bodies that the energy criterion cannot tell apart (equal radius and height) share one line."""
    groups = {}
    for body in bodies:
        groups.setdefault((body["v_ereq_mps"], body["t0_s"], body["t1_s"]), []).append(body)
    return [{**same[0], "name": ", ".join(style.literal(body["name"]) for body in same)} for same in groups.values()]


def draw_history(axes, time, values, name, unit, peak):
    axes.axhline(0, color=GREY, lw=0.5)
    axes.plot(time, values, color=BLUE, lw=0.6)
    axes.set_ylabel(f"{name}\n{unit}")
    limit = 1.75 * max(np.max(np.abs(values)), 1e-12)  # room for the peak's words
    axes.set_ylim(-limit, limit)
    mark_peak(axes, time, values, peak)


def draw_window_energy(axes, time, bodies, pga_mps2):
    """V_WES(t) of each body against the velocity that overturns it."""
    for body, (colour, line) in zip(bodies, (BODIES * len(bodies))):
        v = speed(np.array(body["v_wes_mps"]))
        peak, limit, unit = v.max(), speed(body["v_ereq_mps"]), style.speed_unit()
        reach = (f"reached at {number(limit / peak)} times this wave, PGA {number(style.shown('acceleration', pga_mps2) * limit / peak)} "
                 f"{style.unit('acceleration')}" if peak > 0 else "")
        axes.plot((time[1] - time[0]) * np.arange(len(v)) if len(time) > 1 else [time[0]] * len(v), v, color=colour, ls=line, lw=1.2,
                  label=f"{body['name']}: at most {number(peak)} {unit}; level line: $V_{{Ereq}}$ {number(limit)} {unit}, {reach}")
        axes.axhline(limit, color=colour, ls=line, lw=0.8, alpha=0.75)
    top = speed(max([max(np.max(b["v_wes_mps"]), b["v_ereq_mps"]) for b in bodies]))
    axes.set_ylim(0, top * (1.2 + 0.12 * len(bodies)))
    axes.set_ylabel(f"$V_{{WES}}$\n{style.speed_unit()}")
    axes.legend(loc="upper left")


def period_axis(axes, periods):
    axes.set_xscale("log")
    axes.set_xlim(periods[0], periods[-1])
    marks = [t for t in (0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20) if periods[0] <= t <= periods[-1]]
    axes.xaxis.set_major_locator(FixedLocator(marks))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda t, _: f"{t:g}"))
    axes.set_xlabel("period, s")


def draw_response(axes, data):
    periods = np.array(data["period_s"])
    damping = f"{100 * data['damping']:g} %"
    target = data.get("target")
    if target:
        t, psa = np.array(target["period_s"]), style.shown("acceleration", np.array(target["psa_mps2"]))
        for band in target["bands"]:
            inside = (t >= band["from_s"]) & (t <= band["to_s"])
            axes.fill_between(t[inside], band["lower"] * psa[inside], band["upper"] * psa[inside], color=ORANGE,
                              alpha=0.28, lw=0, label=band["name"])
        axes.plot(t, psa, color=INK, lw=1.0, ls="--", label=f"target {target['name']}")
    axes.plot(periods, style.shown("acceleration", np.array(data["psa_mps2"])), color=BLUE, lw=1.2, label=f"this wave, {damping}")
    for component in data["further"]:
        colour, line = FURTHER[component["name"]]
        axes.plot(periods, style.shown("acceleration", np.array(component["psa_mps2"])), color=colour, lw=0.9, ls=line, label=f"{component['name']} component")
    axes.set_yscale("log")
    top = style.shown("acceleration", max(data["psa_mps2"] + (target["psa_mps2"] if target else [])))
    axes.set_ylim(max(style.shown("acceleration", min(data["psa_mps2"])) / 1.5, top / 3e4), 2.2 * top)
    axes.set_ylabel(f"pseudo-acceleration, {style.unit('acceleration')}")
    axes.set_title(f"Response spectrum, {damping} of critical damping", pad=17)
    period_axis(axes, periods)
    axes.legend(loc="lower left")


def draw_energy(axes, data, bodies):
    periods = np.array(data["period_s"])
    highest = speed(max(max(data["v_e0_mps"]), 1e-12))
    top = highest * (1.05 + 0.09 * len(bodies))
    for row, (body, (colour, _)) in enumerate(zip(bodies, BODIES * len(bodies))):
        y = highest * (1.06 + 0.09 * row)
        axes.plot([body["t0_s"], body["t1_s"]], [y, y], color=colour, lw=2.2, solid_capstyle="butt")
        axes.annotate(f"$T_0$ to $T_1$, {body['name']}", (body["t1_s"], y), xytext=(0, 2), textcoords="offset points",
                      ha="right", va="bottom", color=colour, fontsize=7)
    axes.plot(periods, speed(np.array(data["v_e0_mps"])), color=GREY, lw=0.6, label="Fourier amplitude = $V_{E0}$")
    axes.plot(periods, speed(np.array(data["v_e_mps"])), color=BLUE, lw=1.4, label=f"$V_E$, {100 * data['energy_damping']:g} % damping")
    target = data.get("energy_target")
    if target:
        axes.plot(target["period_s"], speed(np.array(target["v_e_mps"])), color=INK, lw=1.0, ls="--", label=f"target {target['name']}")
        top = max(top, speed(1.05 * max(target["v_e_mps"])))
    axes.set_ylim(0, top)
    axes.set_ylabel(f"equivalent velocity, {style.speed_unit()}")
    axes.set_title("Fourier and input energy spectra", pad=28 if target else 17)
    period_axis(axes, periods)
    axes.legend(loc="lower left", bbox_to_anchor=(-0.02, 0.995), ncol=2, columnspacing=1.0, handlelength=1.6)


def rows_of(data, bodies):
    return (["acceleration"] + [component["name"] for component in data["further"]] + ["velocity", "displacement"]
            + (["energy"] if bodies else []))


def heights_of(rows):
    return [{"acceleration": 1.5, "energy": 1.9}.get(row, 1.0) for row in rows]


def draw_rows(figure, grid, rows, data, bodies):
    """The wave over time, and how much energy it offers."""
    axes = {}
    for place, row in enumerate(rows):
        axes[row] = figure.add_subplot(grid[place, :], sharex=axes.get("acceleration"))
        axes[row].tick_params(labelbottom=row == rows[-1])
    time = data["time_step_s"] * np.arange(len(data["acceleration_mps2"]))
    unit = style.unit("acceleration")
    in_gal = f" = {number(100 * data['pga_mps2'], 4)} gal" if unit == "m/s²" else ""
    draw_history(axes["acceleration"], time, style.shown("acceleration", np.array(data["acceleration_mps2"])), "acceleration", unit,
                 f"PGA {number(style.shown('acceleration', data['pga_mps2']))} {unit}{in_gal}")
    axes["acceleration"].set_title(textwrap.fill(data["subtitle"], 125), fontsize=7.5, fontweight="normal", color=GREY)
    for component in data["further"]:
        values = style.shown("acceleration", np.array(component["acceleration_mps2"]))
        draw_history(axes[component["name"]], time, values, component["name"], unit, f"{number(np.max(np.abs(values)))} {unit}")
    draw_history(axes["velocity"], time, speed(np.array(data["velocity_mps"])), "velocity", style.speed_unit(),
                 f"PGV {number(speed(data['pgv_mps']))} {style.speed_unit()}")
    draw_history(axes["displacement"], time, style.shown("length", np.array(data["displacement_m"])), "displacement", style.unit("length"),
                 f"PGD {number(style.shown('length', data['pgd_m']))} {style.unit('length')}")
    if bodies:
        draw_window_energy(axes["energy"], time, bodies, data["pga_mps2"])
        axes["energy"].set_title("Window energy spectrum against the limit velocity", pad=3)
    axes["acceleration"].set_xlim(0, time[-1])
    axes[rows[-1]].set_xlabel("time, s")
    figure.align_ylabels(list(axes.values()))


def head(figure, data, what=""):
    figure.suptitle(textwrap.shorten(data["title"] + what, 95), x=0.012, ha="left", fontsize=10.5, fontweight="bold")


def draw(data, path):
    """All of it on one sheet."""
    style.use()
    bodies = grouped(data["bodies"])
    rows = rows_of(data, bodies)
    heights = heights_of(rows) + [3.1]
    figure = plt.figure(figsize=(8.27, 1.25 + 1.12 * sum(heights)), layout="constrained")
    grid = figure.add_gridspec(len(heights), 2, height_ratios=heights)
    draw_rows(figure, grid, rows, data, bodies)
    draw_response(figure.add_subplot(grid[-1, 0]), data)
    draw_energy(figure.add_subplot(grid[-1, 1]), data, bodies)
    head(figure, data)
    style.save(figure, path)


def draw_histories(data, path):
    """For a page: half a sheet."""
    style.use()
    bodies = grouped(data["bodies"])
    rows = rows_of(data, bodies)
    heights = heights_of(rows)
    figure = plt.figure(figsize=(8.27, 0.9 + 0.85 * sum(heights)), layout="constrained")
    draw_rows(figure, figure.add_gridspec(len(heights), 1, height_ratios=heights), rows, data, bodies)
    head(figure, data)
    style.save(figure, path)


def draw_spectra(data, path):
    """For a page: its spectra alone."""
    style.use()
    figure, (response, energy) = plt.subplots(1, 2, figsize=(8.27, 3.9), layout="constrained")
    draw_response(response, data)
    draw_energy(energy, data, grouped(data["bodies"]))
    head(figure, data, ": spectra")
    style.save(figure, path)
