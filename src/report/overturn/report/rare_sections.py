"""What a report says of rare events: the tails, what waves that overturn have in common, and the health of the estimators."""

from . import rare_figures
from .limit_sections import OVERTURNING
from .page_parts import fold, high_of, interval, table, value_of


def add(report):
    """Only where the campaign asked for rare events."""
    if not report.data["rare"]:
        return
    parts = []
    for body in report.results.bodies:
        parts += [tail(report, body.name, limit["name"]) for limit in report.fit["limit_states"]]
        waves = report.data["rare"].get(body.name, {})
        if waves.get("pulses"):
            parts.append(report.figure(f"pulses-{body.name}", lambda path, body=body, waves=waves: rare_figures.pulses(
                body.name, waves["pulses"], path), f"pulses that overturn {body.name}"))
        if waves.get("failing"):
            parts.append(report.figure(
                f"failing-{body.name}", lambda path, body=body, waves=waves: rare_figures.failing(
                    body.name, waves["failing"], body.numbers["alpha_rad"], path), f"a wave that overturns {body.name}"))
    rare = report.fit["rare"]
    rows = [[e["body"], report.limit_names[e["limit"]], value_of(e["amplitude"]), value_of(e["probability"], 3) if e["probability"] is not None
             else f"below {high_of(e['upper'], 3)}",
             interval([e["lower"], e["upper"]], 3) if e["probability"] is not None else "–", value_of(e["cov"], 2), e["method"],
             e["runs"], value_of(e["crude_runs"], 2), e["state"], e["reason"] or ""] for e in rare]
    head = ["body", "limit", "factor", "P", "95 % interval", "c.o.v.", "method", "waves", "crude would need", "state", "why"]
    health = [[c["body"], report.limit_names[c["limit"]], value_of(rare_level(report, c)["amplitude"]), c["check"], value_of(c["value"], 3), value_of(c["limit_value"], 3),
               "passed" if c["passed"] else "failed"] for c in report.fit["rare_health"]]
    report.rows("rare", rare)
    report.section("rare", "Rare events", *parts, table("rare events", head, rows, report.notes["rare"]),
                   fold("health of the estimators", table("health of the estimators", ["body", "limit", "factor", "check", "found", "limit", "result"], health))
                   if health else "")


def rare_level(report, row):
    """The estimate that a row of its health or replicates is of."""
    return [e for e in report.fit["rare"] if (e["body"], e["limit"]) == (row["body"], row["limit"])][row["level"]]


def tail(report, body, limit):
    rare = [{**e, "replicates": [row["estimate"] for row in report.fit["rare_replicates"] if rare_level(report, row) is e]}
            for e in report.fit["rare"] if e["body"] == body and e["limit"] == limit]
    stripes = [s for s in report.stripes[limit] if s["body"] == body]
    fit = report.fits_of(limit).get((body, report.results.measure))
    name = f"tail-{body}" if limit == OVERTURNING else f"tail-{limit}-{body}"
    return report.figure(name, lambda path: rare_figures.tail(body, limit, stripes, rare, fit, path),
                       f"{body}: rare events of {limit}")
