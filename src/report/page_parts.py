"""Pieces of a page: numbers, intervals, tables and paragraphs as HTML."""

import html

from style import plain


def escape(value):
    return html.escape(str(value))


def value_of(value, digits=4, unknown="–"):
    if value is None or value != value:
        return unknown
    return plain(value, digits) if isinstance(value, float) else str(value)


def shares(share):
    """A share and its exact interval, as two cells."""
    if share["lower"] is None:  # nothing to count, or no sample
        return value_of(share["share"], 3), "–"
    return value_of(share["share"], 3), interval([share["lower"], share["upper"]], 3)


def interval(ends, digits=4):
    if not ends:
        return "–"
    low, high = ends
    return f"{value_of(low, digits, 'open')} – {value_of(high, digits, 'open')}"


def table(head, rows, note=""):
    cells = "".join(f"<th>{escape(name)}</th>" for name in head)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>\n" for row in rows)
    note = f"<p class=quiet>{escape(note)}</p>" if note else ""
    return f"<div class=scroll><table><thead><tr>{cells}</tr></thead><tbody>\n{body}</tbody></table></div>{note}\n"


def paragraphs(lines, kind=""):
    return "".join(f"<p{kind}>{escape(line)}</p>\n" for line in lines)
