"""How every figure of overturn looks: one palette, one type size, the same bytes for the same data."""

import html
import json
import textwrap

from ..errors import require

require("numpy", "matplotlib")

import matplotlib  # noqa: E402

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# Okabe & Ito (2008): told apart by colour-blind readers, and by their lightness in grey print.
BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY = "#0072b2", "#d55e00", "#009e73", "#e69f00", "#cc79a7", "#56b4e9"
INK, GREY, PALE = "#1a1a1a", "#7a7a7a", "#dddddd"
SERIES = [BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY]
BODIES = [(VERMILION, "-"), (GREEN, "--"), (PURPLE, "-."), (ORANGE, ":"), (SKY, (0, (5, 1, 1, 1)))]


def looks(count):
    """As many colours with dashes as there are bodies: the dashes go on where colours begin again."""
    dashes = [line for _, line in BODIES]
    return [(BODIES[n % len(BODIES)][0], dashes[(n + n // len(BODIES)) % len(dashes)]) for n in range(count)]


def use():
    """The house's settings, whatever the reader's own matplotlibrc says."""
    matplotlib.rcdefaults()
    matplotlib.rcParams.update({
        "font.family": "DejaVu Sans", "font.size": 8, "axes.titlesize": 8.5, "axes.titleweight": "bold",
        "axes.titlelocation": "left", "axes.labelsize": 8, "xtick.labelsize": 7.5, "ytick.labelsize": 7.5,
        "legend.fontsize": 7.5, "legend.frameon": False, "legend.borderaxespad": 0.3, "legend.handlelength": 2.2,
        "axes.edgecolor": GREY, "axes.labelcolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK,
        "axes.linewidth": 0.6, "xtick.major.width": 0.6, "ytick.major.width": 0.6, "xtick.minor.width": 0.4,
        "ytick.minor.width": 0.4, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
        "grid.color": PALE, "grid.linewidth": 0.5, "axes.axisbelow": True, "lines.linewidth": 1.0,
        "lines.solid_joinstyle": "round", "figure.facecolor": "white", "savefig.dpi": 150,
        "svg.hashsalt": "overturn", "svg.fonttype": "path", "path.simplify_threshold": 0.1,
    })


# In which quantities are shown.
UNITS = {"velocity": {"symbol": "m/s", "si": 1.0}, "acceleration": {"symbol": "m/s2", "si": 1.0},
         "length": {"symbol": "m", "si": 1.0}, "slip": {"symbol": "mm", "si": 1e-3}, "mass": {"symbol": "t", "si": 1e3}}


def told(data):
    """Takes from a figure's data in which units it shows quantities; returns the data."""
    UNITS.update(data.get("units", {}))
    return data


def shown(quantity, si):
    """A number of "slip", "mass", ..., or an array of them, in the unit it is shown in."""
    return si / UNITS[quantity]["si"]


def unit(quantity):
    return UNITS[quantity]["symbol"].replace("2", "²")


def speed(mps):
    return shown("velocity", mps)


def speed_unit():
    return unit("velocity")


def name(figure, text):
    """Heads a figure with a user's own words, on one line."""
    figure.suptitle(literal(textwrap.shorten(text, 70)), x=0.012, ha="left", fontsize=9.5, fontweight="bold")


def note_below(axes, head, parts):
    """A caveat under the axes' name, in the user's own names; nothing where there are no parts."""
    if parts:
        axes.set_xlabel("\n".join([axes.get_xlabel(), *textwrap.wrap(literal(head + "; ".join(parts)), 95)]))


def legend_below(figure, handles, labels, columns=3):
    """A legend under everything, in room of its own, so that no panel shrinks for it."""
    room = 0.18 * -(-len(labels) // columns) + 0.08
    height = figure.get_figheight() + room
    figure.set_figheight(height)
    figure.get_layout_engine().set(rect=(0, room / height, 1, 1 - room / height))
    figure.legend(handles, labels, loc="lower center", bbox_to_anchor=(0.5, 0), ncols=columns)


def save(figure, path):
    """Without dates, names or versions: equal data give equal bytes."""
    nothing = {"svg": {"Date": None, "Creator": None}, "png": {"Software": None},
               "pdf": {"CreationDate": None, "Creator": None, "Producer": None}}
    kind = path.rsplit(".", 1)[1]
    layout = figure.get_layout_engine()
    if layout is not None:  # once: savefig would lay out and draw everything twice
        layout.execute(figure)
        figure.set_layout_engine(None)
    figure.savefig(path, metadata=nothing[kind])
    if kind == "svg":
        state_axes(figure, path)
    plt.close(figure)


def state_axes(figure, path):
    """Writes into a drawing where its axes lie and what they show, so that a page's script can read values off it."""
    width, height = 72 * figure.get_size_inches()
    stated = []
    for axes in figure.axes:
        at = axes.get_position()
        if not axes.axison:
            stated.append({"box": [0, 0, -1, -1]})
            continue
        stated.append({"box": [round(float(v), 2) for v in (at.x0 * width, (1 - at.y1) * height, at.x1 * width, (1 - at.y0) * height)],
                       "x": [float(f"{v:.7g}") for v in axes.get_xlim()], "y": [float(f"{v:.7g}") for v in axes.get_ylim()],
                       "xlog": axes.get_xscale() == "log", "ylog": axes.get_yscale() == "log",
                       "names": [axes.get_xlabel().replace("\n", " "), axes.get_ylabel().replace("\n", " ")]})
    for before, one in zip([{}, *stated], stated):  # panels that share an axis name it once: a row on the left, a column at its foot
        for place, other in ((0, stated[-1]), (1, before)):
            if "names" in one and "names" in other and not one["names"][place]:
                one["names"][place] = other["names"][place]
    with open(path, encoding="utf-8") as file:
        svg = file.read()
    with open(path, "w", encoding="utf-8") as file:
        file.write(svg.replace("<svg ", f"<svg data-axes='{html.escape(json.dumps(stated))}' ", 1))


def literal(name):
    """A user's own words, drawn as they are: no mathematics, and no leading underscore, which hides a legend's entry."""
    name = name.replace("$", r"\$")
    return "\u200b" + name if name.startswith("_") else name


def plain(value, digits=3):
    """That many significant figures, written out between 0.001 and a million."""
    if value == 0:
        return "0"
    if not 1e-3 <= abs(value) < 1e6:
        return f"{value:.{max(digits - 1, 0)}e}"
    from math import floor, log10
    return f"{round(value, digits - 1 - floor(log10(abs(value)))):.{max(0, digits - 1 - floor(log10(abs(value))))}f}"


def outward(value, digits, up):
    """So many significant figures, rounded to the side that is safe to quote: an upper end up, a lower one down."""
    if value == 0 or not abs(value) < float("inf"):
        return value
    from math import ceil, floor, log10
    place = 10.0 ** (digits - 1 - floor(log10(abs(value))))
    noise = 1e-12 * abs(value * place)  # a number that has so few digits stays as it is
    return (ceil(value * place - noise) if up else floor(value * place + noise)) / place


def number(value, digits=3):
    """Three significant figures without an exponent where that is readable."""
    return f"{value:.{digits}g}" if 1e-3 <= abs(value) < 1e4 else f"{value:.{digits - 1}e}"
