"""What waves on a grid of frequencies did: the map of outcomes over frequency and level, in place of fragility curves."""

from . import style
from .fragility_figures import level_label
from .page_parts import in_pages, paragraphs, table
from .style import BLUE, GREEN, INK, plain
from .trial_figures import ENDS

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

MOST_ON_A_PAGE = 4  # bodies, a panel each
LIMITS = [GREEN, style.PURPLE, style.ORANGE]  # boundaries of the campaign's own limit states, in turn


def edges(values):
    """Where cells around rising values end."""
    if len(values) == 1:
        return np.array([values[0] - 0.5, values[0] + 0.5])
    middle = (values[1:] + values[:-1]) / 2
    return np.concatenate([[2 * values[0] - middle[0]], middle, [2 * values[-1] - middle[-1]]])


def ends_of(line):
    """How its trials ended, level by level."""
    return [at["verdict"] for at in line["levels"]]


def steady_of(line):
    """The steady rotation over alpha, level by level."""
    return [at["steady_rotation_ratio"] for at in line["levels"]]


def limits_of(lines):
    """The campaign's own limit states."""
    return [key.removeprefix("limit_") for key in lines[0] if key.startswith("limit_")]


def distinct(lines):
    """By rising frequency, one each: of several at a frequency the one that overturns first."""
    order = sorted(lines, key=lambda line: (line["frequency_hz"], np.inf if line["overturning"] is None else line["overturning"]))
    return [line for k, line in enumerate(order) if k == 0 or line["frequency_hz"] != order[k - 1]["frequency_hz"]]


def frequency_axis(axes, frequency):
    axes.set_xscale("log")
    axes.set_xlabel("frequency [Hz]")
    axes.xaxis.set_major_locator(FixedLocator(frequency[::max(1, -(-len(frequency) // 9))]))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda f, _: f"{f:.3g}"))


def boundary(axes, across, up, levels, lines, value, **look):
    """The lower edge of the cells of the least level, frequency by frequency; none where no level did it."""
    for k, line in enumerate(lines):
        if value(line) is not None:
            at = up[int(np.argmin(np.abs(levels - value(line))))]
            axes.plot(across[k:k + 2], [at, at], solid_capstyle="butt", **look)


def draw(results, bodies, lines, path):
    """One panel a body: how each trial ended, and from which level on it lifts off, overturns and passes its limits."""
    style.use()
    figure, panels = plt.subplots(len(bodies), 1, figsize=(5.0, 0.1 + 2.2 * len(bodies)), squeeze=False, layout="constrained")
    known, limits = list(ENDS), limits_of(lines)
    used = {}
    for axes, body in zip(panels[:, 0], bodies):
        mine = distinct([line for line in lines if line["body"] == body.name])
        levels, _ = results.in_units(body.stripes["amplitude"])
        names = [name for name in known if any(name in ends_of(line) for line in mine)]
        names += sorted({end for line in mine for end in ends_of(line)} - set(known))
        colours = [ENDS.get(name, GREEN) for name in names]
        cells = np.array([[names.index(end) for end in ends_of(line)] for line in mine]).T
        frequency = np.array([line["frequency_hz"] for line in mine])
        across, up = np.exp(edges(np.log(frequency))), edges(levels)
        axes.pcolormesh(across, up, cells, cmap=ListedColormap(colours), vmin=-0.5, vmax=len(names) - 0.5, edgecolors="white",
                        linewidth=0.6)
        used.update(zip(names, colours))

        def shown(key):
            return lambda line: (lambda v: None if v is None else float(results.in_units(v)[0]))(line[key])
        boundary(axes, across, up, levels, mine, shown("uplift"), color=BLUE, lw=2.2)
        for limit, colour in zip(limits, LIMITS * len(limits)):
            boundary(axes, across, up, levels, mine, shown(f"limit_{limit}"), color=colour, lw=1.8, ls="--")
        boundary(axes, across, up, levels, mine, shown("overturning"), color=INK, lw=2.2)
        frequency_axis(axes, frequency)
        axes.set_xlim(across[0], across[-1])
        axes.set_ylim(up[0], up[-1])
        axes.grid(visible=False)
        axes.set(title=style.literal(body.name), ylabel=level_label(results))
    handles = {name: Patch(color=colour) for name, colour in used.items()}
    handles["lifts off from here"] = Line2D([], [], color=BLUE, lw=2.2)
    handles["overturns from here"] = Line2D([], [], color=INK, lw=2.2)
    for limit, colour in zip(limits, LIMITS * len(limits)):
        handles[style.literal(f"exceeds {limit} from here")] = Line2D([], [], color=colour, lw=1.8, ls="--")
    style.legend_below(figure, list(handles.values()), list(handles))
    style.save(figure, path)


def steady(results, bodies, lines, path):
    """Peak rotations of what stood over frequency, a colour a level, and the steady ones of the paper's Eq. 1; False where
    no level has one."""
    mine = {body.name: distinct([line for line in lines if line["body"] == body.name]) for body in bodies}
    if not any(value is not None for of_body in mine.values() for line in of_body for value in steady_of(line)):
        return False
    style.use()
    figure, panels = plt.subplots(len(bodies), 1, figsize=(5.0, 0.1 + 2.4 * len(bodies)), squeeze=False, layout="constrained")
    handles = {"peak of a trial that stood": Line2D([], [], color=INK, marker="o", ms=3.4, ls=""),
               "steady state by Eq. 1": Line2D([], [], color=INK)}
    for axes, body in zip(panels[:, 0], bodies):
        levels, unit = results.in_units(body.stripes["amplitude"])
        frequency = np.array([line["frequency_hz"] for line in mine[body.name]])
        which = {int(wave): place for place, wave in enumerate(line["wave"] for line in mine[body.name])}
        peaks = np.full((len(frequency), len(levels)), np.nan)
        stood = body.ended("moved") & body.ended("decided") & ~body.ended("fell")
        for wave, level, peak, counts in zip(body.trials("wave"), body.trials("level"), body.trials("peak_rotation_ratio"), stood):
            if counts and int(wave) in which:
                peaks[which[int(wave)], int(level)] = peak
        shown = np.unique(np.linspace(0, len(levels) - 1, min(len(levels), len(style.SERIES))).round().astype(int))
        for colour, level in zip(style.SERIES, shown):
            closed = [steady_of(line)[level] for line in mine[body.name]]
            axes.plot(frequency, np.array(closed, dtype=float), color=colour, lw=1.1)
            axes.plot(frequency, peaks[:, level], "o", ms=3.4, color=colour)
            name = f"{plain(float(levels[level]), 4)} {unit}".strip()
            handles[name] = Line2D([], [], color=colour, lw=2)
        frequency_axis(axes, frequency)
        axes.set(title=style.literal(body.name), ylabel="rotation / α", ylim=(0, None))
    style.legend_below(figure, list(handles.values()), list(handles))
    style.save(figure, path)
    return True


def reached(report, value, line):
    """The least level; the highest that was tried where none did it."""
    tried = report.results.bodies[0].stripes["amplitude"]
    if value is None:
        return "–" if line["undecided"] else f"above {report.amplitude(float(tried[-1]))}"
    return ("at most " if value <= tried[0] else "") + report.amplitude(value)


def section(report):
    lines = report.grid
    limits = limits_of(lines)
    rows = [[line["body"], plain(line["frequency_hz"], 4), plain(line["period_s"], 4), reached(report, line["uplift"], line),
             reached(report, line["overturning"], line), report.amplitude(line["standing"]),
             *(reached(report, line[f"limit_{limit}"], line) for limit in limits), line["undecided"]] for line in lines]
    head = ["body", "frequency [Hz]", "period [s]", "lifts off from", "overturns from", "stood up to",
            *(f"{limit} from" for limit in limits), "undecided"]
    report.rows("grid", report.fit["grid"])
    report.rows("stripes", report.stripes["overturning"])
    report.section(
        "grid", "Outcomes by frequency and level",
        paragraphs([report.notes["grid"]]),
        *(report.figure("grid" + part, lambda path, shown=shown: draw(report.results, shown, lines, path),
                        "outcomes over frequency and level")
          for part, shown in in_pages(report.results.bodies, MOST_ON_A_PAGE)),
        *(report.figure("steady" + part, lambda path, shown=shown: steady(report.results, shown, lines, path),
                        "rotation over frequency beside Eq. 1")
          for part, shown in in_pages(report.results.bodies, MOST_ON_A_PAGE)),
        table("outcomes by frequency", head, rows, report.notes["grid_standing"], "sortable"))
