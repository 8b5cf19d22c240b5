"""The program called from Python: its results opened, its errors raised with its own words."""

import os
import pathlib
import unittest
from unittest import mock

import overturn
from overturn import program


class Calling(unittest.TestCase):
    def test_run_opens_what_it_computed(self):
        with overturn.run("campaign.toml", "small.h5", settings={"waves.count": 2, "title": "two waves"}) as results:
            self.assertEqual(len(results.trials["verdict"]), 2 * 3 * 2)
            self.assertEqual(results.about["title"], "two waves")
        with overturn.open("campaign.h5") as four, overturn.open("small.h5") as two:  # a wave is the same whatever lies beside it
            self.assertEqual(list(four.trials["peak_rotation"].values[:12]), list(two.trials["peak_rotation"].values))

    def test_errors_are_the_programs(self):
        with self.assertRaises(overturn.Failed) as caught:
            overturn.run("campaign.toml", "small.h5", settings={"waves.cuont": 2})
        self.assertEqual(caught.exception.code, 2)
        self.assertIn("waves.cuont", str(caught.exception))
        alone = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
        with mock.patch.dict(os.environ, alone), self.assertRaisesRegex(overturn.Failed, "^overturn: .*waves.cuont"):
            overturn.run("campaign.toml", "small.h5", settings={"waves.cuont": 2}, launch="mpirun -n 2")
        with self.assertRaisesRegex(overturn.Failed, "nowhere.toml"):
            overturn.run("nowhere.toml")
        with self.assertRaisesRegex(overturn.Error, "/nowhere/overturn: cannot be run"):
            overturn.run("campaign.toml", program="/nowhere/overturn")

    def test_a_stopped_run_goes_on(self):
        many = {"waves.count": 40}
        with self.assertRaises(overturn.Stopped) as caught:
            overturn.run("campaign.toml", "stopped.h5", settings=many, max_walltime="0.05 s")
        self.assertEqual(caught.exception.code, 3)
        self.assertRegex(str(caught.exception), r"^stopped early: \d+ of 40 blocks are done and safe\. Go on with: ")
        told = overturn.status("stopped.h5")
        self.assertFalse(told.complete)
        self.assertEqual(told.facts["blocks"]["done"] + told.facts["blocks"]["left"], 40)
        self.assertFalse(told.facts["under_way"])
        self.assertIn("--resume", told.facts["next"])
        if told.facts["blocks"]["done"]:
            interim = overturn.fit("stopped.h5", interim=True)["interim"]
            self.assertEqual((interim["waves"], interim["planned"]), (told.facts["waves"]["done"], 40))
        with overturn.run("campaign.toml", "stopped.h5", settings=many, resume=True) as results:
            self.assertEqual(len(results.waves["id"]), 40)
        self.assertTrue(overturn.status("stopped.h5").complete)
        self.assertIsNone(overturn.fit("stopped.h5")["interim"])
        with overturn.run("campaign.toml", "stopped.h5", settings={"waves.count": 42}, extend=True) as results:
            self.assertEqual(len(results.waves["id"]), 42)

    def test_status_and_fit_are_parsed(self):
        told = overturn.status("campaign.h5")
        self.assertTrue(told.complete)
        self.assertIn("24 trials", told.text)
        with self.assertRaises(overturn.Failed):
            overturn.status("campaign.toml")
        stripes = overturn.fit("campaign.h5")["stripes"]
        with overturn.open("campaign.h5") as results:
            counted = [s["overturned"] for s in stripes if s["body"] == "flat" and s["limit"] == "overturning"]
            self.assertEqual(counted, list(results.stripes["flat"]["overturned"].values))

    def test_the_program_is_the_one_beside_the_package(self):
        prefix = pathlib.Path("prefix").absolute()
        package, beside = prefix / "share/overturn/python/overturn", prefix / "bin/overturn"
        for folder in (package, beside.parent):
            folder.mkdir(parents=True)
        beside.touch(0o755)
        with mock.patch.dict(os.environ), mock.patch.object(program, "HERE", package):
            del os.environ["OVERTURN"]
            self.assertEqual(program.program_path(), str(beside))
            beside.unlink()
            os.environ["PATH"] = ""
            with self.assertRaisesRegex(overturn.Error, "no program overturn"):
                program.program_path()


if __name__ == "__main__":
    unittest.main()
