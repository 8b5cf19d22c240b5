"""Pieces of a page: numbers, intervals, tables and paragraphs as HTML."""

import html
import re

from .style import outward, plain


MOST_SHORT = 26  # letters
NUMBER_OF_TABLE, NUMBER_OF_FIGURE = "\ue000", "\ue001"  # where numbers go; no text of a campaign holds them


def escape(value):
    """Text of a page: without the marks of its own."""
    return html.escape(str(value)).replace(NUMBER_OF_TABLE, "").replace(NUMBER_OF_FIGURE, "")


def value_of(value, digits=4, unknown="–"):
    if value is None or value != value:
        return unknown
    return plain(value, digits) if isinstance(value, float) else str(value)


def low_of(value, digits=4, unknown="–"):
    """A lower end, rounded down."""
    return value_of(outward(value, digits, up=False) if isinstance(value, float) else value, digits, unknown)


def high_of(value, digits=4, unknown="–"):
    """An upper end, rounded up."""
    return value_of(outward(value, digits, up=True) if isinstance(value, float) else value, digits, unknown)


def ends(row, name):
    """The interval of a number: [lower, upper], None where nothing bounds it; None where there is no interval."""
    both = [row[f"{name}_lower"], row[f"{name}_upper"]]
    return None if both == [None, None] else both


def shares(row, name):
    """A share and its exact interval, as two cells."""
    if row[f"{name}_lower"] is None:  # nothing to count, or no sample
        return value_of(row[name], 3), "–"
    return value_of(row[name], 3), interval(ends(row, name), 3)


def interval(ends, digits=4):
    if not ends:
        return "–"
    low, high = ends
    return f"{low_of(low, digits, 'open')} – {high_of(high, digits, 'open')}"


# Columns of text in tables of numbers.
TEXTS = ("flags", "remark", "kind", "verdict", "limit state", "over", "measure", "at", "ln median per deviation of")


def cell_of(value, across=1, title="", named=False):
    """What is short keeps to one line; texts begin at the left. named: with its column's heading, for a phone."""
    text = str(value)
    looks = " ".join(filter(None, ["short" if len(text) <= MOST_SHORT else "", "text" if title in TEXTS else ""]))
    quoted = f'"{looks}"' if " " in looks else looks
    head = f' data-head="{heading_of(title)}"' if named and across == 1 else ""
    return f"<td{f' class={quoted}' if looks else ''}{f' colspan={across}' if across > 1 else ''}{head}>{escape(text)}</td>"


def heading_of(title):
    """A number keeps its unit beside it: "900 gal = 1.5 x" breaks at the sign alone."""
    return re.sub(r"([0-9]) (?=[a-z%])", "\\1\u00a0", escape(title))


def row_of(cells, head, named=False):
    """A row of a table. Where it has fewer cells than columns, its last one takes the rest."""
    last = len(cells) - 1
    return "<tr>" + "".join(cell_of(cell, len(head) - last if at == last else 1, head[at], named and at > 1)
                            for at, cell in enumerate(cells)) + "</tr>\n"


def note_of(text):
    return f"<p class=quiet>{escape(text)}</p>" if text else ""


def scrolled(name, content):
    """A box that scrolls where there is no room, with the keyboard too."""
    return f'<div class=scroll role=group aria-label="{escape(name)}" tabindex=0>{content}</div>'


def table(name, head, rows, note="", kind=""):
    """Numbered by the page. kind: "words" of cells that are text, "sortable" of rows whose order may be changed, "stacked"
    of rows that a phone shows as lines, from the third column on each with its heading."""
    cells = "".join(f"<th scope=col{' class=text' if title in TEXTS else ''}>{heading_of(title)}</th>" for title in head)
    body = "".join(row_of(list(row), head, named=kind == "stacked") for row in rows)
    return (scrolled(name, f'<table class="{kind}"><caption>{NUMBER_OF_TABLE}{escape(name)}</caption><thead><tr>{cells}</tr></thead>'
                           f"<tbody>\n{body}</tbody></table>") + note_of(note) + "\n")


def facts(name, rows):
    """What is called how: a table whose rows have headings and whose columns have none."""
    body = "".join(f"<tr><th scope=row>{escape(what)}</th><td>{escape(value)}</td></tr>\n" for what, value in rows)
    return scrolled(name, f'<table class="facts"><caption>{NUMBER_OF_TABLE}{escape(name)}</caption><tbody>\n{body}</tbody></table>') + "\n"


def fold(title, content):
    """What is long: a box that scrolls on a screen, and is whole in print."""
    return f'<div class=fold role=group aria-label="{escape(title)}" tabindex=0>{content}</div>\n'


def figure_of(svg, alt, scale):
    """A drawing on a page: as wide as drawn, times `scale`, where there is room; where there is less it shrinks until its
    letters of 8 points are 8 pixels high, and then scrolls."""
    width = float(re.search(r'width="([0-9.]+)pt"', svg).group(1))
    svg = svg[svg.index("<svg"):].replace(
        "<svg", f'<svg role="img" aria-label="{escape(alt)}" style="width:{scale * width:.0f}pt;--least:{0.75 * width:.0f}pt"', 1)
    return f"<figure>{scrolled(alt, svg)}<figcaption>{NUMBER_OF_FIGURE}{escape(alt)}</figcaption></figure>\n"


def numbered(page):
    """The page with its tables and figures numbered as they come."""
    for mark, word in ((NUMBER_OF_TABLE, "Table"), (NUMBER_OF_FIGURE, "Figure")):
        first, *others = page.split(mark)
        page = first + "".join(f"{word} {n}: {part}" for n, part in enumerate(others, 1))
    return page


def in_pages(bodies, most):
    """Bodies in turn, as many as a figure of one page shows, with what tells its name from the first one's."""
    return [(f"-{start // most + 1}" if start else "", bodies[start:start + most]) for start in range(0, len(bodies), most)]


def paragraphs(lines, kind=""):
    return "".join(f"<p{kind}>{escape(line)}</p>\n" for line in lines)


def csv_cell(value):
    """What a csv file holds of it: nothing where it is not known, names one after the other."""
    return "" if value is None else " ".join(map(str, value)) if isinstance(value, list) else value


def rows_by(rows, *keys):
    """Rows in lists by the values of their keys."""
    lists = {}
    for row in rows:
        lists.setdefault(tuple(row[key] for key in keys), []).append(row)
    return lists
