"""The report of a campaign as a calculation package: one page that needs no network, and the same figures and tables as
files.

Every sentence on it is in its data (src/output/page_text.hpp); here are headings and labels.

Data: file, figures, cover, fit, facts, method, checks, headlines, notes, waves, wave_notes, cost. Without a folder of their own the figures pass through
the page's."""

import csv
import functools
import os

from . import (assumption_sections, body_figure, check_sections, cover_sections, fragility_figures, frequency_sections, history_figure,
               limit_sections, outcome_sections, rare_sections, spectra_figure, style, trial_figures, wave_figure)
from .fragility_figures import MEASURES
from .limit_sections import OVERTURNING
from .page_parts import (csv_cell, escape, facts, figure_of, fold, high_of, in_pages, low_of, numbered, paragraphs, rows_by,
                         shares, table, value_of)
from .page_script import script
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
        self.results = CampaignResults(path_of(data["file"]), self.fit["bodies"], self.stripes[OVERTURNING], data["levels_unit"],
                                       data["waves_shown"])
        self.limit_names = {limit["name"]: limit["full_name"] for limit in self.fit["limit_states"]}  # as lines call them
        self.ends = [end for end in self.results.ends if end in self.fit["stripes"][0]]  # of those that the program knows
        tables = {part: self.fit[part] for part in ("probabilities", "band", "isotonic", "drawn", "warnings")}
        parts = {part: rows_by(rows, "body", "limit", "measure")
                 for part, rows in {**tables, "quote_remarks": data["quote_remarks"], "low_points": data["low_points"]}.items()}
        self.curves = [{**fit, **{part: of.get((fit["body"], fit["limit"], fit["measure"]), []) for part, of in parts.items()}}
                       for fit in self.fit["fragility"]]  # each with what is of it
        for curve in self.curves:
            curve["warnings"] = [row["text"] for row in curve["warnings"]]
            curve["low_points"] = next(iter(curve["low_points"]), None)
        MEASURES.update((fit["measure"], fit["title"]) for fit in self.fit["fragility"])
        levels = rows_by(self.fit.get("grid_by_level", []), "body", "wave")
        self.grid = [{**line, "levels": levels[line["body"], line["wave"]]} for line in self.fit["grid"]]
        self.fits = self.fits_of(OVERTURNING)
        self.folder = path_of(data["figures"]) or scratch
        self.keep = bool(data["figures"])
        self.parts = []  # title, sections and links to them

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
        """Rows of a table of `overturn fit --json` as they are there, under the names that they have there: SI alone."""
        rows = [{key: value for key, value in row.items() if key != "stated"} for row in rows]
        if rows:
            self.csv(name, rows[0].keys(), [row.values() for row in rows])

    def section(self, anchor, title, *parts):
        _, sections, links = self.parts[-1]
        links.append(f'<a href="#{anchor}">{escape(title)}</a>')
        sections.append(f'<section id="{anchor}"><h3>{escape(title)}</h3>\n{"".join(parts)}</section>\n')

    def part(self, title, *sections):
        """One of the parts of the page; left out where it holds nothing."""
        self.parts.append((title, [], []))
        for section in sections:
            section()
        if not self.parts[-1][1]:
            self.parts.pop()

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
        self.section("asked", "Waves, levels and limit states", facts("waves, levels and limit states", self.data["facts"]))

    def campaign(self):
        text = escape(self.results.about["campaign"])  # the line feed behind the tag is none of the text's
        name = self.results.about["campaign_name"]
        self.section("campaign", f"Campaign file {name}", fold(f"campaign file {name}", f"<pre>\n{text}</pre>"))

    def method(self):
        self.section("method", "How it was computed", paragraphs(self.data["method_lines"]), facts("settings of the method", self.data["method"]))

    def answers(self):
        """In words, by body and limit state."""
        self.section("answers", "Answers by body", paragraphs(self.data["headlines"]))

    def bodies(self):
        rows = []
        for body in self.results.bodies:
            n = body.numbers
            lengths = [style.shown("length", n[key]) for key in ("half_width_m", "centre_height_m", "radius_m")]
            others = [n[key] for key in ("p_radps", "restitution", "housner_restitution", "t0_s", "t1_s")]
            rows.append([body.name] + [value_of(number) for number in (
                style.shown("mass", n["mass_kg"]), *lengths, *others, style.speed(n["v_ereq_mps"]), n["alpha_rad"] * 57.29577951308232)])
        long = style.unit("length")
        head = ["body", f"m [{style.unit('mass')}]", f"b [{long}]", f"h [{long}]", f"R [{long}]", "p [rad/s]", "e", "e Housner", "T0 [s]", "T1 [s]",
                f"V_Ereq [{style.speed_unit()}]", "α [°]"]
        drawn = [self.figure("bodies" + part, lambda path, shown=shown: body_figure.draw(shown, self.data["parts"], path),
                             "bodies to one scale")
                 for part, shown in in_pages(self.results.bodies, body_figure.MOST_ON_A_PAGE)]
        self.section("bodies", "The bodies", *drawn,
            table("the bodies", head, rows, self.notes["bodies"]), paragraphs([*self.data["supports"], *self.data["placements"]]))

    def waves(self):
        parts = []
        for count, wave in enumerate(self.data["waves"]):
            name = f"wave-{count}"
            parts.append(self.figure(name, lambda path, wave=wave: wave_figure.draw_histories(wave, path), wave["title"]))
            parts.append(self.figure(f"{name}-spectra", lambda path, wave=wave: wave_figure.draw_spectra(wave, path),
                                     f"{wave['title']}: spectra"))
        spectra = self.data["spectra"]
        if spectra:
            parts.append(self.figure("spectra", lambda path: spectra_figure.draw(spectra, path), "spectra of many waves"))
        quality = self.figure("wave-quality", lambda path: trial_figures.wave_quality(self.results, path),
                              "misfit and duration of the waves")
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
                "false-safe rate", "interval", "false-alarm rate", "interval"]
        self.rows("criterion", self.fit["criterion"])
        for body in self.results.bodies:
            parts.append(f"<h4>{escape(body.name)}</h4>" + self.figure(
                f"criterion-{body.name}", lambda path, body=body: fragility_figures.criterion(self.results, body, path),
                f"energy criterion and verdicts of {body.name}"))
            answers = [r for r in self.fit["response"] if r["body"] == body.name]
            if answers:
                parts.append(table(f"{body.name}: response against window energy", ["V_WES / V_Ereq", "without slip", "trials", "with slip", "trials", "overturned"],
                                   [self.answer(r) for r in answers], self.notes["response"]))
            verdict = next((v for v in self.fit.get("verdict", []) if v["body"] == body.name), None)
            if verdict:
                for kind, title in (("supports", "Supports the criterion"), ("against", "Contradicts the criterion"),
                                    ("open", "Not decided")):
                    if verdict[kind]:
                        items = "".join(f"<li>{escape(line)}</li>" for line in verdict[kind])
                        parts.append(f"<p class=label>{title}</p><ul>{items}</ul>")
        compared = "" if self.fit["grid"] else self.figure(
            "measures", lambda path: fragility_figures.measures(self.results, self.fits, path), "intensity measures compared")
        self.section("criterion", "The energy criterion", table(
            "verdicts of the energy criterion", head, rows, self.notes["criterion"]),
            *parts, *(("<h4>Which measure predicts best</h4>", compared, limit_sections.of_the_levels(self)) if compared else ()))

    @staticmethod
    def answer(bin_):
        low, high = bin_["from"], bin_["to"]
        row = [f"{low:.2f} to {high:.2f}" if high is not None else f"{low:.2f} and above"]
        for kind in ("without_slip", "with_slip"):
            count = bin_[f"{kind}_count"]
            quantiles = [bin_[f"{kind}_{q}"] for q in ("median", "p05", "p95")]
            row += ["{:.3f} ({:.3f} to {:.3f})".format(*quantiles) if count and None not in quantiles else "–", count]
        return [*row, bin_["overturned"]]

    def telling(self):
        """The trials to inspect, as a table and a file."""
        trials = self.fit["telling_trials"]
        if not trials:
            return ""
        self.rows("telling_trials", trials)
        rows = [[t["body"], t["kind"], t["trial"], t["wave"], self.amplitude(t["amplitude"]), t["verdict"],
                 value_of(t["peak_rotation_ratio"]), value_of(None if t["peak_slip_m"] is None else style.shown("slip", t["peak_slip_m"]), 3), self.amplitude(t["overturned_at"])]
                for t in trials]
        head = ["body", "kind", "trial", "wave", "level", "verdict", "peak rotation / α", f"slip [{style.unit('slip')}]", "overturned at"]
        return "<h4>Trials to inspect</h4>" + table("trials to inspect", head, rows, self.notes["telling_trials"], "sortable")

    def trials(self):
        parts = []
        rotations = functools.partial(trial_figures.rotations, fewest=self.data["fewest_values"]["median"])
        for body in self.results.bodies:
            drawn = [("ends", "verdicts and models", trial_figures.ends), ("rotations", "peak rotations", rotations),
                     ("slips", "peak slips", trial_figures.slips), ("reasons", "reasons for more detailed models", trial_figures.reasons)]
            if self.fit["grid"]:  # the map shows the ends, and a grid has no distributions
                drawn = [drawn[0], drawn[3]]
            for name, called, draw in drawn:
                parts.append(self.figure(f"{name}-{body.name}",
                                         lambda path, draw=draw, body=body: draw(self.results, body, path),
                                         f"{called} of {body.name}"))
        parts.append(paragraphs(self.data["cut_short"]))
        parts.append(self.telling())
        parts.append(paragraphs(filter(None, [self.data["histories_of"]]), " class=quiet"))
        for shown in self.data["histories"]:  # the plan apart: together they would be small in print
            name = f"history-{shown['body']}-{shown['trial']}"
            parts.append(self.figure(name, lambda path, shown=shown: history_figure.draw(shown, path, with_plan=False),
                                     f"history of {shown['title']}"))
            if history_figure.has_plan(shown):
                parts.append(self.figure(f"{name}-plan", lambda path, shown=shown: history_figure.draw_plan(shown, path),
                                         f"base in plan of {shown['title']}"))
        parts.append(self.figure("axes", lambda path: trial_figures.axes_compared(self.results, path),
                                 "V_resp over V_WES by components"))
        self.section("trials", "Trials", *parts, paragraphs(self.data["cost"]))

    def provenance(self):
        keys = ("campaign_name", "seed", "program_version", "git_revision", "library_versions", "input_sha256",
                "wave_source", "wave_acceptance", "settings")
        rows = [[key.replace("_", " "), self.results.about[key]] for key in keys if self.results.about.get(key, "") != ""]
        self.section("provenance", "Provenance", facts("provenance", rows))

    def page(self):
        self.part("Inputs", self.asked, lambda: assumption_sections.add_inputs(self), self.bodies, self.waves)
        self.part("Method and its limits", self.method, lambda: assumption_sections.add_model(self))
        self.part("Results", self.answers, lambda: limit_sections.add(self), lambda: frequency_sections.add(self), lambda: rare_sections.add(self),
                  self.criterion, lambda: outcome_sections.add(self), lambda: check_sections.add_sensitivity(self))
        self.part("Checks made", lambda: check_sections.add(self))
        self.part("Appendices", self.trials, self.provenance, self.campaign)
        title = escape(self.results.title)
        contents = "".join(f"<li><span>{escape(name)}</span> {' · '.join(links)}</li>" for name, _, links in self.parts)
        parts = "".join(f"<h2>{escape(name)}</h2>\n{''.join(sections)}" for name, sections, _ in self.parts)
        return numbered(
            f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>{title}</title>\n'
            f"<style>{CSS}</style></head><body>\n<header>{cover_sections.cover(self)}</header>\n"
            f'<nav aria-label="Contents"><ol>{contents}</ol></nav>\n<main>{parts}</main>{script()}</body></html>\n')


def draw(data, path):
    """Writes the page."""
    report = Report(data, os.path.dirname(path))
    if report.keep:
        os.makedirs(report.folder, exist_ok=True)
    text = report.page()
    with open(path, "w", encoding="utf-8") as page:
        page.write(text)
