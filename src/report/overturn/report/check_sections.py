"""The checks that were made of a report's results, and what was not run; what assumed values decide, where it was studied."""

from . import sensitivity_figure
from .page_parts import paragraphs, table, value_of


def by_hand(report):
    """A calculation by hand beside the simulated median."""
    lines = report.data["hand_check_lines"]
    if not lines:
        return ""
    report.rows("hand_check", report.fit["hand_check"])
    rows = [[check["body"], report.capacity(check["overturning_level"]), report.amplitude(check["simulated_median"])]
            for check in report.fit["hand_check"]]
    unsafe = [check["body"] for check in report.fit["hand_check"] if check["unsafe"]]
    warning = [report.notes["hand_unsafe"].format(bodies=", ".join(unsafe))] if unsafe else []
    return ("<h4>Calculation by hand</h4>" + paragraphs(lines) + paragraphs(warning, " class=warning")
            + table("overturning by hand and simulated", ["body", "overturns above, by hand", "simulated median"], rows))


def add(report):
    rows = [[check["check"], check["result"], check["record"]] for check in report.data["checks"]]
    report.section("checks", "Checks and their records",
                   table("checks made", ["check", "result", "record"], rows, report.notes["checks"], "words"), by_hand(report))


def moved_row(row):
    ratio = row["median_ratio"]
    coarse = row.get("levels_too_coarse")  # records of before have none
    change = "not resolved: coarse levels" if coarse else "–" if ratio is None else f"{100 * (ratio - 1):+.1f} %" + ("" if row["resolved"] else ", not resolved")
    at_basis = row.get("design_basis_probability")
    return [", ".join(row["keys"]), row["value"], row["moved_to"], row["refused"] or change, value_of(at_basis, 3)]


def add_sensitivity(report):
    """Only where a record of it was given."""
    study = report.data["sensitivity"]
    if not study:
        return
    parts = [paragraphs([report.notes["sensitivity"]])]
    for number, unmoved in enumerate(study["unmoved"]):
        rows = [row for row in study["rows"] if (row["body"], row["limit"]) == (unmoved["body"], unmoved["limit"])]
        if not rows:
            continue
        what = f"{unmoved['body']}, {unmoved['limit']}"
        if any(sensitivity_figure.moves(row) for row in rows):
            data = {"rows": rows, "unmoved": unmoved, "study": study["study"][0]}
            parts.append(report.figure(f"sensitivity-{number}", lambda path, data=data: sensitivity_figure.draw(data, path),
                                       f"sensitivity of the median: {what}"))
        parts.append(table(f"sensitivity: {what}", ["input", "value", "changed to", "median", "P at the design basis"],
                           map(moved_row, rows), kind="words sortable"))
    unchanged = study.get("not_moved", [])
    if unchanged:
        parts.append(table("assumed values that were not changed", ["input", "value", "why"],
                           [[row["key"], row["value"], row["why"]] for row in unchanged], kind="words"))
    report.section("sensitivity", "Effect of assumed values", *parts)
