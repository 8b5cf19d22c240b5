"""The page's part on real outcomes: what the campaign says of tests, beside how they ended."""

import numpy as np

from . import history_figure, outcome_figure, outcomes, style
from .fragility_figures import MEASURES
from .page_parts import escape, fold, interval, paragraphs, table, value_of

SEED = 1  # of resampled motions: equal files give equal pages
OTHER_UNIT = "_other_unit"
MOST_VOTERS = 8  # named


class Specimen:
    """One specimen's tests: what was measured, what the bodies that stand for it did, and how it ended."""

    def __init__(self, report, told, stated):
        results, level, levels = report.results, told["level"], told["levels"]
        self.name = stated["name"]
        of = {body.name: body for body in results.bodies}
        self.bodies = [of[name] for name in stated["bodies"]]

        def at_level(values):
            return np.array([of_body.reshape(-1, levels)[:, level] for of_body in values]).T
        fell, decided = (at_level([body.ended(what) for body in self.bodies]) for what in ("fell", "decided"))
        ended = np.array(stated["outcomes"][:len(fell)])
        self.tested = int((ended >= 0).sum())
        self.undecided = int(((ended >= 0) & ~decided.all(1)).sum())
        self.waves = np.flatnonzero((ended >= 0) & decided.all(1))
        self.fell = ended[self.waves] == 1
        self.motions = np.array(told["motions"])[self.waves]
        self.names = np.array(told["names"])[self.waves]
        energy = at_level([body.trials("peak_energy_ratio") for body in self.bodies])[self.waves]
        self.rotation = at_level([body.trials("peak_rotation_ratio") for body in self.bodies])[self.waves]
        self.tests = {"fell": fell[self.waves], "energy": energy, "pga": results.waves["pga"][self.waves],
                      "pgv": results.waves["pgv"][self.waves], "limit": np.array([body.numbers["v_ereq_mps"] for body in self.bodies]),
                      "measured": {key: np.array([body.measures[key] for body in self.bodies]).T[self.waves]
                                   for key in ("v_wes", "ou_v_e", "v_wes_other_unit", "ou_v_e_other_unit")
                                   if key in self.bodies[0].measures}}
        self.judged = outcomes.judge(self.tests, self.motions, self.fell, np.random.default_rng(SEED)) if len(self.waves) else None

    def over_limit(self, measure):
        """Geometric mean over its bodies of a measure over their V_Ereq."""
        return np.exp(np.log(np.maximum(self.tests["measured"][measure] / self.tests["limit"], outcomes.FLOOR)).mean(1))


def name_of(measure, unit):
    """V_WES, and in which unit R entered it."""
    if measure in ("pgv", "pga", "peak energy"):
        return MEASURES.get(measure, measure)
    other = {"cm": "m", "m": "cm"}[unit]
    plain = measure.removesuffix(OTHER_UNIT)
    return f"{MEASURES[plain]} (R in {other if measure.endswith(OTHER_UNIT) else unit})"


def of_predictor(name, counted, tests):
    safe = counted["false_safe"] + counted["safe"]
    lower, upper = outcomes.exact(counted["false_safe"], safe) if safe else (None, None)
    return [name, counted["false_safe"], counted["false_alarm"], counted["safe"], counted["fell"], value_of(counted["agreement"], 3),
            f"{counted['false_safe']} of {safe}", interval([lower, upper], 2) if safe else "–",
            value_of(counted["false_safe"] / tests, 2)]


def predictors(specimen, unit, notes):
    judged = specimen.judged
    rows = [("time history", judged["by_time_history"])]
    rows += [(f"{name_of(measure, unit)} < V_Ereq", counted) for measure, counted in judged["criteria"].items()]
    rows += [(notes["threshold"].format(measure=measure.upper()), judged[key]) for measure in ("pgv", "pga")
             for key in [f"by_threshold_on_{measure}"] if key in judged]
    return rows


def summary(specimen, notes):
    judged = specimen.judged
    wrong = judged["by_time_history"]["false_safe"] / judged["tests"]
    lines = [notes["agreement"].format(
        falls=judged["falls"], tests=judged["tests"], motions=judged["motions"],
        agreement=value_of(judged["by_time_history"]["agreement"], 3), agreement_interval=interval(judged["agreement_interval"], 3),
        false_safe=value_of(wrong, 2), false_safe_interval=interval(judged["false_safe_interval"], 2))]
    lines.append(notes["brier"].format(score=value_of(judged["brier"]["time_history"], 3),
                                       share=value_of(judged["brier"]["always_the_share"], 3)))
    if len(specimen.bodies) > 1:
        voters = sorted(judged["votes"].items(), key=lambda item: -item[1])
        votes = [notes["vote"].format(body=specimen.bodies[b].name, count=count, motions=judged["motions"])
                 for b, count in voters[:MOST_VOTERS]]
        if len(voters) > MOST_VOTERS:
            votes.append(notes["more_votes"].format(count=len(voters) - MOST_VOTERS))
        lines.append(notes["several"].format(bodies=len(specimen.bodies), votes=", ".join(votes),
                                             rule=notes["rule_left_out" if judged["motions"] > 1 else "rule_all"]))
    else:
        lines.append(notes["one"])
    if specimen.undecided:
        lines.append(notes["undecided"].format(undecided=specimen.undecided, tested=specimen.tested))
    return lines


def wrong_tests(specimen):
    """Tests that fell although the time history or a criterion called them safe, one by one, least rotation first: what is
    known of each, SI; and the measures that close its row."""
    over = {measure: specimen.over_limit(measure) for measure in specimen.tests["measured"] if not measure.endswith(OTHER_UNIT)}
    safe = np.any([specimen.judged["chance"] <= 0.5, *(~specimen.judged["unsafe"][measure] for measure in over)], axis=0)
    rows = [[int(specimen.waves[i]), specimen.names[i], specimen.motions[i], float(specimen.tests["pga"][i]),
             float(specimen.tests["pgv"][i]), float(specimen.rotation[i].mean()), float(specimen.judged["chance"][i]),
             *(float(ratio[i]) for ratio in over.values())] for i in np.flatnonzero(specimen.fell & safe)]
    return sorted(rows, key=lambda row: row[5]), list(over)


def shown_test(row):
    wave, record, motion, pga, pgv, *others = row
    return [wave, record, motion, value_of(style.shown('acceleration', pga), 3), value_of(style.speed(pgv), 3), *(value_of(other, 3) for other in others)]


def part_of(report, specimen, unit):
    notes, parts = report.notes["outcomes"], [f"<h4>{escape(specimen.name)}</h4>\n"]
    if specimen.judged is None:
        return [*parts, paragraphs([notes["no_verdict" if specimen.tested else "not_tested"]])]
    judged = specimen.judged
    parts.append(paragraphs(summary(specimen, notes)))
    head = ["predicted by", "false safe", "false alarm", "safe, stood", "unsafe, fell", "agreement", "false safe of safe", "exact interval",
            "false safe / tests"]
    parts.append(table(f"{specimen.name}: predicted and real falls", head, [of_predictor(name, counted, judged["tests"]) for name, counted in predictors(specimen, unit, notes)],
                       notes["counts"]))
    if judged["areas"]:
        parts.append(table(f"{specimen.name}: order of the tests", ["orders tests by", "area under the curve", "95 %, motions resampled"],
                           [[name_of(measure, unit), value_of(value, 3), interval([low, high], 3)]
                            for measure, (value, low, high) in judged["areas"].items()],
                           " ".join([notes["areas"], *([notes["areas_of_several"]] if len(specimen.bodies) > 1 else [])])))
    plain = specimen.name.replace("*", "any")  # for names of files
    parts.append(report.figure(f"outcomes-{plain}",
                               lambda path: outcome_figure.draw(specimen, lambda m: name_of(m, unit), path),
                               f"predicted and real falls of {specimen.name}"))
    rows, measures = wrong_tests(specimen)
    report.csv(f"false_safe-{plain}", ["wave", "record", "motion", "pga_mps2", "pgv_mps", "peak_rotation_ratio", "predicted_chance",
                                       *(f"{measure}_ratio" for measure in measures)], rows)
    mean = ", mean" if len(specimen.bodies) > 1 else ""
    head = ["wave", "record", "motion", f"PGA [{style.unit('acceleration')}]", f"PGV [{style.speed_unit()}]", f"peak rotation / α{mean}", "predicted chance",
            *(f"{name_of(measure, unit)} / V_Ereq{mean}" for measure in measures)]
    parts.append(fold(notes["false_safe_tests"],
                      table(notes["false_safe_tests"], head, map(shown_test, rows), kind="sortable")) if rows
                 else paragraphs([notes["no_false_safe"]]))
    return parts


def add(report):
    """Only where outcomes were stated."""
    told = report.data["outcomes"]
    if not told:
        return
    unit = told["radius_unit"]
    specimens = [Specimen(report, told, stated) for stated in told["specimens"]]
    report.csv("outcomes", ["specimen", "wave", "record", "motion", "fell", "predicted_chance", "pga_mps2", "pgv_mps"],
               [[s.name, int(w), s.names[i], s.motions[i], int(s.fell[i]), float(s.judged["chance"][i]), float(s.tests["pga"][i]),
                 float(s.tests["pgv"][i])] for s in specimens if s.judged for i, w in enumerate(s.waves)])
    parts = [part for specimen in specimens for part in part_of(report, specimen, unit)]
    shown = told["histories"]
    if shown:
        parts.append(f"<h4>{escape(report.notes['outcomes']['histories'])}</h4>\n{paragraphs([told['histories_of']], ' class=quiet')}")
        parts += [report.figure(f"false-safe-{one['body']}-{one['trial']}", lambda path, one=one: history_figure.draw(one, path),
                                f"history of {one['title']}") for one in shown]
    report.section("outcomes", "Comparison with test outcomes", *parts)
