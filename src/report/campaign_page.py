"""The report of a campaign: one page that needs no network, and the same figures and tables as files.

Arguments: data.json (file, figures, bodies, fit, facts, waves, wave_notes, cost), page.html. Without a folder of their
own the figures pass through that of data.json."""

import csv
import html
import json
import os
import re
import sys

import fragility_figures
import trial_figures
import wave_figure
from fragility_figures import MEASURES
from page_style import CSS
from results_data import Results
from style import plain


SCALE = 1.2  # of figures on the page: type of 8 points beside text of 15 pixels
OVERTURNING = "overturning"  # the limit state that every campaign has
STRIPE_KEYS = ["body", "level", "amplitude", "trials", "overturned", "failed", "probability", "lower", "upper"]
MOST_OPEN_ROWS = 40  # of the stripes: longer tables are folded away


def escape(value):
    return html.escape(str(value))


def value_of(value, digits=4, unknown="–"):
    if value is None or value != value:
        return unknown
    return plain(value, digits) if isinstance(value, float) else str(value)


def shares(share):
    """A share and its exact interval, as two cells."""
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


class Report:
    def __init__(self, data, scratch):
        self.data, self.fit = data, data["fit"]
        self.results = Results(data["file"], data["bodies"])
        self.stripes = {limit["name"]: [s for s in self.fit["stripes"] if s["limit"] == limit["name"]]
                        for limit in self.fit["limits"]}
        self.fits = self.fits_of(OVERTURNING)
        self.folder = data["figures"] or scratch
        self.keep = bool(data["figures"])
        self.sections, self.contents = [], []

    def fits_of(self, limit):
        """The fits of one limit state, by body and measure."""
        return {(fit["body"], fit["measure"]): fit for fit in self.fit["fragility"] if fit["limit"] == limit}

    def figure(self, name, draw, alt):
        """Draws a figure for the page, and for its folder if one is wanted; nothing where there is nothing to draw."""
        path = os.path.join(self.folder, name + ".svg")
        if draw(path) is False:
            return ""
        if self.keep:
            draw(os.path.join(self.folder, name + ".png"))
        with open(path, encoding="utf-8") as file:
            svg = file.read()
        width = float(re.search(r'width="([0-9.]+)pt"', svg).group(1))
        svg = svg[svg.index("<svg"):].replace(
            "<svg", f'<svg role="img" aria-label="{escape(alt)}" style="width:{SCALE * width:.0f}pt"', 1)
        return f"<figure>{svg}</figure>\n"

    def csv(self, name, head, rows):
        if self.keep:
            with open(os.path.join(self.folder, name + ".csv"), "w", encoding="utf-8", newline="") as file:
                writer = csv.writer(file, lineterminator="\n")
                writer.writerow(head)
                writer.writerows([["" if cell is None else cell for cell in row] for row in rows])

    def section(self, anchor, title, *parts):
        self.contents.append(f'<a href="#{anchor}">{escape(title)}</a>')
        self.sections.append(f'<section id="{anchor}"><h2>{escape(title)}</h2>\n{"".join(parts)}</section>\n')

    def amplitude(self, value, digits=4):
        if value is None:
            return "–"
        shown, unit = self.results.in_units(value)
        text = plain(float(shown), digits)
        return f"{text.rstrip('0').rstrip('.') if '.' in text else text} {unit}".strip()

    def amplitudes(self, ends, digits=4):
        if not ends:
            return "–"
        low, high = (value_of(end if end is None else float(self.results.in_units(end)[0]), digits, "open") for end in ends)
        return f"{low} – {high} {self.results.in_units(1)[1]}".strip()

    # What each section says.

    def answers(self):
        """One sentence a body: the design basis, the median, what may be relied on."""
        lines = []
        for body in self.results.bodies:
            parts = []
            basis = self.results.design_basis(body)
            if basis is not None:
                stripe = next(s for s in self.stripes[OVERTURNING] if s["body"] == body.name and s["amplitude"] == basis)
                parts.append(f"at the design basis ({self.amplitude(basis)}) {stripe['overturned']} of "
                             f"{stripe['trials']} trials overturned, P between {plain(stripe['lower'], 2)} and "
                             f"{plain(stripe['upper'], 2)}")
            fit = self.fits.get((body.name, self.results.measure))
            if fit and fit["identifiable"]:
                parts.append(f"half overturn at {self.amplitude(fit['median'], 3)} "
                             f"({self.amplitudes(fit['median_interval'], 3)}), beta {plain(fit['beta'], 2)}, "
                             f"HCLPF {self.amplitude(fit['hclpf'], 3)}")
            elif fit:
                parts.append("no curve: " + "; ".join(fit["warnings"][:1] or [fit["state"]]))
            lines.append(f"{body.name}: " + "; ".join(parts) + ".")
        return lines

    def asked(self):
        facts = table(["", ""], self.data["facts"])
        text = escape(self.results.about["campaign"])
        self.section("asked", "What was asked", facts,
                     f"<details><summary>the campaign file</summary><pre>{text}</pre></details>")

    def bodies(self):
        rows = []
        for body in self.results.bodies:
            n = body.numbers
            rows.append([body.name] + [value_of(n[key]) for key in
                        ("mass", "half_width", "centre_height", "radius", "p", "restitution", "housner_restitution",
                         "t0", "t1", "v_ereq")] + [value_of(n["alpha"] * 57.29577951308232)])
        head = ["body", "m [kg]", "b [m]", "h [m]", "R [m]", "p [rad/s]", "e", "e Housner", "T0 [s]", "T1 [s]",
                "V_Ereq [m/s]", "α [°]"]
        self.section("bodies", "The bodies", self.figure(
            "bodies", lambda path: trial_figures.bodies(self.results, path), "the bodies, to one scale"),
            table(head, rows, "Dashed outline: a block about the centre of gravity, for scale; only base and centre "
                              "enter the equations."))

    def waves(self):
        parts = []
        for count, wave in enumerate(self.data["waves"]):
            name = f"wave-{count}"
            parts.append(self.figure(name, lambda path, wave=wave: wave_figure.draw(wave, path), wave["title"]))
        quality = self.figure("wave-quality", lambda path: trial_figures.wave_quality(self.results, path),
                              "how well the waves meet their target")
        notes = list(self.data["wave_notes"])
        self.section("waves", "The waves", *parts, quality, paragraphs(notes))

    def fragility(self):
        stripes = self.stripes[OVERTURNING]
        head = ["body", "level", "trials", "overturned", "failed", "P", "lower", "upper"]
        rows = [[s["body"], self.amplitude(s["amplitude"]), s["trials"], s["overturned"], s["failed"],
                 value_of(s["probability"], 3), value_of(s["lower"], 3), value_of(s["upper"], 3)] for s in stripes]
        self.csv("stripes", STRIPE_KEYS, [[s[key] for key in STRIPE_KEYS] for s in stripes])
        keys = ["body", "measure", "units", "identifiable", "median", "beta", "median_interval", "beta_interval", "hclpf",
                "hclpf_interval", "flags"]
        def cells(fit, key):
            if key.endswith("_interval"):
                return fit[key] or [None, None]
            return [" ".join(fit[key]) if isinstance(fit[key], list) else fit[key]]
        columns = [name for key in keys for name in (
            [key.replace("interval", "lower"), key.replace("interval", "upper")] if key.endswith("_interval") else [key])]
        self.csv("fragility", columns, [[cell for key in keys for cell in cells(f, key)] for f in self.fits.values()])
        fits = [f for f in self.fits.values() if f["measure"] == self.results.measure]
        fitted = [[f["body"], self.amplitude(f["median"]), self.amplitudes(f["median_interval"], 3),
                   value_of(f["beta"], 3), interval(f["beta_interval"], 3), self.amplitude(f["hclpf"]),
                   self.amplitudes(f.get("hclpf_interval"), 3), ", ".join(f["flags"]) or "none"] for f in fits]
        split = [[f["body"], value_of(f["beta"], 3), value_of(f["beta_r"], 3), value_of(f["beta_u"], 3),
                  ", ".join(f"{d['quantity']} {d['log_median_per_deviation']:+.3f} ± {d['standard_error']:.3f}"
                            for d in f["drawn"])] for f in fits if f["drawn"] and f["identifiable"]]
        quoted = [[f["body"], f"{q['multiple']:.3g} × {q['of']}", self.amplitude(q["amplitude"]),
                   value_of(q["probability"], 2), value_of(q["lower"], 2), value_of(q["upper"], 2),
                   ", ".join(word for word, said in (("outside the data", q["outside_data"]),
                                                     ("tail: likely too low", q["in_tail"])) if said)]
                  for f in fits for q in f["probabilities"]]
        warnings = [f"{f['body']}: {line}" for f in fits for line in f["warnings"]]
        self.section("fragility", "Fragility", self.figure(
            "fragility", lambda path: fragility_figures.fragility(self.results, self.fits, path),
            "probability of overturning against amplitude"),
            table(["body", "median", "interval", "beta", "interval", "HCLPF", "interval", "flags"], fitted),
            table(["body", "beta", "beta_R (waves)", "beta_U (body)", "change of ln median per deviation of"], split)
            if split else "",
            table(["body", "at", "amplitude", "P", "lower", "upper", ""], quoted) if quoted else "",
            paragraphs(warnings, " class=warning"),
            f"<details{' open' if len(rows) <= MOST_OPEN_ROWS else ''}><summary>all stripes</summary>{table(head, rows)}</details>")

    def criterion(self):
        rows, parts = [], []
        for c in self.fit["criterion"]:
            rows.append([c["body"], MEASURES[c["measure"]][0].split(",")[0], c["radius_unit"], c["false_safe"],
                         c["false_alarm"], c["true_safe"], c["true_overturn"], *shares(c["safe_but_overturned"]), *shares(c["unsafe_but_stood"])])
        head = ["body", "measure", "unit of R", "false safe", "false alarm", "true safe", "true overturn",
                "safe, yet fell", "interval", "unsafe, yet stood", "interval"]
        counts = ["body", "measure", "radius_unit", "false_safe", "false_alarm", "true_safe", "true_overturn"]
        told = [f"{share}_{part}" for share in ("safe_but_overturned", "unsafe_but_stood")
                for part in ("share", "lower", "upper")]
        self.csv("criterion", counts + told,
                 [[c[key] for key in counts] + [c[share][part] for share in ("safe_but_overturned", "unsafe_but_stood")
                                                for part in ("share", "lower", "upper")]
                  for c in self.fit["criterion"]])
        for body in self.results.bodies:
            parts.append(f"<h3>{escape(body.name)}</h3>" + self.figure(
                f"criterion-{body.name}", lambda path, body=body: fragility_figures.criterion(self.results, body, path),
                f"energy criterion and verdicts of {body.name}"))
            answers = [r for r in self.fit["response"] if r["body"] == body.name]
            if answers:
                parts.append(table(["V_WES / V_Ereq", "without slip", "trials", "with slip", "trials", "overturned"],
                                   [self.answer(r) for r in answers],
                                   "V_resp / V_Ereq of the trials that moved and stood: median (5 % to 95 %)."))
            said = next((v for v in self.fit.get("verdict", []) if v["body"] == body.name), None)
            if said:
                for kind, title in (("supports", "Speaks for the criterion"), ("against", "Speaks against it"),
                                    ("open", "Left open")):
                    if said[kind]:
                        items = "".join(f"<li>{escape(line)}</li>" for line in said[kind])
                        parts.append(f"<p class=label>{title}</p><ul>{items}</ul>")
        compared = self.figure("measures", lambda path: fragility_figures.measures(self.results, self.fits, path),
                               "intensity measures compared")
        self.section("criterion", "The energy criterion on trial", table(
            head, rows, "False safe: measure below V_Ereq, yet overturned. False alarm: above it, yet stood."),
            *parts, "<h3>Which measure predicts best</h3>" if compared else "", compared)

    @staticmethod
    def answer(bin_):
        low, high = bin_["v_wes_ratio"]
        row = [f"{low:.2f} to {high:.2f}" if high is not None else f"{low:.2f} and above"]
        for kind in ("v_resp_ratio_without_slip", "v_resp_ratio_with_slip"):
            q = bin_[kind]
            row += [f"{q['median']:.3f} ({q['p05']:.3f} to {q['p95']:.3f})", q["count"]] if q else ["-", 0]
        return [*row, bin_["overturned"]]

    def trials(self):
        parts = []
        for body in self.results.bodies:
            for name, draw in (("ends", trial_figures.ends), ("rotations", trial_figures.rotations),
                               ("slips", trial_figures.slips), ("reasons", trial_figures.reasons)):
                parts.append(self.figure(f"{name}-{body.name}",
                                         lambda path, draw=draw, body=body: draw(self.results, body, path),
                                         f"{name} of {body.name}"))
        for shown in self.data["histories"]:
            parts.append(self.figure(f"history-{shown['body']}", lambda path, shown=shown: trial_figures.history(shown, path),
                                     f"history of {shown['title']}"))
        parts.append(self.figure("axes", lambda path: trial_figures.axes_compared(self.results, path),
                                 "V_resp over V_WES under one, two and three components"))
        self.section("trials", "What the trials did, and what was simulated", *parts, paragraphs(self.data["cost"]))

    def provenance(self):
        keys = ("campaign_name", "seed", "program_version", "git_revision", "library_versions", "input_sha256",
                "wave_source", "wave_acceptance", "settings")
        rows = [[key.replace("_", " "), self.results.about[key]] for key in keys if self.results.about.get(key, "") != ""]
        self.section("provenance", "Provenance", table(["", ""], rows))

    def page(self):
        for part in (self.asked, self.bodies, self.waves, self.fragility, self.criterion, self.trials, self.provenance):
            part()
        title = escape(self.results.title)
        answers = paragraphs(self.answers())
        contents = " · ".join(self.contents)
        return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">\n'
                f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>{title}</title>\n'
                f"<style>{CSS}</style></head><body>\n<h1>{title}</h1>\n<div class=answer>{answers}</div>\n"
                f"<nav>{contents}</nav>\n{''.join(self.sections)}</body></html>\n")


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as source:
        report = Report(json.load(source), os.path.dirname(sys.argv[1]))
    if report.keep:
        os.makedirs(report.folder, exist_ok=True)
    text = report.page()
    with open(sys.argv[2], "w", encoding="utf-8") as page:
        page.write(text)
