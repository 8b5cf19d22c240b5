"""How often in a year each limit state is passed, by the hazard curve that the report was given."""

from .page_parts import high_of, interval, low_of, paragraphs, table, value_of

DIGITS = 3


def lacks_beta_u(f):
    """It is not known how uncertain the body is: nothing has an upper end."""
    return f["frequency_lower_per_year"] is not None and f["frequency_upper_per_year"] is None


def row_of(report, f):
    def span(name):
        low, high = f[f"{name}_lower_per_year"], f[f"{name}_upper_per_year"]
        if low is None and high is None:  # of few records
            return "not known"
        return f"> {low_of(low, DIGITS)}" if lacks_beta_u(f) else interval([low, high], DIGITS)
    def confident():
        fractiles = [f[f"fractile_{percent}_per_year"] for percent in ("5", "50", "95")]
        if None in fractiles:
            return "beta_U unknown" if lacks_beta_u(f) else "–"
        most = f["fractile_95_most_per_year"]
        return ", ".join(high_of(value, DIGITS) for value in fractiles) + ("" if most is None else f" (≤ {high_of(most, DIGITS)})")
    return [f["body"], report.limit_names[f["limit"]], span("frequency"), value_of(f["mean_per_year"], DIGITS, "no curve"),
            value_of(f["extrapolated_per_year"], 2),
            confident(), span("stripes_alone")]


def add(report):
    """Only where a hazard curve was given."""
    rows = report.fit.get("frequency", [])
    if not rows:
        return
    report.rows("frequency", rows)
    head = ["body", "limit state", f"{100 * report.data['confidence']:g} % interval", "curve mean", "beyond data",
            "confidence 5, 50, 95 %", "by trials alone"]
    report.section("frequency", "Annual frequency", table("annual frequency of each limit state [1/a]", head, [row_of(report, f) for f in rows], report.notes["frequency"]),
                   paragraphs(report.data["frequency_notes"], " class=warning"))
