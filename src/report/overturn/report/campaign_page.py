"""The report of a campaign: one page that needs no network, and the same figures and tables as files.

Every sentence on it is in its data (src/output/page_text.hpp); here are headings and labels.

Data: file, figures, fit, facts, headlines, notes, waves, wave_notes, cost. Without a folder of their own the figures pass through
the page's."""

import csv
import os

from . import (assumption_sections, body_figure, fragility_figures, frequency_sections, history_figure, limit_sections,
               outcome_sections, rare_figures, spectra_figure, style, trial_figures, wave_figure)
from .fragility_figures import MEASURES
from .limit_sections import OVERTURNING
from .page_parts import (csv_cell, escape, figure_of, fold, high_of, in_pages, interval, low_of, paragraphs, rows_by, shares, table,
                         value_of)
from .page_style import CSS
from .campaign_results import CampaignResults
from .style import outward, plain


SCALE = 1.2  # of figures on the page: type of 8 points beside text of 15 pixels


def path_of(hexadecimal):
    """A path of any bytes."""
    return os.fsdecode(bytes.fromhex(hexadecimal))


class Report:
    def __init__(self, data, scratch):
        self.data, self.fit, self.notes = data, data["fit"], data["notes"]
        self.stripes = {limit["name"]: [s for s in self.fit["stripes"] if s["limit"] == limit["name"]]
                        for limit in self.fit["limit_states"]}
        self.results = CampaignResults(path_of(data["file"]), self.fit["bodies"], self.stripes[OVERTURNING], data["levels_unit"])
        self.said = {limit["name"]: limit["said"] for limit in self.fit["limit_states"]}  # as lines call them
        self.ends = [end for end in self.results.ends if end in self.fit["stripes"][0]]  # of those that the program knows
        tables = {part: self.fit[part] for part in ("probabilities", "band", "isotonic", "drawn", "warnings")}
        parts = {part: rows_by(rows, "body", "limit", "measure")
                 for part, rows in {**tables, "quote_remarks": data["quote_remarks"]}.items()}
        self.curves = [{**fit, **{part: of.get((fit["body"], fit["limit"], fit["measure"]), []) for part, of in parts.items()}}
                       for fit in self.fit["fragility"]]  # each with what is of it
        for curve in self.curves:
            curve["warnings"] = [row["text"] for row in curve["warnings"]]
        MEASURES.update((fit["measure"], fit["title"]) for fit in self.fit["fragility"])
        levels = rows_by(self.fit.get("grid_by_level", []), "body", "wave")
        self.grid = [{**line, "levels": levels[line["body"], line["wave"]]} for line in self.fit["grid"]]
        self.fits = self.fits_of(OVERTURNING)
        self.folder = path_of(data["figures"]) or scratch
        self.keep = bool(data["figures"])
        self.sections, self.contents = [], []

    def fits_of(self, limit):
        """The fits of one limit state, by body and measure."""
        return {(fit["body"], fit["measure"]): fit for fit in self.curves if fit["limit"] == limit}

    def figure(self, name, draw, alt):
        """Draws a figure for the page, and for its folder if one is wanted; nothing where there is nothing to draw."""
        path = os.path.join(self.folder, name + ".svg")
        if draw(path) is False:
            return ""
        if self.keep:
            draw(os.path.join(self.folder, name + ".png"))
        with open(path, encoding="utf-8") as file:
            svg = file.read()
        return figure_of(svg, alt, SCALE)

    def csv(self, name, head, rows):
        """A table beside the figures, in SI."""
        if self.keep:
            with open(os.path.join(self.folder, name + ".csv"), "w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(head)
                writer.writerows([[csv_cell(value) for value in row] for row in rows])

    def rows(self, name, rows):
        """Rows of a table of `overturn fit --json` as they are there, under the names that they have there."""
        rows = list(rows)
        if rows:
            self.csv(name, rows[0].keys(), [row.values() for row in rows])

    def section(self, anchor, title, *parts):
        self.contents.append(f'<a href="#{anchor}">{escape(title)}</a>')
        self.sections.append(f'<section id="{anchor}"><h2>{escape(title)}</h2>\n{"".join(parts)}</section>\n')

    def amplitude(self, value, digits=4, rounded=lambda shown, digits: shown):
        if value is None:
            return "–"
        shown, unit = self.results.in_units(value)
        text = plain(rounded(float(shown), digits), digits)
        return f"{text.rstrip('0').rstrip('.') if '.' in text else text} {unit}".strip()

    def capacity(self, value, digits=4):
        """An amplitude that a body withstands, rounded down."""
        return self.amplitude(value, digits, lambda shown, digits: outward(shown, digits, up=False))

    def amplitudes(self, ends, digits=4):
        if not ends:
            return "–"
        low, high = (end if end is None else float(self.results.in_units(end)[0]) for end in ends)
        return f"{low_of(low, digits, 'open')} – {high_of(high, digits, 'open')} {self.results.in_units(1)[1]}".strip()

    # What each section says.

    def asked(self):
        facts = table(["", ""], self.data["facts"])
        text = escape(self.results.about["campaign"])  # the line feed behind the tag is none of the text's
        name = self.results.about["campaign_name"]
        self.section("asked", "What was asked", facts, fold(f"the campaign file, {name}", f"<pre>\n{text}</pre>"))

    def bodies(self):
        rows = []
        for body in self.results.bodies:
            n = {**body.numbers, "v_ereq": style.speed(body.numbers["v_ereq_mps"])}
            rows.append([body.name] + [value_of(n[key]) for key in
                        ("mass_kg", "half_width_m", "centre_height_m", "radius_m", "p_radps", "restitution", "housner_restitution",
                         "t0_s", "t1_s", "v_ereq")] + [value_of(n["alpha_rad"] * 57.29577951308232)])
        head = ["body", "m [kg]", "b [m]", "h [m]", "R [m]", "p [rad/s]", "e", "e Housner", "T0 [s]", "T1 [s]",
                f"V_Ereq [{style.speed_unit()}]", "α [°]"]
        drawn = [self.figure("bodies" + part, lambda path, shown=shown: body_figure.draw(shown, self.data["parts"], path),
                             "bodies to one scale")
                 for part, shown in in_pages(self.results.bodies, body_figure.MOST_ON_A_PAGE)]
        self.section("bodies", "The bodies", *drawn,
            table(head, rows, self.notes["bodies"]), paragraphs(self.data["placements"]))

    def waves(self):
        parts = []
        for count, wave in enumerate(self.data["waves"]):
            name = f"wave-{count}"
            parts.append(self.figure(name, lambda path, wave=wave: wave_figure.draw(wave, path), wave["title"]))
        spectra = self.data["spectra"]
        if spectra:
            parts.append(self.figure("spectra", lambda path: spectra_figure.draw(spectra, path), "spectra of many waves"))
        quality = self.figure("wave-quality", lambda path: trial_figures.wave_quality(self.results, path),
                              "waves held against their target")
        notes = list(self.data["wave_notes"])
        self.section("waves", "The waves", *parts, quality, paragraphs(notes))

    def criterion(self):
        if not self.fit["criterion"]:
            return
        rows, parts = [], []
        for c in self.fit["criterion"]:
            rows.append([c["body"], c["title"], c["radius_unit"], c["false_safe"],
                         c["false_alarm"], c["true_safe"], c["true_overturn"], *shares(c, "false_safe_share"), *shares(c, "false_alarm_share")])
        head = ["body", "measure", "unit of R", "false safe", "false alarm", "true safe", "true overturn",
                "safe, yet fell", "interval", "unsafe, yet stood", "interval"]
        self.rows("criterion", self.fit["criterion"])
        for body in self.results.bodies:
            parts.append(f"<h3>{escape(body.name)}</h3>" + self.figure(
                f"criterion-{body.name}", lambda path, body=body: fragility_figures.criterion(self.results, body, path),
                f"energy criterion and verdicts of {body.name}"))
            answers = [r for r in self.fit["response"] if r["body"] == body.name]
            if answers:
                parts.append(table(["V_WES / V_Ereq", "without slip", "trials", "with slip", "trials", "overturned"],
                                   [self.answer(r) for r in answers], self.notes["response"]))
            said = next((v for v in self.fit.get("verdict", []) if v["body"] == body.name), None)
            if said:
                for kind, title in (("supports", "Speaks for the criterion"), ("against", "Speaks against it"),
                                    ("open", "Left open")):
                    if said[kind]:
                        items = "".join(f"<li>{escape(line)}</li>" for line in said[kind])
                        parts.append(f"<p class=label>{title}</p><ul>{items}</ul>")
        compared = "" if self.fit["grid"] else self.figure(
            "measures", lambda path: fragility_figures.measures(self.results, self.fits, path), "intensity measures compared")
        self.section("criterion", "The energy criterion on trial", table(
            head, rows, self.notes["criterion"]),
            *parts, *(("<h3>Which measure predicts best</h3>", compared, limit_sections.of_the_levels(self)) if compared else ()))

    @staticmethod
    def answer(bin_):
        low, high = bin_["from"], bin_["to"]
        row = [f"{low:.2f} to {high:.2f}" if high is not None else f"{low:.2f} and above"]
        for kind in ("without_slip", "with_slip"):
            count = bin_[f"{kind}_count"]
            quantiles = [bin_[f"{kind}_{q}"] for q in ("median", "p05", "p95")]
            row += ["{:.3f} ({:.3f} to {:.3f})".format(*quantiles) if count and None not in quantiles else "–", count]
        return [*row, bin_["overturned"]]

    def rare(self):
        """Only where the campaign asked for it."""
        if not self.data["rare"]:
            return
        parts = []
        for body in self.results.bodies:
            parts += [self.tail(body.name, limit["name"]) for limit in self.fit["limit_states"]]
            waves = self.data["rare"].get(body.name, {})
            if waves.get("pulses"):
                parts.append(self.figure(f"pulses-{body.name}", lambda path, body=body, waves=waves: rare_figures.pulses(
                    body.name, waves["pulses"], path), f"pulses that overturn {body.name}"))
            if waves.get("failing"):
                parts.append(self.figure(
                    f"failing-{body.name}", lambda path, body=body, waves=waves: rare_figures.failing(
                        body.name, waves["failing"], body.numbers["alpha_rad"], path), f"a wave that overturns {body.name}"))
        rare = self.fit["rare"]
        rows = [[e["body"], self.said[e["limit"]], value_of(e["amplitude"]), value_of(e["probability"], 3) if e["probability"] is not None
                 else f"below {high_of(e['upper'], 3)}",
                 interval([e["lower"], e["upper"]], 3) if e["probability"] is not None else "–", value_of(e["cov"], 2), e["method"],
                 e["runs"], value_of(e["crude_runs"], 2), e["state"], e["reason"] or ""] for e in rare]
        head = ["body", "limit", "factor", "P", "95 % interval", "c.o.v.", "method", "waves", "crude would need", "state", "why"]
        health = [[c["body"], self.said[c["limit"]], value_of(self.rare_level(c)["amplitude"]), c["check"], value_of(c["value"], 3), value_of(c["limit_value"], 3),
                   "passed" if c["passed"] else "failed"] for c in self.fit["rare_health"]]
        self.rows("rare", rare)
        self.section("rare", "Rare events", *parts, table(head, rows, self.notes["rare"]),
                     fold("health of the estimators", table(["body", "limit", "factor", "check", "found", "limit", ""], health))
                     if health else "")

    def rare_level(self, row):
        """The estimate that a row of its health or replicates is of."""
        return [e for e in self.fit["rare"] if (e["body"], e["limit"]) == (row["body"], row["limit"])][row["level"]]

    def tail(self, body, limit):
        rare = [{**e, "replicates": [row["estimate"] for row in self.fit["rare_replicates"] if self.rare_level(row) is e]}
                for e in self.fit["rare"] if e["body"] == body and e["limit"] == limit]
        stripes = [s for s in self.stripes[limit] if s["body"] == body]
        fit = self.fits_of(limit).get((body, self.results.measure))
        name = f"tail-{body}" if limit == OVERTURNING else f"tail-{limit}-{body}"
        return self.figure(name, lambda path: rare_figures.tail(body, limit, stripes, rare, fit, path),
                           f"{body}: rare events of {limit}")

    def telling(self):
        """The trials to inspect, as a table and a file."""
        trials = self.fit["telling_trials"]
        if not trials:
            return ""
        self.rows("telling_trials", trials)
        rows = [[t["body"], t["kind"], t["trial"], t["wave"], self.amplitude(t["amplitude"]), t["verdict"],
                 value_of(t["peak_rotation_ratio"]), value_of(t["peak_slip_m"], 3), self.amplitude(t["overturned_at"])]
                for t in trials]
        head = ["body", "kind", "trial", "wave", "level", "verdict", "peak rotation / α", "slip [m]", "overturned at"]
        return "<h3>Trials to inspect</h3>" + table(head, rows, self.notes["telling_trials"])

    def trials(self):
        parts = []
        for body in self.results.bodies:
            drawn = [("ends", trial_figures.ends), ("rotations", trial_figures.rotations), ("slips", trial_figures.slips),
                     ("reasons", trial_figures.reasons)]
            if self.fit["grid"]:  # the map shows the ends, and a grid has no distributions
                drawn = [drawn[0], drawn[3]]
            for name, draw in drawn:
                parts.append(self.figure(f"{name}-{body.name}",
                                         lambda path, draw=draw, body=body: draw(self.results, body, path),
                                         f"{name} of {body.name}"))
        parts.append(paragraphs(self.data["cut_short"]))
        parts.append(self.telling())
        parts.append(paragraphs(filter(None, [self.data["histories_of"]]), " class=quiet"))
        for shown in self.data["histories"]:
            parts.append(self.figure(f"history-{shown['body']}-{shown['trial']}",
                                     lambda path, shown=shown: history_figure.draw(shown, path), f"history of {shown['title']}"))
        parts.append(self.figure("axes", lambda path: trial_figures.axes_compared(self.results, path),
                                 "V_resp over V_WES by components"))
        self.section("trials", "Trials", *parts, paragraphs(self.data["cost"]))

    def provenance(self):
        keys = ("campaign_name", "seed", "program_version", "git_revision", "library_versions", "input_sha256",
                "wave_source", "wave_acceptance", "settings")
        rows = [[key.replace("_", " "), self.results.about[key]] for key in keys if self.results.about.get(key, "") != ""]
        self.section("provenance", "Provenance", table(["", ""], rows))

    def page(self):
        for part in (self.asked, self.bodies, self.waves, lambda: limit_sections.add(self),
                     lambda: frequency_sections.add(self), self.rare, self.criterion, lambda: outcome_sections.add(self), self.trials,
                     lambda: assumption_sections.add(self), self.provenance):
            part()
        title = escape(self.results.title)
        answers = limit_sections.answer_table(self.data["answer"]) + paragraphs(self.data["headlines"])
        if self.data["changed"]:
            answers = paragraphs([self.data["changed"]], " class=warning") + answers
        contents = " · ".join(self.contents)
        return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">\n'
                f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>{title}</title>\n'
                f"<style>{CSS}</style></head><body>\n<h1>{title}</h1>\n<div class=answer>{answers}</div>\n"
                f"<nav>{contents}</nav>\n{''.join(self.sections)}</body></html>\n")


def draw(data, path):
    """Writes the page."""
    report = Report(data, os.path.dirname(path))
    if report.keep:
        os.makedirs(report.folder, exist_ok=True)
    text = report.page()
    with open(path, "w", encoding="utf-8") as page:
        page.write(text)
