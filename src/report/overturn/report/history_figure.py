"""The history of one trial: the wave, what the body did, its energy beside what the wave offered, and its contact with
the ground, all over one time."""

import textwrap

from . import style
from .style import BLUE, GREEN, GREY, INK, ORANGE, PURPLE, SKY, VERMILION, plain, speed

import matplotlib.pyplot as plt
import numpy as np

COMPONENTS = {"horizontal": (BLUE, 0.7), "transverse": (GREEN, 0.5), "vertical": (SKY, 0.5)}
HIGHEST_TILT = 1.5  # of alpha: beyond it a body falls, and its way down would flatten what came before


def draw_wave(axes, wave):
    for component in reversed(wave):
        colour, width = COMPONENTS[component["name"]]
        values = style.shown("acceleration", np.asarray(component["values"], dtype=float))
        axes.plot(component["time_s"], values, color=colour, lw=width,
                  label=f"{component['name']}, {plain(np.max(np.abs(values)))} {style.unit('acceleration')}")
    axes.set_ylabel(f"wave\n[{style.unit('acceleration')}]")
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles[::-1], labels[::-1], loc="lower right", ncols=3, bbox_to_anchor=(1, 0.98))


def draw_tilt(axes, time, tilt):
    highest = min(np.max(np.abs(tilt)), HIGHEST_TILT)
    axes.axhline(0, color=GREY, lw=0.5)
    for limit in ((1, -1) if np.min(tilt) < 0 else (1,)):
        if highest > 0.5:
            axes.axhline(limit, color=VERMILION, lw=0.7, ls="--")
    axes.plot(time, tilt, color=BLUE, lw=0.8)
    reach = 1.15 * max(highest, 1e-3)
    axes.set_ylim(-reach if np.min(tilt) < 0 else -0.05 * reach, reach)
    axes.set_ylabel("rotation / α")


def draw_energy(axes, time, data):
    """What the wave offered within its window against what the body held: the paper's figure 11."""
    limit, answer = speed(data["v_ereq_mps"]), speed(np.asarray(data["channels"]["v_resp_mps"], dtype=float))
    unit = style.speed_unit()
    tops = [np.max(answer)]
    if "v_wes" in data:
        offered = speed(np.asarray(data["v_wes"]["values"], dtype=float))
        tops.append(np.max(offered))
        axes.plot(data["v_wes"]["time_s"], offered, color=INK, lw=1.0,
                  label=f"$V_{{WES}}$, at most {plain(tops[1])} {unit}")
    axes.plot(time, answer, color=GREEN, lw=0.8, label=f"$V_{{resp}}$, at most {plain(tops[0])} {unit}")
    if max(tops) > 0.3 * limit:
        axes.axhline(limit, color=VERMILION, lw=0.7, ls="--", label=f"$V_{{Ereq}}$ {plain(limit)} {unit}")
        tops.append(limit)
    axes.set_ylim(0, 1.1 * max(*tops, 1e-9))
    axes.set_ylabel(f"velocity\n[{unit}]")
    axes.legend(loc="lower right", ncols=3, bbox_to_anchor=(1, 0.98))


def draw_quantity(axes, time, values, label, colour):
    known = np.isfinite(values)
    axes.plot(time[known], values[known], color=colour, lw=0.8)
    if known.any() and np.min(values[known]) >= 0:
        axes.set_ylim(0, 1.1 * max(float(np.max(values[known])), 1e-9))
    axes.set_ylabel(label)


def plan(axes, channels, outline):
    """Where the base began and ended, seen from above, and the way of its corners (of a rim: four points)."""
    yaw, x, y = channels["yaw_rad"], style.shown("length", channels["x_m"]), style.shown("length", channels["y_m"])
    traced = outline if len(outline) <= 8 else outline[::len(outline) // 4]
    for corner in traced:
        axes.plot(x + np.cos(yaw) * corner[0] - np.sin(yaw) * corner[1],
                  y + np.sin(yaw) * corner[0] + np.cos(yaw) * corner[1], color=SKY, lw=0.6)
    for at, colour in ((0, GREY), (-1, VERMILION)):
        turned = np.column_stack([np.cos(yaw[at]) * outline[:, 0] - np.sin(yaw[at]) * outline[:, 1] + x[at],
                                  np.sin(yaw[at]) * outline[:, 0] + np.cos(yaw[at]) * outline[:, 1] + y[at]])
        closed = np.vstack([turned, turned[:1]])
        axes.plot(closed[:, 0], closed[:, 1], color=colour, lw=1.1, label="before" if at == 0 else "after")
    axes.set_aspect("equal", adjustable="datalim")
    axes.set(xlabel=f"x [{style.unit('length')}]", ylabel=f"y [{style.unit('length')}]", title="base in plan")
    axes.legend(loc="upper right")


def quantities(channels):
    """What there is to draw beside wave, rotation and energy: values, label, colour."""
    slip = channels.get("slip_m", np.zeros(1))
    if "y_m" in channels:
        slip = np.hypot(channels["x_m"], channels["y_m"])
    if np.any(slip != 0):
        what = "base moved" if "y_m" in channels else "slip"
        yield style.shown("slip", slip), f"{what}\n[{style.unit('slip')}]", ORANGE
    if "contact_force_over_weight" in channels:
        yield channels["contact_force_over_weight"], "N / (m g)", PURPLE
    if np.any(channels.get("crush_m", np.zeros(1)) > 0):
        yield style.shown("slip", channels["crush_m"]), f"crush\n[{style.unit('slip')}]", SKY


def has_plan(data):
    return "y_m" in data["channels"]


def head(figure, data):
    figure.suptitle(style.literal(textwrap.fill(data["title"], 92)), x=0.012, ha="left", fontsize=8.5, fontweight="bold")


def draw_plan(data, path):
    """The base in plan alone, for a page."""
    style.use()
    figure, axes = plt.subplots(figsize=(6.8, 3.3), layout="constrained")
    channels = {key: np.asarray(values, dtype=float) for key, values in data["channels"].items()}
    plan(axes, channels, style.shown("length", np.asarray(data["outline"])))
    head(figure, data)
    style.save(figure, path)


def draw(data, path, with_plan=True):
    style.use()
    channels = {key: np.asarray(values, dtype=float) for key, values in data["channels"].items()}
    time = channels["time_s"]
    tilt = channels["tilt_rad"] if "tilt_rad" in channels else channels["rotation_rad"]
    further = list(quantities(channels))
    spatial = with_plan and has_plan(data)
    heights = [1, 1.35, 1.25] + [0.8] * len(further) + ([2.6] if spatial else [])
    figure = plt.figure(figsize=(6.8, 0.9 + 0.92 * sum(heights)), layout="constrained")
    grid = figure.add_gridspec(len(heights), 1, height_ratios=heights)
    panels, count = [], 3 + len(further)
    for row in range(count):
        panels.append(figure.add_subplot(grid[row], sharex=panels[0] if panels else None))
        panels[-1].tick_params(labelbottom=row == count - 1)
    draw_wave(panels[0], data["wave"])
    draw_tilt(panels[1], time, tilt / data["alpha"])
    draw_energy(panels[2], time, data)
    for axes, (values, label, colour) in zip(panels[3:], further):
        draw_quantity(axes, time, values, label, colour)
    panels[0].set_xlim(0, max(time[-1], data["wave"][0]["time_s"][-1]))
    panels[-1].set_xlabel("time [s]")
    figure.align_ylabels(panels)
    if spatial:
        plan(figure.add_subplot(grid[count]), channels, style.shown("length", np.asarray(data["outline"])))
    head(figure, data)
    style.save(figure, path)
