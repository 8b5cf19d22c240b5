"""campaign.h5 and the files of older formats by the package, held against what h5py reads of them by itself."""

import shutil
import unittest
import warnings
from pathlib import Path
from unittest import mock

import h5py
import numpy as np
import pandas as pd

import overturn
from overturn.results import Column


def stored_columns(file):
    """Every column of a file: group, name, data."""
    found = []
    file.visititems(lambda name, data: found.append(name.rpartition("/")[::2] + (data,)) if isinstance(data, h5py.Dataset) else None)
    return found


class Columns(unittest.TestCase):
    """Every number, name, unit and meaning is the stored one."""

    def agrees(self, path):
        checked = named = 0
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            results = overturn.open(path)
        tables = {}
        with h5py.File(path) as file:
            for group, name, data in stored_columns(file):
                if group not in tables:
                    tables[group] = results.table(group)
                column = tables[group][name]
                stored = data[()]
                np.testing.assert_array_equal(column.values, np.char.decode(stored, "utf-8") if stored.dtype.kind == "S" else stored)
                self.assertEqual(column.units, data.attrs["units"].decode())
                self.assertEqual(column.meaning, data.attrs["description"].decode())
                kinds = h5py.check_enum_dtype(data.dtype)
                if kinds:
                    words = {number: word for word, number in kinds.items()}
                    self.assertEqual(list(column.names), [words[number] for number in data[()]])
                    named += 1
                checked += 1
        return checked, named

    def test_of_this_program(self):
        checked, named = self.agrees("campaign.h5")
        self.assertGreater(checked, 200)
        self.assertGreater(named, 10)

    def test_of_older_formats(self):
        for version in (3, 4, 5):
            checked, named = self.agrees(f"format-{version}.h5")
            self.assertGreater(checked, 100)
            self.assertGreater(named, 8)

    def test_are_read_when_they_are_asked_for(self):
        results, read = overturn.open("campaign.h5"), []
        get = h5py.Dataset.__getitem__
        with mock.patch.object(h5py.Dataset, "__getitem__", lambda data, of: read.append(data.name) or get(data, of)):
            results.trials.to_pandas(["verdict"])
        self.assertEqual(read, ["/trials/verdict"])

    def test_of_the_first_rows(self):
        results = overturn.open("campaign.h5")
        for group in ("trials", "waves"):
            whole, few = results.table(group), results.table(group, rows=3)
            for name, column in few.items():
                self.assertEqual(len(column), 3)
                np.testing.assert_array_equal(column.values, whole[name].values[:3])
        self.assertEqual(len(results.table("waves", rows=10**6)["id"]), len(results.waves["id"]))

    def test_of_a_page(self):
        """Of some waves: each body has their trials, and no others."""
        from overturn.report.campaign_results import CampaignResults
        results = overturn.open("campaign.h5")
        bodies = [{"name": name} for name in results.bodies]
        stripes = [{"body": body["name"], "measure": "pga", **dict.fromkeys(("amplitude", "trials", "at_rest", "probability", "purpose"))}
                   for body in bodies]
        trials, levels = results.trials, len(results.levels["amplitude"])
        for shown in (None, 2):
            page = CampaignResults("campaign.h5", bodies, stripes, {"symbol": "1", "si": 1}, shown)
            count = shown or len(results.waves["id"])
            self.assertEqual(len(page.waves["id"]), count)
            for body in page.bodies:
                mine = (trials["body"].names == body.name) & (np.arange(len(trials["body"])) < count * levels * len(bodies))
                self.assertEqual(mine.sum(), count * levels)
                np.testing.assert_array_equal(body.trials("v_ereq"), trials["v_ereq"].values[mine])
                np.testing.assert_array_equal(body.ended("decided"), trials["verdict"].of("decided")[mine])
                self.assertEqual([name for name, which in body.kinds("verdict") if which[0]], [trials["verdict"].names[mine][0]])

    def test_without_a_name_for_a_number_are_refused(self):
        with h5py.File("unnamed.h5", "w") as file:
            data = file.create_dataset("verdict", data=np.array([0, 7], "u1"), dtype=h5py.enum_dtype({"at-rest": 0, "failed": 5}, "u1"))
            data.attrs.update(units="1", description="how it ended")
            with self.assertRaisesRegex(overturn.Error, "a number without a name"):
                Column(data).names


class Frames(unittest.TestCase):
    def setUp(self):
        self.results = overturn.open("campaign.h5")

    def test_trials_have_names_units_and_nan(self):
        frame = self.results.trials.to_pandas()
        self.assertEqual(len(frame), 4 * 3 * 2)
        self.assertEqual(list(frame["body"].cat.categories), ["wide one", "flat"])
        self.assertEqual(list(frame["verdict"].cat.categories), ["at-rest", "slid", "rocked", "overturned", "contact-lost", "failed", "slid-and-rocked"])
        self.assertEqual((frame.attrs["units"]["peak_rotation"], frame.attrs["units"]["v_wes"]), ("rad", "m/s"))
        never = frame["overturn_time"].isna()
        self.assertTrue(never.any() and not never.all())
        self.assertTrue((never == (frame["verdict"] != "overturned")).all())

    def test_stripes_count_the_trials(self):
        trials, stripes = self.results.trials.to_pandas(), self.results.stripes.to_pandas()
        self.assertEqual(len(stripes), 2 * 3)
        counted = trials[trials["verdict"] == "overturned"].groupby(["body", "amplitude"]).size()
        for _, row in stripes.iterrows():
            self.assertEqual(row["overturned"], counted.get((row["body"], row["amplitude"]), 0))
        self.assertEqual(stripes.attrs["units"]["amplitude"], "m/s2")
        self.assertEqual(stripes.attrs["confidence"], 0.95)

    def test_levels_are_those_of_the_trials(self):
        levels, trials = self.results.levels.to_pandas(), self.results.trials
        np.testing.assert_array_equal(levels["amplitude"], [3, 6, 12])
        self.assertEqual(list(levels["purpose"]), ["ordinary", "design-basis", "ordinary"])
        np.testing.assert_array_equal(levels["amplitude"].to_numpy()[trials["level"].values], trials["amplitude"].values)

    def test_bodies_are_in_the_campaigns_order(self):
        bodies = self.results.bodies.to_pandas().set_index("body")
        self.assertEqual(list(bodies.index), ["wide one", "flat"])
        self.assertAlmostEqual(bodies.loc["wide one", "alpha"], np.arctan(0.68 / 1.045))

    def test_units_that_differ_by_row_are_told_by_row(self):
        curves = self.results.curves.to_pandas()
        units = dict(zip(curves["measure"].astype(str), curves["units"].astype(str)))
        self.assertEqual((units["pga"], units["pgv"], units["v_wes_ratio"]), ("m/s2", "m/s", "1"))
        self.assertEqual(curves.attrs["units"]["median"].split("; ")[:2], ["m/s2", "m/s"])

    def test_units_of_older_formats_have_the_name_of_today(self):
        for version in (3, 4):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                results = overturn.open(f"format-{version}.h5")
            stored = results.file["fragility/block/measure_units"]
            names = {number: name for name, number in h5py.check_enum_dtype(stored.dtype).items()}
            units = [names[number] for number in stored[()]]
            for made in (results.curves.to_pandas()["units"], results.curves.to_xarray()["units"].sel(body="block"),
                         results.curves["block"].to_pandas(["measure_units"])["units"], results.curves["block"]["measure_units"].names):
                self.assertEqual(list(np.asarray(made)), units)
            self.assertNotIn("measure_units", list(results.curves["block"]))

    def test_limits_have_stripes_and_curves(self):
        limit = self.results.limits["slides"]
        self.assertIn("exceeded", limit.stripes["flat"])
        self.assertIn("median", limit.curves.to_pandas())

    def test_unknown_columns_and_groups_are_named(self):
        with self.assertRaisesRegex(overturn.Error, "no column peak_rotaton .*peak_rotation"):
            self.results.trials.to_pandas(["peak_rotaton"])
        with self.assertRaisesRegex(overturn.Error, "holds no nothing"):
            self.results.table("nothing")


class Groups(unittest.TestCase):
    def all_make_frames_and_datasets(self, path, some):
        results = overturn.open(path)
        groups = {group for group, _, _ in stored_columns(results.file)} - {"inputs"}
        self.assertLessEqual(some, groups)
        for group in groups:
            table = results.table(group)
            frame, data = table.to_pandas(), table.to_xarray()
            if len({column.values.shape for column in table.values()}) == 1:
                self.assertEqual(set(frame.columns), set(table), group)
            self.assertGreater(len(frame.columns), 0, group)
            self.assertEqual(set(data.variables) | {"row"}, set(table) | {"row"}, group)
            for name, column in table.rows.items():
                kept = column.names if column.categories else column.values
                np.testing.assert_array_equal(frame[name].astype(str) if column.categories else frame[name], kept, group)
                np.testing.assert_array_equal(data[name].values, kept, group)
                self.assertEqual(frame.attrs["units"][name], column.units)
                self.assertEqual(data[name].attrs["units"], column.units)
                self.assertEqual(data[name].attrs["description"], column.meaning)

    def test_all_make_frames_and_datasets(self):
        self.all_make_frames_and_datasets("campaign.h5", {
            "waves/wide one", "trials/contact", "quantiles/flat/peak_rotation_ratio", "criterion_by_level/flat/v_wes",
            "limits/slides/fragility/flat", "limit_states", "pairs/slides"})
        self.all_make_frames_and_datasets("rare.h5", {"rare_health/block", "rare_replicates/block", "rare/block/rows"})

    def test_whose_columns_name_no_axis_have_numbered_rows(self):
        results = overturn.open("campaign.h5")
        table = results.by_body("isotonic")["flat"]
        self.assertEqual((table.axis, table["to"].axes), ("row", ("row",)))
        self.assertEqual(results.table("digests").axis, "objects")  # alone, it names them
        shared = results.by_body("isotonic")
        frame, data = shared.to_pandas(), shared.to_xarray()
        self.assertEqual(data["to"].dims, ("body", "row"))
        self.assertEqual(len(frame), sum(len(each["to"]) for each in shared.values()))
        for body, each in shared.items():
            rows = len(each["to"])
            np.testing.assert_array_equal(data["row"][:rows], range(rows))
            np.testing.assert_array_equal(data["to"].sel(body=body)[:rows], each["to"].values)
            np.testing.assert_array_equal(frame[frame["body"] == body]["to"], each["to"].values)
        probabilities = results.by_body("probabilities")
        self.assertEqual(set(probabilities.to_pandas().columns), {"body", *probabilities["flat"]})
        self.assertEqual(set(probabilities.to_xarray().data_vars), set(probabilities["flat"]))
        self.assertEqual(list(results.table("limit_states").to_pandas()["name"]), ["overturning", "slides"])

    def test_of_other_groups_name_those_below_them(self):
        results = overturn.open("campaign.h5")
        below = "quantiles/flat/peak_rotation_ratio, quantiles/wide one/peak_rotation_ratio, quantiles/wide one/peak_slip"
        for group in ("quantiles", "pairs", "together", "criterion_by_level", "quantiles/wide one", "stripes"):
            with self.assertRaisesRegex(overturn.Error, f"campaign.h5: {group} holds no columns itself, .* {group}/"):
                results.table(group)
        with self.assertRaisesRegex(overturn.Error, below + "$"):
            results.table("quantiles")
        with self.assertRaisesRegex(overturn.Error, "quantiles/flat holds no columns itself, .* quantiles/flat/peak_rotation_ratio$"):
            results.by_body("quantiles")
        with self.assertRaisesRegex(overturn.Error, r'limit_states holds no groups, but columns. Ask for table\("limit_states"\)'):
            results.by_body("limit_states")
        self.assertEqual(list(results.by_body("quantiles/wide one")), ["peak_rotation_ratio", "peak_slip"])

    def test_without_anything_are_empty(self):
        shutil.copy("campaign.h5", "empty.h5")
        with h5py.File("empty.h5", "r+") as file:
            file.create_group("of_none/flat")
        results = overturn.open("empty.h5", unverified=True)
        self.assertEqual(len(results.table("of_none/flat")), 0)
        self.assertEqual(len(results.by_body("of_none")["flat"]), 0)


class Datasets(unittest.TestCase):
    def setUp(self):
        self.results = overturn.open("campaign.h5")

    def test_variables_have_axes_units_and_names(self):
        trials = self.results.trials.to_xarray()
        self.assertEqual(dict(trials.sizes), {"trial": 24})
        self.assertEqual(trials["peak_rotation"].attrs["units"], "rad")
        self.assertEqual(set(trials["body"].values), {"wide one", "flat"})
        self.assertEqual(trials["verdict"].attrs["categories"][3], "overturned")

    def test_bodies_lie_side_by_side(self):
        stripes = self.results.stripes.to_xarray()
        self.assertEqual(stripes["probability"].dims, ("body", "amplitude"))
        answered = self.results.by_body("models").to_xarray()
        self.assertEqual(answered["trials"].dims, ("body", "model"))
        for body in ("wide one", "flat"):
            np.testing.assert_array_equal(stripes["trials"].sel(body=body), self.results.stripes[body]["trials"].values)
            self.assertEqual(answered["trials"].sel(body=body).sum(), 12)
        offered = self.results.by_body("waves").to_xarray(["v_wes"])
        self.assertEqual(offered["v_wes"].dims, ("body", "wave"))
        self.assertEqual(offered["v_wes"].attrs["units"], "m/s")
        self.assertEqual(self.results.bodies.to_xarray()["mass"].dims, ("body",))
        self.assertEqual(self.results.curves.to_xarray()["median"].sel(measure="pga").dims, ("body",))


class Files(unittest.TestCase):
    def refused(self, path, why, **how):
        with self.assertRaisesRegex(overturn.Error, why) as caught:
            overturn.open(path, **how)
        self.assertEqual(str(caught.exception).count("\n"), 0)

    def test_that_changed_are_refused_unless_asked_for(self):
        content = bytearray(Path("campaign.h5").read_bytes())
        for at in (2000, len(content) // 2, len(content) - 30):
            changed = content.copy()
            changed[at] ^= 1
            Path("changed.h5").write_bytes(changed)
            self.refused("changed.h5", "changed.h5: (not as it was written|never sealed)")
        shutil.copy("campaign.h5", "edited.h5")
        with h5py.File("edited.h5", "r+") as file:
            file.attrs["title"] = "edited"
        self.refused("edited.h5", "never sealed, or edited")
        self.assertEqual(len(overturn.open("edited.h5", unverified=True).trials["verdict"]), 24)
        with h5py.File("edited.h5", "r+") as file:
            file.attrs["format_version"] = 99
        self.refused("edited.h5", "of format 99 .*Take the package of the program", unverified=True)

    def test_of_others_are_refused(self):
        Path("text.h5").write_text("no such file")
        self.refused("text.h5", "no results file of overturn")
        self.refused("campaign.toml", "no results file of overturn")
        self.refused("nowhere.h5", "not there")
        h5py.File("other.h5", "w").close()
        self.refused("other.h5", "no results file of overturn", unverified=True)

    def test_of_an_older_format_say_so(self):
        with self.assertWarnsRegex(UserWarning, "format 3; `overturn status`"):
            overturn.open("format-3.h5")

    def test_of_the_newest_format_are_what_the_program_writes(self):
        from overturn import results
        self.assertEqual(overturn.open("campaign.h5").about["format_version"], results.NEWEST)


if __name__ == "__main__":
    pd.set_option("mode.chained_assignment", "raise")
    unittest.main()
