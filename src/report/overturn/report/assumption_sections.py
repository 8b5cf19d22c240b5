"""What a campaign takes for granted: its inputs by where they come from, and the model's own assumptions."""

from .page_parts import fold, paragraphs, table

MOST_OPEN = 12  # rows of inputs
MOST = 300  # of a campaign of very many bodies


def of_input(stated):
    """What is said of it, and where."""
    place = f"{stated['file']}:{stated['line']}" if stated["file"] else ""
    ends = " to ".join(stated["range"]) if stated["range"] else ""
    return [stated["key"], stated["value"], stated["basis"], stated["source"] or "", ends, place]


def input_row(stated):
    key, value, basis, source, ends, place = of_input(stated)
    return [key, f"{value} ({ends})" if ends else value, basis, "; ".join(text for text in (source, place) if text)]


def model_row(one, notes):
    limited = f"; {notes['no_more_effects']}" if one["bears"] == "where-not-called-for" else ""
    effect = one["effect"] if one["effect"] == "not measured" else f"{one['effect']} ({one['evidence']})"
    source = f" ({one['evidence']})" if one["effect"] == "not measured" and one["evidence"] != "none" else ""
    return [one["name"], one["assumed"] + source + limited, one["direction"], effect, one["key"]]


def add_inputs(report):
    """Every input with where it comes from."""
    inputs, notes = report.fit["assumptions"]["inputs"], report.notes
    report.csv("inputs", ["key", "value", "basis", "source", "range", "place"], map(of_input, inputs))
    drawn = table("inputs and their sources", ["input", "value (range)", "basis", "source and place"],
                  map(input_row, inputs[:MOST]),
                  notes["more_inputs"].format(more=len(inputs) - MOST) if len(inputs) > MOST else "", "words sortable")
    report.section("inputs", "Inputs and their sources", paragraphs([notes["assumptions"]]),
                   fold("inputs and their sources", drawn) if len(inputs) > MOST_OPEN else drawn)


def add_model(report):
    """What the model assumes, in which direction that errs, and what it was found to do."""
    notes = report.notes
    model = [one for one in report.fit["assumptions"]["model"] if one["bears"] != "none"]
    model.sort(key=lambda one: ("unsafe", "unknown", "safe").index(one["direction"]))
    keys = ["name", "assumed", "direction", "key", "effect", "evidence", "bears"]
    report.csv("assumptions", keys, ([one[key] for key in keys] for one in model))
    report.section("assumptions", "Assumptions of the model",
                   table("assumptions of the model", ["assumption", "statement", "error if it fails", "effect that was found", "key that replaces it"],
                         (model_row(one, notes) for one in model), notes["model_assumptions"], "words sortable"))
