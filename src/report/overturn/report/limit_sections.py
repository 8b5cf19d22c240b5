"""What a report says of the limit states: overturning and those of the user's own, and how far bodies slide and rock."""

from . import fragility_figures, grid_map, style
from .page_parts import ends, escape, fold, high_of, in_pages, interval, low_of, paragraphs, table, value_of

OVERTURNING = "overturning"  # the limit state that every campaign has
MOST_PAIRS = 6  # of bodies, columns of a table
MOST_OPEN_ROWS = 40  # of the stripes: longer tables scroll in a box
QUANTILES = [("median", "median"), ("p84", "84 %"), ("p95", "95 %")]
SHARES = {"median": 0.5, "p84": 0.84, "p95": 0.95}
RESPONSES = {"peak_slip": ("peak slip", "slip"), "peak_rotation_ratio": ("peak rotation / α", "")}  # name, kind of unit


def passed(limit):
    """The name of the count of trials that passed it, and what they did."""
    return "overturned" if limit == OVERTURNING else "exceeded"


# The first lines of the page.

def answer_table(sheet):
    """The answer: what `fit` prints first."""
    if not sheet["rows"]:
        return ""
    measure, _, *levels = sheet["head"]
    head = ["body", "answer", *(f"{measure} {level}" for level in levels)]
    return (table(f"answer. {sheet['title']}", head, sheet["rows"], kind="stacked")
            + paragraphs(filter(None, [sheet["left_out"], sheet["depends"]])))


def response(row, key, fewest):
    """A percentile of a response; a trial that overturned lies above every value. fewest: waves that each percentile needs."""
    if row["trials"] + row["unknown"] < fewest[key]:
        return "–"
    beyond = (row["trials"] - 1) * (1 - SHARES[key])
    return "overturned" if row[key] is None and row["overturned"] > beyond else high_of(row[key], 3)  # as the answer has it


# The sections.

def fits_told(report, limits):
    return [fit for fit in report.fit["fragility"] if fit["limit"] in limits]


def bounded(quoted):
    """Whether a bound stands in place of P: the curve's value is below what the trials can show."""
    return quoted["bound_from"] is not None


def probability(quoted):
    """P, or the bound that stands for it."""
    if bounded(quoted):
        return f"below {high_of(quoted['upper'], 2)}"
    if quoted["probability"] is None and quoted["bounds_from"] == "neighbours":
        return f"{low_of(quoted['lower'], 2)} to {high_of(quoted['upper'], 2)}"
    return value_of(quoted["probability"], 2)


def median_over(report, fit):
    """The median over a measure and its unit: that of the campaign for the levels' measure and for velocities."""
    if fit["measure"] == report.results.measure:
        one, unit = report.results.in_units(1)
        return value_of(fit["median"] and fit["median"] * float(one), 4), unit
    if fit["units"] == "m/s" and fit["median"] is not None:
        return value_of(style.speed(fit["median"]), 4), style.speed_unit()
    return value_of(fit["median"], 4), fit["units"]


def together(report, limit):
    """Any of the bodies under one wave, and the correlation of their ends; nothing where there is one body."""
    of = [t for t in report.fit["together"] if t["limit"] == limit]
    if not of:
        return []
    pairs = {}
    for row in report.fit["pairs"]:
        if row["limit"] == limit:
            pairs.setdefault((row["first"], row["second"]), []).append(row)
    shown = list(pairs.items())[:MOST_PAIRS]
    rows = [[report.amplitude(any_["amplitude"]), any_["waves"], any_[passed(limit)], any_["undecided"],
             value_of(any_["probability"], 3), low_of(any_["lower"], 3), high_of(any_["upper"], 3), value_of(any_["if_independent"], 3),
             *(value_of(levels[level]["phi"], 2) for _, levels in shown)] for level, any_ in enumerate(of)]
    head = ["level", "waves", f"any {passed(limit)}", "undecided", "P(any)", "lower", "upper", "if independent",
            *(f"φ {' / '.join(pair)}" for pair, _ in shown)]
    rows.append(["all levels"] + [""] * 7 + [value_of(levels[0]["phi_pooled"], 2) for _, levels in shown])
    return [fold(f"any body {passed(limit)}", table(f"any body {passed(limit)}; φ: correlation of two", head, rows,
                                                   report.notes["together"]))]


def of_the_levels(report):
    """What curves over other measures than the levels' are of."""
    return paragraphs([report.notes["other_measures"]])


def flags_of(fit):
    return ", ".join(fit["flags"]) or ("none" if fit["identifiable"] else "no curve: " + fit["state"].replace("-", " "))


def curves(report, limit):
    """Figure, fits, quoted probabilities, warnings and stripes of one limit state."""
    fits, stripes, did = report.fits_of(limit), report.stripes[limit], passed(limit)
    mine = [f for f in fits.values() if f["measure"] == report.results.measure]
    fitted = [[f["body"], report.amplitude(f["median"]), report.amplitudes(ends(f, "median"), 3),
               value_of(f["beta"], 3), interval(ends(f, "beta"), 3), f["low_points"]["five_percent_point"], f["low_points"]["hclpf"],
               report.capacity(f["one_percent_point"]), flags_of(f)] for f in mine]
    split = [[f["body"], value_of(f["beta"], 3), value_of(f["beta_r"], 3), value_of(f["beta_u"], 3),
              ", ".join(f"{d['quantity']} {d['log_median_per_deviation']:+.3f} ± {d['standard_error']:.3f}"
                        for d in f["drawn"])] for f in mine if f["drawn"] and f["identifiable"]]
    quoted = [[f["body"], f"{q['multiple']:.3g} × {q['of']}", report.amplitude(q["amplitude"]), probability(q),
               low_of(q["lower"], 2), high_of(q["upper"], 2), remark["text"]]
              for f in mine for q, remark in zip(f["probabilities"], f["quote_remarks"])]
    kinds = report.ends if limit == OVERTURNING else ["undecided", "failed"]
    head = ["body", "level", "trials", *([] if limit == OVERTURNING else [did]), *(e.replace("_", " ") for e in kinds),
            "P", "lower", "upper"]
    rows = [[s["body"], report.amplitude(s["amplitude"]), s["trials"], *([] if limit == OVERTURNING else [s[did]]),
             *(s[end] for end in kinds), value_of(s["probability"], 3), low_of(s["lower"], 3), high_of(s["upper"], 3)]
            for s in stripes]
    name = "fragility" if limit == OVERTURNING else f"fragility-{limit}"
    what = "overturning" if limit == OVERTURNING else f"exceeding {report.limit_names[limit]}"
    bodies = len(report.results.bodies)
    many = bodies > fragility_figures.MOST_COMPARED
    ranked = [[f["body"], f["label"], *median_over(report, f), value_of(f["beta"], 3), interval(ends(f, "beta"), 3),
               value_of(f["rank_area"], 3), interval(ends(f, "rank_area"), 3), flags_of(f)] for f in fits.values()]
    counts = table(f"counts at every level: {what}", head, rows, kind="sortable")
    warnings = paragraphs((f"{f['body']}: {line}" for f in mine for line in f["warnings"]), " class=warning")
    if all(f["state"] == "few-records" for f in mine):  # no probability, and nothing to draw
        return [warnings, counts]
    over_all = [] if report.fit["grid"] else [
        "" if limit == OVERTURNING else report.figure(  # the criterion's section has that of overturning
            f"measures-{limit}", lambda path: fragility_figures.measures(report.results, fits, path),
            f"intensity measures compared by {what}"),
        of_the_levels(report),
        fold("every measure, with its rank (AUC)",
             table("every measure, with its rank (AUC)", ["body", "over", "median", "unit", "beta", "interval", "rank", "interval", "flags"], ranked, kind="sortable"))]
    return [paragraphs([report.notes["many_bodies"].format(bodies=bodies, most=fragility_figures.MOST_COMPARED)]) if many else "",
            report.figure(f"{name}-compared", lambda path: fragility_figures.compared(report.results, fits, stripes, what, path),
                          f"probability of {what} of all bodies"),
            *(report.figure(name + part, lambda path, shown=shown: fragility_figures.fragility(
                report.results, shown, fits, stripes, what, path), f"probability of {what} against amplitude")
              for part, shown in in_pages(report.results.bodies, fragility_figures.MOST_ON_A_PAGE)),
            table(f"fragility of {what}", ["body", "median", "interval", "beta", "interval", "5 % point", "HCLPF", "1 % point, estimate", "flags"], fitted, report.notes["variability"]),
            table("variability of waves and bodies", ["body", "beta", "beta_R (waves)", "beta_U (body)", "ln median per deviation of"], split)
            if split else "",
            table(f"P of {what} at stated levels", ["body", "at", "amplitude", "P", "lower", "upper", "remark"], quoted) if quoted else "",
            *together(report, limit), *over_all,
            warnings, fold("counts at every level", counts) if len(rows) > MOST_OPEN_ROWS else counts]


def fragility(report):
    report.rows("stripes", report.stripes[OVERTURNING])
    report.rows("fragility", fits_told(report, [OVERTURNING]))
    report.section("fragility", "Fragility", *curves(report, OVERTURNING))


def limits(report):
    stated = report.fit["limit_states"][1:]
    if not stated:
        return
    parts = []
    for limit in stated:
        parts += [f"<h4>{escape(limit['full_name'])}: {escape(limit['definition'])}</h4>", *curves(report, limit["name"])]
    names = [limit["name"] for limit in stated]
    report.rows("limits", [s for name in names for s in report.stripes[name]])
    report.rows("limit-fragility", fits_told(report, names))
    report.section("limits", "Further limit states", *parts)


def spread(row, key, fallen, fewest):
    """A percentile and its interval; an upper end that is a fall is no open end."""
    known = without_fallen(row, fallen)
    low, high = (known[f"{key}_{end}"] for end in ("lower", "upper"))
    if row[f"{key}_upper"] is not None and high is None:
        return f"{response(known, key, fewest)} ({low_of(low, 3, 'fell')} – fell)"
    return response(known, key, fewest) if low is None and high is None else f"{response(known, key, fewest)} ({interval([low, high], 3)})"


def span(row, fallen):
    """The lowest and the highest value; a trial that overturned has none."""
    if row["trials"] == 0:
        return "–"
    ends = [row[key] if row[key] is not None and row[key] < fallen else None for key in ("lowest", "highest")]
    return f"{low_of(ends[0], 3, 'fell')} to {high_of(ends[1], 3, 'fell')}"


def in_unit(row, kind):
    """A row of percentiles with its lengths in the unit they are shown in."""
    ends = ["lowest", "highest", *(key + end for key, _ in QUANTILES for end in ("", "_lower", "_upper"))] if kind else []
    return {**row, **{key: None if row[key] is None else style.shown(kind, row[key]) for key in ends},
            **({"units": style.unit(kind)} if kind else {})}


def without_fallen(row, fallen):
    """A row of percentiles without those that stand for a body that overturned."""
    ends = [key + end for key, _ in QUANTILES for end in ("", "_lower", "_upper")]
    return {**row, **{key: None for key in ends if row[key] is not None and row[key] >= fallen}}


def responses(report):
    """Median, 84 % and 95 % per level, drawn and as a table."""
    parts = []
    rows = report.fit["quantiles"]
    report.rows("quantiles", rows)
    for body in report.results.bodies:
        for quantity, (name, kind) in RESPONSES.items():
            unit = style.unit(kind) if kind else ""
            fallen = 1.570796 / body.numbers["alpha_rad"] if quantity == "peak_rotation_ratio" else float("inf")
            mine = [in_unit(q, kind) for q in rows if q["body"] == body.name and q["quantity"] == quantity]
            if not any(q["p95_upper"] or q["p95_lower"] or q["median"] or q["overturned"] for q in mine):
                continue
            limits_of_it = [{**limit, "threshold": style.shown(kind, limit["threshold"]) if kind else limit["threshold"]}
                            for limit in report.fit["limit_states"] if limit.get("quantity") == quantity]
            known = [without_fallen(q, fallen) for q in mine]
            fell = {key: [response(q, key, report.data["fewest_values"]) == "overturned" for q in known] for key, _ in QUANTILES}
            drawn = report.figure(f"{quantity.replace('_', '-')}-{body.name}",
                                  lambda path, known=known, of_it=limits_of_it, fell=fell: fragility_figures.responses(
                                      report.results, known, of_it, path, fell), f"{name} of {body.name} per level")
            what = f"{body.name}: {name}{f' [{unit}]' if unit else ''}"
            parts += [f"<h4>{escape(what)}</h4>", drawn,
                      table(what, ["level", *(title for _, title in QUANTILES), "lowest to highest", "trials"],
                            [[report.amplitude(q["amplitude"]), *(spread(q, key, fallen, report.data["fewest_values"]) for key, _ in QUANTILES), span(q, fallen), q["trials"]]
                             for q in mine])]
    if parts:
        report.section("responses", "Slip and tilt", *parts, paragraphs([report.notes["quantiles"]], " class=quiet"))


def add(report):
    if report.fit["grid"]:
        grid_map.section(report)
        return
    fragility(report)
    limits(report)
    responses(report)
