"""What accuracy costs: for one knob, error against time, the front of what is worth having, and where one stands."""

from . import style
from .style import BLUE, GREY, INK, PALE, VERMILION, number

import matplotlib.pyplot as plt
import numpy as np
from matplotlib import patheffects
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

SMALLEST = 1e-16  # an error of nothing, on a logarithmic axis


def time_text(seconds, _=None):
    for unit, name in ((1, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if seconds >= 0.9995 * unit:
            return f"{seconds / unit:.3g} {name}"
    return f"{seconds * 1e9:.3g} ns"


def log_time_axis(axes, label):
    axes.set_xscale("log")
    low, high = axes.get_xlim()
    subs = (1, 2, 5) if high / low < 300 else (1,)
    axes.xaxis.set_major_locator(LogLocator(subs=subs, numticks=30))
    axes.xaxis.set_major_formatter(FuncFormatter(time_text))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel(label)


def plain_log_axis(axes, label):
    """A logarithmic y axis of plain numbers."""
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_ylabel(label)


def widen(values, share):
    """Limits around positive values, `share` of their span in the logarithm to both sides."""
    low, high = np.log10(min(values)), np.log10(max(values))
    margin = max(share * (high - low), 0.12)
    return 10 ** (low - margin), 10 ** (high + margin)


def place_labels(axes, points):
    """Writes each label beside its point where it covers nothing drawn before; one that finds no room is left out."""
    figure = axes.figure
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    frame = axes.get_window_extent(renderer)
    taken = [axes.transData.transform((x, y)) for x, y, *_ in points]
    boxes = []
    around = ((7, 0, "left", "center"), (-7, 0, "right", "center"), (0, 7, "center", "bottom"),
              (0, -7, "center", "top"), (6, 6, "left", "bottom"), (-6, 6, "right", "bottom"),
              (6, -6, "left", "top"), (-6, -6, "right", "top"))
    for x, y, text, wanted in sorted(points, key=lambda point: -point[3]):
        for dx, dy, ha, va in around:
            label = axes.annotate(text, (x, y), xytext=(dx, dy), textcoords="offset points", ha=ha, va=va, zorder=6,
                                  fontsize=7.5, fontweight="bold" if wanted == 2 else "normal",
                                  color=INK if wanted else GREY,
                                  path_effects=[patheffects.withStroke(linewidth=2.2, foreground="white")])
            box = label.get_window_extent(renderer).expanded(1.02, 1.05)
            free = (not any(box.overlaps(other) for other in boxes) and
                    not any(box.contains(*at) for at in taken) and
                    frame.x0 <= box.x0 and box.x1 <= frame.x1 and frame.y0 <= box.y0 and box.y1 <= frame.y1)
            if free:
                boxes.append(box)
                break
            label.remove()


def draw_knob(axes, knob):
    rows = [row for row in knob["settings"] if row["error_p95"] is not None]
    axes.set_title(knob["title"], pad=6)
    if not rows:
        axes.text(0.5, 0.5, "no trial rocks in both: nothing to compare", ha="center", transform=axes.transAxes)
        axes.set_axis_off()
        return
    time = np.array([row["cpu_s"] for row in rows])
    spread = np.maximum([[row[f"error_{key}"] for key in ("median", "p95", "worst")] for row in rows], SMALLEST)
    for t, (median, _, worst) in zip(time, spread):
        axes.plot([t, t], [median, worst], color=PALE, lw=3.5, solid_capstyle="round", zorder=2)
    floor = knob["floor"]
    if floor > spread[:, 0].min() or floor > spread[:, 1].min():
        axes.axhspan(SMALLEST / 1e3, floor, color=PALE, alpha=0.45, lw=0, zorder=0)
        axes.annotate("shaded: effect of rounding", (0, 0), xycoords="axes fraction", xytext=(4, 4), zorder=1,
                      textcoords="offset points", ha="left", va="bottom", color=GREY, fontsize=7)
    front = sorted((row["cpu_s"], max(row["error_p95"], SMALLEST)) for row in rows if row["on_front"])
    axes.plot(*zip(*front), color=BLUE, lw=1.1, ls="--", zorder=3)
    points = []
    for row, t, (_, p95, _) in zip(rows, time, spread):
        colour = VERMILION if row["here"] else BLUE if row["on_front"] else GREY
        axes.plot(t, p95, "D" if row["here"] else "o", ms=6.5 if row["here"] else 5, color=colour, zorder=5,
                  mfc=colour if row["on_front"] or row["here"] else "white")
        flips = f", {row['flips']} verdict{'' if row['flips'] == 1 else 's'} changed" if row["flips"] else ""
        points.append((t, p95, row["setting"] + flips, 2 if row["here"] else 1 if row["on_front"] else 0))
    axes.set_yscale("log")
    axes.set_xscale("log")
    axes.set_xlim(*widen(time, 0.16))
    axes.set_ylim(*widen(spread.ravel(), 0.08))
    low, high = axes.get_ylim()
    if high / low < 300:
        plain_log_axis(axes, "error")
    log_time_axis(axes, f"CPU time per {knob['timed']}")
    axes.set_ylabel("error")
    place_labels(axes, points)


def draw_waves(axes, data):
    study, parts = data["study"], data["waves"]
    time = np.array([point["cpu_s"] for point in parts])
    width = np.array([point["width"] for point in parts])
    axes.set_title("number of waves", pad=6)
    axes.plot(time, [point["root_n_width"] for point in parts], color=GREY, lw=1, ls="--", label="1/√n")
    axes.plot(time, width, "o-", color=BLUE, ms=5, label=f"{100 * study['confidence']:g} % interval of P(overturn)")
    points = [(t, w, f"{point['waves']}", 1) for t, w, point in zip(time, width, parts)]
    whole = (study["campaign_cpu_s"], 2 * study["campaign_half_width"])
    axes.plot(*whole, "D", ms=6.5, color=VERMILION, zorder=5, label="the campaign, from the sample's probabilities")
    points.append((*whole, f"{study['campaign_waves']} waves", 2))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(*widen([*time, whole[0]], 0.14))
    axes.set_ylim(*widen([*width, whole[1]], 0.16))
    plain_log_axis(axes, "width")
    log_time_axis(axes, "CPU time")
    axes.legend(loc="lower left")
    place_labels(axes, points)


def draw_rare(axes, points):
    """Standard error over probability against time, one line an estimator."""
    axes.set_title("scatter of a rare probability", pad=6)
    looks = {"crude": (GREY, "o", "--"), "subset": (VERMILION, "s", "-"), "pulse-mixture": (BLUE, "D", "-")}
    known = [point for point in points if point["cov"]]
    if not known:
        axes.text(0.5, 0.5, "no estimate was accepted", ha="center", transform=axes.transAxes)
        axes.set_axis_off()
        return
    for method, (colour, marker, line) in looks.items():
        own = sorted((p["cpu_s"], p["cov"]) for p in known if p["method"] == method)
        if own:
            predicted = ", predicted" if method == "crude" else ""
            axes.plot(*zip(*own), color=colour, marker=marker, ls=line, ms=5, lw=1, label=method + predicted)
    axes.set_yscale("log")
    axes.set_xscale("log")
    axes.set_xlim(*widen([p["cpu_s"] for p in known], 0.1))
    axes.set_ylim(*widen([p["cov"] for p in known], 0.1))
    plain_log_axis(axes, "standard error / P")
    log_time_axis(axes, "CPU time")
    axes.legend(loc="best")


def draw_balance(axes, study):
    """The two errors of P(overturn) side by side, on one logarithmic axis."""
    names = ["sampling", "numerical"]
    values = [study["sampling"], study["numerical"]]
    bound = study["numerical_is_bound"]
    for place, (name, value) in enumerate(zip(names, values)):
        larger = value == max(values)
        axes.plot(value, -place, "o", ms=9, color=VERMILION if larger else BLUE,
                  mfc="white" if bound and place == 1 else VERMILION if larger else BLUE, zorder=4)
        axes.annotate(("at most " if bound and place == 1 else "") + number(value, 2), (value, -place), xytext=(0, 9),
                      textcoords="offset points", ha="center", va="bottom")
        if bound and place == 1:
            axes.annotate("", (value / 3, -place), (value, -place), zorder=3,
                          arrowprops={"arrowstyle": "->", "color": BLUE, "lw": 1.2, "shrinkA": 6})
    axes.set_xscale("log")
    axes.set_xlim(*widen(values + [min(values) / 3], 0.15))
    axes.set_ylim(-1.5, 0.7)
    axes.set_yticks([0, -1], names)
    axes.tick_params(axis="y", length=0)
    axes.spines["left"].set_visible(False)
    axes.grid(axis="y", visible=False)
    axes.set_title("error of P(overturn)", pad=6)


def draw(data, path):
    style.use()
    kind = data["kind"]
    figure, axes = plt.subplots(figsize=(6.4, 1.5) if kind == "balance" else (6.4, 3.7), layout="constrained")
    {"knob": draw_knob, "waves": draw_waves, "rare": draw_rare, "balance": draw_balance}[kind](axes, data["data"])
    style.save(figure, path)
