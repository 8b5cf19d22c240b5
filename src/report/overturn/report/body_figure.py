"""The bodies to one scale: base, outline, centre of gravity and critical angle."""

import textwrap

from . import style
from .style import BLUE, GREY, INK, VERMILION

import matplotlib.pyplot as plt
import numpy as np
from matplotlib import patheffects
from matplotlib.patches import Rectangle

MOST_ON_A_PAGE = 8
MOST_IN_A_ROW = 2  # of bodies, so that they can be told on a phone


class Shifted:
    """Draws on axes with the ground at another height."""

    def __init__(self, axes, ground):
        self.axes, self.ground = axes, ground

    def add_patch(self, patch):
        patch.set_y(patch.get_y() + self.ground)
        self.axes.add_patch(patch)

    def plot(self, x, y, *look, **looks):
        self.axes.plot(x, np.asarray(y) + self.ground, *look, **looks)

    def say(self, text, at, shift, **looks):
        halo = [patheffects.withStroke(linewidth=2, foreground="white", alpha=0.8)]
        self.axes.annotate(text, (at[0], at[1] + self.ground), xytext=shift, textcoords="offset points", zorder=6,
                           path_effects=halo, **looks)


def outline(axes, x, body, parts):
    """What a body is assembled from; without parts a block about its centre of gravity, dashed. Its top."""
    b, h = body.numbers["half_width_m"], body.numbers["centre_height_m"]
    if not parts:
        axes.add_patch(Rectangle((x - b, 0), 2 * b, 2 * h, facecolor="#eef2f5", edgecolor=GREY, lw=0.8, ls=(0, (4, 3))))
        return 2 * h
    for width, height, bottom in parts:
        if width > 0:
            axes.add_patch(Rectangle((x - width / 2, bottom), width, height, facecolor="#e3eaf0", edgecolor=INK, lw=0.9))
        else:
            axes.plot(x, bottom, "D", ms=4, color=INK, zorder=4)
    return max(bottom + height for _, height, bottom in parts)


def top_of(body, parts):
    return max((bottom + height for _, height, bottom in parts), default=2 * body.numbers["centre_height_m"])


def draw(bodies, parts, path):
    """Each body to one scale: base, outline, centre of gravity, critical angle."""
    style.use()
    all_parts = [parts.get(body.name, []) for body in bodies]
    widest = max(max([2 * body.numbers["half_width_m"], *(width for width, _, _ in own)]) for body, own in zip(bodies, all_parts))
    tallest = max(top_of(body, own) for body, own in zip(bodies, all_parts))
    columns = min(len(bodies), MOST_IN_A_ROW)
    rows = -(-len(bodies) // columns)
    pitch, step = 2.1 * max(widest, 0.75 * tallest), 1.5 * tallest
    across, up = columns * pitch, rows * step
    width = 2.7 * columns
    figure, axes = plt.subplots(figsize=(width, width * up / across))
    figure.subplots_adjust(left=0, right=1, bottom=0, top=1)
    for k, (body, own) in enumerate(zip(bodies, all_parts)):
        b, h, alpha = (body.numbers[key] for key in ("half_width_m", "centre_height_m", "alpha_rad"))
        x, y = (k % columns) * pitch, -(k // columns) * step
        shifted = Shifted(axes, y)
        top = outline(shifted, x, body, own)
        shifted.plot([x - b, x + b], [0, 0], color=INK, lw=2.4, solid_capstyle="butt")
        shifted.plot([x, x + b], [h, 0], color=BLUE, lw=1)
        shifted.plot([x + b, x + b], [0, 1.25 * h], color=BLUE, lw=0.7, ls="--")
        shifted.plot([x - 0.45 * pitch, x + 0.45 * pitch], [0, 0], color=GREY, lw=0.6, zorder=0)
        shifted.plot(x, h, "o", ms=5, color=VERMILION, zorder=5)
        beside = max([b, *(width / 2 for width, _, _ in own)])
        shifted.plot([x - beside, x], [h, h], color=GREY, lw=0.5)
        length, unit = (lambda si: style.shown("length", si)), style.unit("length")
        shifted.say(f"h {length(h):.4g} {unit}", (x - beside, h), (-4, 0), ha="right", va="center")
        shifted.say(f"R {length(np.hypot(b, h)):.4g} {unit}", (x + beside, 0.45 * h), (4, 0), ha="left", va="center", color=BLUE)
        shifted.say(f"α {np.degrees(alpha):.1f}°", (x + beside, 1.25 * h), (4, 0), ha="left", va="center", color=BLUE)
        shifted.say(f"2b {length(2 * b):.4g} {unit}", (x, 0), (0, -4), ha="center", va="top")
        shifted.say(style.literal(textwrap.shorten(body.name, 40)), (x, top), (0, 5), ha="center", va="bottom", weight="bold")
    axes.set_xlim(-0.5 * pitch, (columns - 0.5) * pitch)
    axes.set_ylim(-(rows - 1) * step - 0.22 * tallest, 1.25 * tallest)
    axes.set_aspect("equal")
    axes.set_axis_off()
    style.save(figure, path)
