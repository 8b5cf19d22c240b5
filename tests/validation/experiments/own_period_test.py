#!/usr/bin/env python3
# Requirement R-1401: whether V_WES gains from the body's own periods is chosen on one half of the motions and judged on the
# other: the arithmetic of it, on a made-up table whose counts are known.
import pathlib
import sys
import unittest

try:
    import numpy as np
except ImportError:
    print("skipped: python3-numpy is missing")
    sys.exit(77)

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[2] / "src" / "report")]
import own_period  # noqa: E402


class Periods(unittest.TestCase):
    def test_are_those_of_free_rocking(self):
        for phi, known in ((0.5, 5.277503), (0.9, 11.978545)):
            self.assertAlmostEqual(own_period.period_times_p(0.25, phi), known, delta=2e-6)
        self.assertAlmostEqual(own_period.period_times_p(1e-5, 0.995), 4 * np.arccosh(200), delta=1e-7)

    def test_measuring_body_has_the_period_of_the_fixed_rule(self):
        self.assertAlmostEqual(5 * np.sqrt(own_period.radius_m(3.3)), 3.3, delta=1e-12)

    def test_a_uniform_block_keeps_the_fixed_one(self):
        b, h = 0.2, 1.1
        for inertia, share in (((b * b + h * h) / 3, 1), (3 * (b * b + h * h) - b * b, None)):
            scan, = own_period.scans({"half_width_m": [b], "centre_height_m": h, "inertia_over_mass_m2": inertia}, 9.80665)
            self.assertAlmostEqual(scan["fixed_t1_s"], 5 * (b * b + h * h) ** 0.25, delta=1e-12)
            self.assertAlmostEqual(scan["limit_mps"], np.sqrt(2 * 9.80665 * (np.hypot(b, h) - h)), delta=1e-12)
            if share:
                self.assertAlmostEqual(scan["own_t1_s"], share * scan["fixed_t1_s"], delta=1e-9)
            else:
                self.assertGreater(scan["own_t1_s"], 1.5 * scan["fixed_t1_s"])


class Choice(unittest.TestCase):
    def test_motions_are_split_whole(self):
        motions = np.array(["d", "a", "c", "b", "a", "d", "e"])
        self.assertEqual(list(own_period.choosing(motions)), [False, True, True, False, True, False, True])

    def test_more_than_half_of_the_bodies_call_unsafe(self):
        measure, limit = np.array([[2.0, 2.0, 9.0], [2.0, 2.9, 9.0], [3.0, 3.0, 0.0]]), np.array([2.0, 3.0, 1.0])
        self.assertEqual(list(own_period.called_unsafe(measure, limit, np.array([0, 1]))), [False, False, True])

    def test_takes_no_more_false_safe_than_the_fixed_band(self):
        fell = np.array([True, True, False, False, False])
        fixed = np.array([True, False, True, True, False])      # one missed, two false alarms
        bold = np.array([False, False, False, False, False])    # no false alarm, but two missed
        better = np.array([False, True, True, False, False])    # one missed, one false alarm
        worse = np.array([True, True, True, True, True])        # none missed, three false alarms
        self.assertEqual(own_period.choose(fixed, {0.3: worse, 0.5: bold, 0.7: better, 0.9: better.copy()}, fell), 0.9)
        self.assertEqual(own_period.choose(worse, {0.5: bold, 0.7: better}, fell), 0.7)

    def test_says_what_the_intervals_say(self):
        for false_safe, false_alarm, said in (
                ([0, 0], [0, 0], "every test is predicted the same"), ([0, 0], [-.2, -.1], "gain: "), ([-.1, 0], [-.2, -.1], "gain: "),
                ([.01, .1], [-.2, -.1], "no gain: fewer"), ([-.1, .1], [-.2, -.1], "cannot be decided: fewer"),
                ([.01, .1], [-.1, .1], "no gain: more"), ([-.1, .1], [.01, .1], "no gain: more"),
                ([-.1, .1], [-.1, .1], "cannot be decided with")):
            self.assertTrue(said in own_period.conclusion(false_safe, false_alarm), (false_safe, false_alarm))
        self.assertFalse(own_period.conclusion([0, .1], [-.2, -.1]).startswith("gain"))


class Study(unittest.TestCase):
    """Motions a and c choose, b and d judge, two tests each. The first body agrees with what a and c did and votes alone, the
    other one with what b and d did."""

    def setUp(self):
        self.motions = np.array(["a", "a", "b", "b", "c", "c", "d", "d"])
        self.fell = np.array([1, 0, 1, 0, 1, 0, 0, 0], bool)
        agrees = np.stack([own_period.choosing(self.motions), ~own_period.choosing(self.motions)], 1)
        unsafe = {"fixed": [1, 1, 0, 1, 1, 1, 1, 1],  # chooses: 0 missed, 2 alarms; judges: 1 missed, 3 alarms
                  0.5: [1, 0, 1, 0, 0, 0, 0, 0],      # chooses: 1 missed, so that it is out
                  0.9: [1, 0, 1, 0, 1, 1, 1, 0]}      # chooses: 0 missed, 1 alarm; judges: 0 missed, 1 alarm

        def measured(calls):  # at the limit is unsafe; the other body says the opposite
            one = np.where(np.array(calls, bool), 2.0, 1.9)
            return np.stack([one, 10 - one], 1)
        self.specimen = {"fell": self.fell, "agrees": agrees, "fixed": measured(unsafe["fixed"]),
                         "own": {phi: measured(unsafe[phi]) for phi in (0.5, 0.9)}, "limit": np.array([2.0, 20.0])}

    def test_counts_what_the_judging_half_holds(self):
        told = own_period.study([self.specimen], self.motions, np.random.default_rng(1))
        self.assertEqual((told["phi"], told["tests"], told["motions"]), (0.9, 4, 2))
        counts = {name: (told[name]["false_safe"], told[name]["false_alarm"]) for name in ("fixed", "own")}
        self.assertEqual(counts, {"fixed": (1, 3), "own": (0, 1)})
        self.assertEqual(told["choosing"]["own"][0.5]["false_safe"], 1)
        self.assertEqual((told["choosing"]["fixed"]["false_safe"], told["choosing"]["fixed"]["false_alarm"]), (0, 2))
        # Motion b: 1 missed instead of 0, 1 alarm instead of 0; motion d: 2 alarms instead of 1; resampled, b alone to d alone.
        self.assertEqual(told["difference"]["false_safe"], [-0.5, 0.0])
        self.assertEqual(told["difference"]["false_alarm"], [-0.5, -0.5])
        self.assertTrue(told["conclusion"].startswith("gain"))

    def test_specimens_are_judged_together(self):
        told = own_period.study([self.specimen, self.specimen], self.motions, np.random.default_rng(1))
        self.assertEqual((told["tests"], told["motions"], told["own"]["false_alarm"], told["fixed"]["false_safe"]), (8, 2, 2, 2))
        self.assertEqual(len(told["areas"]), 2)

    def test_what_the_judging_half_did_is_not_seen_by_the_choice(self):
        other = {**self.specimen, "fell": np.where(own_period.choosing(self.motions), self.fell, ~self.fell)}
        told = own_period.study([other], self.motions, np.random.default_rng(1))
        self.assertEqual(told["phi"], 0.9)


if __name__ == "__main__":
    unittest.main()
