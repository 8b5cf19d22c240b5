"""The page of campaigns/paper.sh: every table and figure of the paper beside what the campaigns in a folder found. What
is said of it hangs on what was found (paper_words.py), or is a fact of the paper or of the program.

paper_page.py FOLDER --choose    prints which trials figure 11 shows: name, study, trial
paper_page.py FOLDER [--program NAME] [--quick]   writes FOLDER/paper.html and FOLDER/paper.json, the same as data"""

import json
import math
import pathlib
import sys

import numpy as np

import paper_words as words
from paper_html import Page, plt
from paper_study import GAL, KINE, PUBLISHED, Study, ended_as, published_trials, space_trials, steady_rotations
from paper_words import DIFFERS, MISSING, REPRODUCED, UNKNOWN, Pair

SAME_ENDS, CLOSE = 0.97, 0.2   # of trials at two scales; of V_resp about V_WES, and of V_E about its largest
RARITY = 0.1                   # share of waves below which an outcome is a rarity
PLATEAU = 100 * KINE           # V_WES from which the paper's figure 12 has a plateau
CLOSED = 0.02                  # relative difference from a closed form that passes for none


class Paper(Page):
    """Each table and figure in the paper's order."""

    def factors(self):
        s = 0.4
        # Mass, stiffness and section as printed, and the ends that they were rounded from.
        law = [[("mass", m * s**3), ("inertia", m * s**5), ("stiffness", k * s), ("section", a * s**2),
                ("force", math.sqrt(m * k) * s**2.5)] for m, k, a in
               ((1.43 + end, 0.55 + end, 0.57 + end) for end in (-0.005, 0, 0.005))]
        printed = (0.091, 0.015, 0.216, 0.086, 0.088)
        rows = [["quantity, model / prototype", "by its factors", "printed"]]
        rows += [[name, f"{value:.4g}", "–"] for name, value in (("length", s), ("time, velocity", math.sqrt(s)),
                                                                ("acceleration, angle, stress, friction", 1))]
        rows += [[name, f"{value:.4g}", f"{told:g}"] for (name, value), told in zip(law[1], printed)]
        apart = [name for (name, low), (_, high), told in zip(law[0], law[2], printed) if not low < told + 5e-4 or not told - 5e-4 < high]
        self.item("Table 1, the factors", "length 2/5, mass factor 1.43, stiffness 0.55, section 0.57", DIFFERS if apart else REPRODUCED,
                  f"no factors that round to the printed ones give what is printed of {words.listed(apart)}" if apart
                  else "what is printed follows from the printed factors", rows=rows)

    def similarity(self):
        prototype, model = Study(self.folder / "prototype.h5"), Study(self.folder / "model.h5")
        same = int(np.sum(prototype.is_["overturned"] == model.is_["overturned"]))
        one, two = (x.column("peak_rotation_ratio") for x in (prototype, model))
        moved = (one > 0) & ~prototype.is_["overturned"] & ~model.is_["overturned"]
        apart = f"{np.median(np.abs(two[moved] / one[moved] - 1)):.1g}" if moved.any() else "–"
        law, total = math.sqrt(0.4), len(one)
        velocity = float(np.median(model.column("v_wes") / prototype.column("v_wes")))
        offered = np.max(np.abs(model.column("v_wes") / prototype.column("v_wes") / law - 1))
        holds = same >= SAME_ENDS * total and abs(velocity - law) < 1e-3
        self.item("Table 1, the model as a prototype",
                  f"{same} of {total} trials end alike at both scales; rotations differ by {apart} (median), V_WES goes with {velocity:.5f}",
                  REPRODUCED if holds else DIFFERS,
                  f"by the law V_WES goes with {law:.5f}, and does so within {offered:.1g} in all trials; a rigid body feels neither mass, stiffness "
                  "nor section" + (f". {total - same} trials end otherwise" if same < total else ""))

    def specimens(self):
        study = Study(self.folder / "one_axis.h5")
        alpha, limit = ([study.number(body, key) for body in ("type-a", "type-b")] for key in ("alpha", "v_ereq"))
        used = [i for i in self.json("one_axis")["assumptions"]["inputs"] if (i["file"] or "").startswith("bodies/")]
        basis = {i["file"] + i["key"].split(".", 1)[-1]: i["basis"] for i in used}
        assumed = sum(b == "assumed" for b in basis.values())
        self.item("Table 2, figures 1, 2, 4, 5: cask, pallets, shaking table",
                  f"alpha {np.degrees(alpha[0]):.1f}° and {np.degrees(alpha[1]):.1f}°, V_Ereq {limit[0] / KINE:.0f} and {limit[1] / KINE:.0f} kine, "
                  f"with {assumed} of {len(basis)} values of the body files assumed",
                  UNKNOWN, "the cask's own size and centre of gravity and type B's width are not published (campaigns/bodies)")
        study = Study(self.folder / "vertical_mode.h5")
        rows = [["type A", "overturned", "of"]] + [[body, *study.fell(body)] for body in study.bodies]
        told = [part for here, there, pairs in (
            ("at 67", "at 98 Hz", {"on corners": ("a-98-Hz", "a-67-Hz"), "flat": ("a-flat-98-Hz", "a-flat-67-Hz")}),
            ("flat", "on corners", {"98 Hz": ("a-98-Hz", "a-flat-98-Hz"), "67 Hz": ("a-67-Hz", "a-flat-67-Hz")}))
                for part in words.compared({name: Pair(*study.pair(*two)) for name, two in pairs.items()}, here, there)]
        self.item("Figure 3: vertical mode at 67 Hz (prototype) and 98 Hz (model)", "mass on compliant corners or a flat bed of these frequencies",
                  UNKNOWN, words.sentences(["the frequencies are put in, not found: cask, pallet and pad are one mass on one bed", *told]), rows=rows)

    def waves(self):
        told = self.json("figure_7")
        top = max(told["v_e_mps"]["highest"]) / KINE
        self.item("Table 3, figure 6: 6 artificial waves", f"{told['waves']} waves matched to MLIT CH1 in the model's time", UNKNOWN,
                  "the paper's waves (AW01 and others) are not at hand, nor is their target")
        period = np.array(told["period_s"])
        middle = np.median([wave["v_e_mps"] for wave in told["each"]], axis=0)
        high = period[middle >= (1 - CLOSE) * np.max(middle)]
        self.item("Figure 7: V_E at 10 % of the artificial waves", f"at most {top:.0f} kine, as stated before any scaling", UNKNOWN,
                  f"other waves; their median is within {100 * CLOSE:g} % of its largest from {high[0]:.2g} to {high[-1]:.2g} s", ["figure_7.svg"])
        if not self.has("figure_8.json"):
            self.item("Table 3, figure 8: 17 recorded waves", "", MISSING, "no folder of records was named (--records)")
            return
        told = self.json("figure_8")
        study = Study(self.folder / "records.h5")
        rows = [["body", "overturned", "of", "V_WES (R in cm) called safe and fell", "of safe ones that uplifted"]]
        for c in self.json("records")["criterion"]:
            if c["measure"] == "v_wes" and c["radius_unit"] == "cm":
                rows.append([c["body"], *study.fell(c["body"]), c["false_safe_share_uplifted_count"], c["false_safe_share_uplifted_of"]])
        self.item("Table 3, figure 8: 17 recorded waves, time times 0.632",
                  f"{told['waves']} records at hand: V_E at most {max(told['v_e_mps']['highest']) / KINE:.0f} kine", UNKNOWN,
                  "which records they were is known of El Centro and JMA Kobe only; baselines are ours", ["figure_8.svg"], rows)

    def sinusoids(self):
        study, steady = Study(self.folder / "sinusoids.h5"), steady_rotations(self.folder)
        alpha = study.number("type-a", "alpha")
        rows = [["Hz", "ours, rad", "ours linearised, rad", "Eq. 1, rad", "ours apart", "linearised apart"]]
        drawn, full, linearised, late, below = [], [], [], [], []
        told = self.json("sinusoids")
        levels = {}  # of each body and wave, rising
        for row in told["grid_by_level"]:
            levels.setdefault((row["body"], row["wave"]), []).append(row["steady_rotation_ratio"])
        for line in told["grid"]:
            hertz, eq1 = line["frequency_hz"], levels[line["body"], line["wave"]][1]
            closed = math.nan if eq1 is None else alpha * eq1
            ours, linear = (steady[name, line["wave"]] for name in ("sinusoids", "sinusoids_linear"))
            drawn.append((hertz, ours, linear, closed))
            told = []
            for found, apart in ((ours, full), (linear, linearised)):
                reached = eq1 is not None and found > 0.5 * closed
                apart += [found / closed - 1] if reached else []
                told.append(f"{100 * apart[-1]:+.1f} %" if reached else "–")
            late += [f"{hertz:.3g}"] if eq1 is not None and told[0] == "–" else []
            below += [f"{hertz:.3g}"] if eq1 is None and ours == linear == 0 else []
            rows.append([f"{hertz:.3g}", f"{ours:.4f}", f"{linear:.4f}", "none" if eq1 is None else f"{closed:.4f}", *told])
        figure, axes = plt.subplots(figsize=(5.2, 2.8), layout="constrained")
        frequency, ours, linear, closed = np.array(drawn).T
        axes.plot(frequency, closed, color="#1a1a1a", label="Eq. 1 (Spanos & Koh)")
        axes.plot(frequency, ours, "o", ms=4, color="#0072b2", label="ours, steady")
        axes.plot(frequency, linear, "x", ms=4, color="#d55e00", label="ours, linearised as Eq. 1 is")
        axes.set(xlabel="frequency [Hz]", ylabel="rotation [rad]", ylim=(0, None))
        axes.legend(frameon=False)
        self.save(figure, "figure_10.svg")
        def verdict(apart):
            return UNKNOWN if not apart else REPRODUCED if np.max(np.abs(apart)) < CLOSED else DIFFERS

        def ours_told(apart):
            return f"at {len(apart)} frequencies {words.signed(apart)} it" if apart else "at no frequency does it come to that state"
        self.item("Eq. 1 and figure 10: sinusoids of 18 mm, our equation linearised as Eq. 1 is", ours_told(linearised), verdict(linearised),
                  f"Eq. 1 is a closed form: {100 * CLOSED:g} % pass for none. The paper's own ordinates are not at hand", ["figure_10.svg"], rows)
        slender = math.tan(alpha) / alpha - 1
        explained = "" if not full else ", which is the better part of it" if np.max(np.abs(full)) < 2 * slender else ", which is not the better part of it"
        why = [f"Eq. 1 is of a slender body: it has g alpha for g tan alpha, which at {np.degrees(alpha):.0f}° is {100 * slender:.0f} % more{explained}; "
               "and it gives the rotation in the middle of the half cycle, not its largest (Spanos & Koh 1984)"]
        why += [f"At {words.listed(late)} Hz the body starts at rest and does not come half way to that state"] if late else []
        why += [f"At {words.listed(below)} Hz 18 mm do not lift it off"] if below else []
        self.item("Figure 10: type A as it is under these sinusoids, against Eq. 1", ours_told(full), verdict(full), words.sentences(why))

    def histories(self):
        study = Study(self.folder / "published.h5")
        for (name, trial), (_, _, published) in zip(published_trials(self.folder), PUBLISHED):
            body = study.bodies[study.body[trial]]
            end = next(kind for kind, which in study.is_.items() if which[trial])
            offered, answer = (study.column(key)[trial] / KINE for key in ("v_wes", "v_resp"))
            as_told = bool(ended_as(study, published)[trial])
            level = study.at(body, study.amplitude[trial] / GAL)
            alike, of = int(np.sum(level & ended_as(study, published))), int(np.sum(level))
            least, most = words.bounds(alike, of)
            why = f"another wave than AW01, under which it {published}" + (f"; it was chosen for that: {alike} of {of} end so" if alike else "; none of ours ends so")
            holds = as_told
            if study.is_["overturned"][trial]:
                why += ". V_resp of what falls is V_Ereq, whatever was offered"
            else:
                ratio = answer / offered
                holds = as_told and abs(ratio - 1) <= CLOSE
                why += f". V_resp comes to {ratio:.2f} times V_WES" + ("" if abs(ratio - 1) <= CLOSE else ", where the paper's figure 12 has 1 : 1")
            self.item(f"Figure 11: V_WES(t) and V_resp(t) of {body} at {study.amplitude[trial] / GAL:.0f} gal",
                      f"wave {study.column('wave')[trial]}: {end}; V_WES at most {offered:.0f}, V_resp {answer:.0f} kine",
                      REPRODUCED if holds and least >= RARITY else UNKNOWN if holds else DIFFERS if as_told or most < RARITY else UNKNOWN, why, [f"{name}.svg"])
        rows, ends = [["body", "level", "overturned", "of", "published", "ended so", "interval"]], []
        for body, gal, published in PUBLISHED:
            which = study.at(body, gal)
            count, of = int(np.sum(which & ended_as(study, published))), int(np.sum(which))
            ends.append(words.bounds(count, of))
            rows.append([body, f"{gal} gal", int(np.sum(which & study.is_["overturned"])), of, published, count,
                         f"{ends[-1][0]:.2f} to {ends[-1][1]:.2f}"])
        told = [f"type {kind} {'can end so: at least' if low >= RARITY else 'hardly ends so: at most' if high < RARITY else 'may end so, often or hardly ever:'} "
                + (f"{100 * (low if low >= RARITY else high):.0f} %" if low >= RARITY or high < RARITY else f"{100 * low:.0f} to {100 * high:.0f} %")
                + " of such waves" for kind, (low, high) in zip("AB", ends)]
        self.item("Outcomes under AW01: type A stood at 1406 gal, type B fell at 892 gal",
                  f"{rows[1][2]} of {rows[1][3]} and {rows[2][2]} of {rows[2][3]} overturn under waves of CH1",
                  REPRODUCED if all(low >= RARITY for low, _ in ends) else DIFFERS if any(high < RARITY for _, high in ends) else UNKNOWN,
                  f"{'; '.join(told)}. The paper has one test of each, and type B's width is assumed", rows=rows)

    def histories_in_space(self):
        study = Study(self.folder / "space.h5")
        rows, figures, stands, early = [["body", "level", "overturned", "of", "published"]], [], [], []
        for (name, trial), (_, gal, published) in zip(space_trials(self.folder), PUBLISHED):
            body = study.bodies[study.body[trial]]
            level = study.at(body, study.amplitude[trial] / GAL)
            fell, of, before = int(np.sum(level & study.is_["overturned"])), int(np.sum(level)), study.before_the_most(body)
            stands.append(words.bounds(of - fell, of)[1])
            early.append(f"{int(np.sum(before))} of {len(before)} falls of {body}")
            rows.append([body, f"{study.amplitude[trial] / GAL:.0f} gal", fell, of, f"{published} at {gal} gal"])
            figures.append(f"{name}.svg")
        self.item("Figure 11 in space: a round rim under two components", f"type A at {rows[1][1]}, type B at {rows[2][1]}: a trial of each",
                  DIFFERS if stands[0] < RARITY else UNKNOWN,
                  f"type A, which stood at {PUBLISHED[0][1]} gal under one, stands here in at most {100 * stands[0]:.2g} % of such waves at {rows[1][1]}. "
                  f"Over before V_WES of the first component is at its largest: {words.listed(early)}"
                  + ("" if stands[0] < RARITY else f". Whether it hardly ever stands cannot be told from {rows[1][3]} waves"), figures, rows)

    def response(self):
        study = Study(self.folder / "one_axis.h5")
        limit = study.column("v_ereq")
        rows = [["body", "V_resp / V_WES of what stood: median", "largest", "power of V_WES", "overturns from V_WES / V_Ereq"]]
        shapes, ratios, above = [], [], 0
        for body in ("type-a", "type-b"):
            waves, offered, answer = study.rocked(body)
            found = words.powers(waves, offered, answer)
            shapes.append(words.shape(found))
            ratios.append(float(np.median(answer / offered)) if len(answer) else math.nan)
            above += int(np.sum(answer >= offered))
            fell = study.of(body) & study.is_["overturned"]
            rows.append([body, f"{ratios[-1]:.2f}", f"{np.max(answer / offered, initial=0):.2f}", words.power_text(found),
                         f"{np.min((study.column('v_wes') / limit)[fell]):.2f}" if fell.any() else "none fell"])
        figure, panels = plt.subplots(1, 2, figsize=(7.4, 3.0), layout="constrained")
        for axes, body in zip(panels, ("type-a", "type-b")):
            for name, colour in (("rocked", "#0072b2"), ("overturned", "#d55e00")):
                at = study.of(body) & study.is_[name]
                axes.plot(study.column("v_wes")[at] / KINE, study.column("v_resp")[at] / KINE, ".", ms=2.4, color=colour, label=name, rasterized=True)
            reach = float(limit[study.of(body)][0]) / KINE
            axes.plot([0, reach], [0, reach], color="#1a1a1a", lw=0.9, label="1 : 1")
            axes.axvline(reach, color="#7a7a7a", lw=0.8, ls="--", label="V_Ereq")
            axes.set(title=body, xlabel="V_WES [kine]", ylabel="V_resp [kine]", xlim=(0, None), ylim=(0, 1.08 * reach))
            axes.legend(frameon=False, fontsize=7)
        self.save(figure, "figure_12.svg")
        same = all(shape == words.PROPORTIONAL for shape in shapes)
        bent = any(shape in (words.STEEPER, words.FLATTER) for shape in shapes)
        near = all(abs(ratio - 1) <= CLOSE for ratio in ratios)
        self.item("Figure 12: V_resp over V_WES, proportional", f"{above or 'no'} trials that stood lie on or above the 1 : 1 line",
                  DIFFERS if bent or (same and not near) else REPRODUCED if same else UNKNOWN,
                  "; ".join(f"type {kind}: " + {words.PROPORTIONAL: "in proportion", words.STEEPER: "not in proportion, steeper",
                                                words.FLATTER: "not in proportion, flatter"}.get(shape, "these waves cannot tell whether in proportion")
                            for kind, shape in zip("AB", shapes)) + ". R is in centimetres; in which unit it enters T0 and T1 the paper does not print",
                  ["figure_12.svg"], rows)

    def plateau(self):
        study = Study(self.folder / "one_axis.h5")
        rows, kept = [["body", "overturned", "of", "rocked and stood", "furthest slip, m", "power of V_WES above 100 kine"]], {}
        for body in study.bodies:
            rocks = study.of(body) & (study.is_["rocked"] | study.is_["overturned"])
            found = words.powers(*study.rocked(body, above=PLATEAU))
            ends = words.median_interval(found)
            kept[body] = ("slides and never rocks" if not rocks.any() else "cannot be told from these waves" if ends is None else
                          "goes on to grow" if ends[0] > words.HARDLY else "has a plateau" if ends[1] < words.HARDLY else
                          "cannot be told from these waves")
            rows.append([body, *study.fell(body), int(np.sum(study.of(body) & study.is_["rocked"])),
                         f"{np.nanmax(np.append(study.column('peak_slip')[study.of(body)], 0)):.2f}", words.power_text(found) if rocks.any() else "–"])
        said = {what: [body for body, told in kept.items() if told == what] for what in dict.fromkeys(kept.values())}
        rocking = [told for told in kept.values() if told != "slides and never rocks"]
        self.item("Figure 12: the plateau above 100 kine, ascribed to sliding and to pad damage",
                  "friction below and above tan alpha, or no slip; pads that give way are campaigns/pad_strength.toml, not run here",
                  REPRODUCED if "has a plateau" in rocking else DIFFERS if all(told == "goes on to grow" for told in rocking) else UNKNOWN,
                  "V_resp over V_WES above 100 kine: " + "; ".join(f"{what}: {words.listed(bodies)}" for what, bodies in said.items()), rows=rows)

    def criterion(self):
        rows, safe = [["body", "unit of R", "V_WES called safe, of what uplifted", "of these fell", "lowest V_WES / V_Ereq that fell"]], {}
        for c in self.json("one_axis")["criterion"]:
            if c["measure"].startswith("v_wes") and c["body"] in ("type-a", "type-b"):
                count, of = (c[f"false_safe_share_uplifted_{part}"] for part in ("count", "of"))
                lowest = c["ratio_at_overturning_lowest"]
                safe.setdefault(c["radius_unit"], []).append((count, of, c["false_safe_share_waves_uplifted_upper"]))
                rows.append([c["body"], c["radius_unit"], of, count, "none fell" if lowest is None else f"{lowest:.2f}"])
        why = []
        for unit, counts in safe.items():
            count, of = (sum(column) for column in list(zip(*counts))[:2])
            most = max(upper for _, tried, upper in counts if tried) if of else 1
            why.append(f"R in {unit}: " + (f"not conservative, {count} of {of} that uplifted and were called safe fell" if count else
                                           f"none of {of} that uplifted and were called safe fell; by their waves at most {100 * most:.2g} % of waves would"
                                           if of else "nothing that uplifted was called safe: not tried"))
        fell = [any(count for count, _, _ in counts) for counts in safe.values()]
        enough = [any(of and upper <= words.ALIKE for _, of, upper in counts) for counts in safe.values()]
        if any(fell) and not all(fell):
            why.append("The paper does not print in which unit R enters T0 and T1: whether Eq. 6 holds hangs on that")
        elif not any(fell) and not all(enough):
            why.append(f"Bounds above {100 * words.ALIKE:g} % of waves show nothing")
        self.item("Eq. 6: V_WES < V_Ereq does not overturn", "", DIFFERS if fell and all(fell) else
                  REPRODUCED if not any(fell) and enough and all(enough) else UNKNOWN, ". ".join(why), rows=rows)

    def criterion_in_space(self):
        rows, fell, most = [["body", "V_WES called safe, of what uplifted", "of these fell", "lowest V_WES / V_Ereq that fell"]], [], []
        for c in self.json("space")["criterion"]:
            if c["measure"] == "v_wes" and c["radius_unit"] == "cm":
                count, of = (c[f"false_safe_share_uplifted_{part}"] for part in ("count", "of"))
                lowest = c["ratio_at_overturning_lowest"]
                fell += [f"{c['body']} ({count} of {of})"] if count else []
                most.append(c["false_safe_share_waves_uplifted_upper"] if of else 1)
                rows.append([c["body"], of, count, "none fell" if lowest is None else f"{lowest:.2f}"])
        why = (f"not conservative, of those that uplifted and were called safe fell: {words.listed(fell)}" if fell else
               f"none that uplifted and was called safe fell; by the waves of a body at most {100 * max(most):.2g} % of waves would")
        self.item("Eq. 6 in space: on a flat bed and a round rim", "V_WES of the first axis, R in cm",
                  DIFFERS if fell else REPRODUCED if max(most) <= words.ALIKE else UNKNOWN,
                  why + ". V_WES knows of one component; two of equal strength offer 1.4 times as much", rows=rows)

    def axes(self):
        study = Study(self.folder / "axes.h5")
        rows, all_three, two = [["body", "one axis", "two", "three", "of"]], {}, {}
        for stem in dict.fromkeys(body.rsplit("-", 1)[0] for body in study.bodies):
            fell = [study.fell(f"{stem}-{axes}") for axes in ("x", "xy", "xyz")]
            rows.append([stem, *(count for count, _ in fell), fell[0][1]])
            all_three[stem], two[stem] = (Pair(*study.pair(f"{stem}-x", f"{stem}-{axes}")) for axes in ("xyz", "xy"))
        self.item("Figure 13: three axes; one direction is enough", "square on its corners, flat, round",
                  words.verdict_on_alike(all_three, ways=(1,)), words.sentences(words.compared(all_three, "under three axes", "under one")
                                                                                       + words.compared(two, "under two axes", "under one")), rows=rows)

    def landings(self):
        rows, most = [["body", "fell", "landed", "median of closed form", "95 % below", "most", "faster than from rest"]], 0
        for name in ("one_axis", "axes", "space"):
            study = Study(self.folder / f"{name}.h5")
            for body in study.bodies:
                ratio = study.landings(body)
                if len(ratio):
                    rows.append([f"{body} ({name})", study.fell(body)[0], len(ratio), f"{np.median(ratio):.2f}", f"{np.quantile(ratio, 0.95):.2f}",
                                 f"{np.max(ratio):.2f}", f"{100 * np.mean(ratio > 1):.0f} %"])
                most = max(most, np.max(ratio, initial=0))
        self.item("Landings of what fell", "angular velocity when the body lies, over p sqrt(2 (1 - sin alpha)): potential energy alone, from balance at rest",
                  UNKNOWN, "the paper tells of no landing" + (f". A tip-over from rest is no bound: up to {most:.2f} times as fast" if most > 1 else ""), rows=rows)

    def vertical(self):
        study = Study(self.folder / "horizontal_vertical.h5")
        rows = [["body", "overturned", "of"]] + [[body, *study.fell(body)] for body in study.bodies]
        pairs = {f"type {kind.upper()}": Pair(*study.pair(f"{kind}-horizontal", f"{kind}-with-vertical")) for kind in "ab"}
        self.item("Horizontal with vertical motion", "2/3 of the horizontal target, independent", words.verdict_on_alike(pairs),
                  words.sentences(words.compared(pairs, "with the vertical component", "without it")), rows=rows)
        self.item("Figure 9", "", UNKNOWN, "what it shows is not among what of the paper this project has")

    def collect(self):
        for part in (self.factors, self.similarity, self.specimens, self.waves, self.sinusoids, self.histories, self.histories_in_space,
                     self.response, self.plateau, self.criterion, self.criterion_in_space, self.axes, self.landings, self.vertical):
            part()
        return self


def main():
    folder = pathlib.Path(sys.argv[1])
    if "--choose" in sys.argv:
        for study, trials in (("published", published_trials), ("space", space_trials)):
            for name, trial in trials(folder):
                print(name, study, trial)
        return
    program = sys.argv[sys.argv.index("--program") + 1] if "--program" in sys.argv else ""
    page = Paper(folder, "--quick" in sys.argv, program).collect()
    (folder / "paper.json").write_text(json.dumps(page.items, indent=1), encoding="utf-8")
    (folder / "paper.html").write_text(page.text(), encoding="utf-8")


if __name__ == "__main__":
    main()
