"""Spectra of many waves in one axes each: V_E, as the paper's figures 7 and 8, and Sa beside what they were drawn for."""

import textwrap

from . import style
from .style import BLUE, BODIES, GREEN, GREY, INK, ORANGE, SERIES

import matplotlib.pyplot as plt
import numpy as np

from .wave_figure import grouped, period_axis

MOST_NAMED = 12  # waves with a colour and a name of their own


def named(label):
    """A record by its file's name, without the folder and what was done to it."""
    return style.literal(textwrap.shorten(label.split(",")[0].rsplit("/", 1)[-1].rsplit("\\", 1)[-1], 44))


def draw_each(axes, data, key, factor):
    periods, few = data["period_s"], len(data["each"]) <= MOST_NAMED
    for row, wave in enumerate(data["each"]):
        values = factor * np.array(wave[key])
        if few:
            axes.plot(periods, values, color=SERIES[row % len(SERIES)], ls="-" if row < len(SERIES) else "--", lw=1.0,
                      label=named(wave["label"]))
        else:
            axes.plot(periods, values, color=GREY, lw=0.35, alpha=0.6, label="each wave" if row == 0 else None)


def draw_bodies(axes, data, top):
    """Where each body rocks."""
    bodies = grouped(data["bodies"])
    for row, (body, (colour, _)) in enumerate(zip(bodies, BODIES * len(bodies))):
        y = top * (1.05 + 0.075 * row)
        axes.plot([body["t0_s"], body["t1_s"]], [y, y], color=colour, lw=2.2, solid_capstyle="butt")
        name = textwrap.shorten(body["name"], 40)
        axes.annotate(f"$T_0$ to $T_1$, {name}", (body["t1_s"], y), xytext=(0, 2), textcoords="offset points", ha="right",
                      va="bottom", color=colour, fontsize=7)
    axes.set_ylim(0, top * (1.1 + 0.075 * len(bodies)))


def draw_band(axes, periods, band, colour, name, dashes="-"):
    """16 %, 50 % and 84 %."""
    for key, width in (("p16", 0.9), ("p50", 1.7), ("p84", 0.9)):
        axes.plot(periods, np.array(band[key], dtype=float), color=colour, ls=dashes, lw=width,
                  label=name if key == "p50" else None)


def draw(data, path):
    style.use()
    periods, few = np.array(data["period_s"]), len(data["each"]) <= MOST_NAMED
    figure, (energy, response) = plt.subplots(1, 2, figsize=(8.27, 4.1), layout="constrained")
    draw_each(energy, data, "v_e_mps", style.speed(1))
    if not few:
        draw_band(energy, periods, {key: style.speed(np.array(values)) for key, values in data["v_e_mps"].items()}, BLUE,
                  "16 %, 50 %, 84 % of the waves")
    draw_bodies(energy, data, style.speed(max(data["v_e_mps"]["highest"])))
    energy.set_ylabel(f"$V_E$, {style.speed_unit()}")
    energy.set_title(f"Input energy, {100 * data['energy_damping']:g} % damping")
    in_unit = lambda values: style.shown("acceleration", np.array(values, dtype=float))  # noqa: E731
    draw_each(response, data, "psa_mps2", style.shown("acceleration", 1))
    if not few:
        draw_band(response, periods, {key: in_unit(values) for key, values in data["psa_mps2"].items()}, BLUE, "16 %, 50 %, 84 % of the waves")
    target = data["target"]
    if target:
        drawn = target["drawn_psa_mps2"]
        if drawn:
            draw_band(response, periods, {key: in_unit(values) for key, values in drawn.items()}, ORANGE, "16 %, 50 %, 84 % of their targets", "--")
        response.plot(periods, in_unit(target["psa_mps2"]), color=GREEN if drawn else INK, lw=1.2, ls=":" if drawn else "--",
                      label=f"target {target['name']}" + (", their median as stated" if drawn else ""))
    response.set_yscale("log")
    top = in_unit(max(data["psa_mps2"]["highest"]))
    response.set_ylim(max(in_unit(min(data["psa_mps2"]["lowest"])) / 4, top / 3e4), 2 * top)
    response.set_ylabel(f"pseudo-acceleration, {style.unit('acceleration')}")
    response.set_title(f"Response, {100 * data['damping']:g} % damping")
    for axes in (energy, response):
        period_axis(axes, periods)
    handles, labels = response.get_legend_handles_labels()
    style.legend_below(figure, handles, labels, 3)
    figure.suptitle(style.literal(textwrap.shorten(f"{data['title'] or 'Waves'}: {data['waves']} waves, unscaled", 95)), x=0.012,
                    ha="left", fontsize=10, fontweight="bold")
    style.save(figure, path)
