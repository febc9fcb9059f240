# SPDX-License-Identifier: MIT
"""Studies in Python are what `impetus export` and `impetus replay` say of them."""

import csv
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import impetus
import pandas


def cell(value) -> str:
    """A value as an export writes it."""
    if value is None or value is pandas.NA or (isinstance(value, float) and value != value):
        return ""
    if isinstance(value, float):
        return repr(value).removesuffix(".0")
    return str(value)


class Studies(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.file = cls.folder / "study.sqlite"
        cls.study = impetus.run(
            "protocols/gap.json", cls.file, observer="gap", participants=2, seed=5
        )
        subprocess.run([impetus.program(), "export", cls.file, "--out", cls.folder / "csv"],
                       check=True, capture_output=True)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def test_every_table_is_the_exported_one_value_for_value(self):
        compared = 0
        for name in self.study.tables:
            frame = self.study.table(name)
            with (self.folder / "csv" / f"{name}.csv").open(newline="", encoding="utf-8") as file:
                rows = list(csv.reader(file))
            self.assertEqual(list(frame.columns), rows[0], name)
            self.assertEqual(len(frame), len(rows) - 1, name)
            for own, exported in zip(frame.itertuples(index=False), rows[1:]):
                for column, value, text in zip(rows[0], own, exported):
                    if text != cell(value):
                        self.assertEqual(float(text), float(value), f"{name}.{column}")
                    compared += 1
        self.assertGreater(compared, 100_000)

    def test_columns_say_their_units_and_meanings(self):
        trials = self.study.trials
        self.assertEqual(trials.attrs["units"]["intended_hold_ms"], "ms")
        self.assertIn("factor", trials.attrs["meanings"]["factor_speed_percent"])
        self.assertTrue(trials.attrs["rows"])
        self.assertTrue(set(trials.attrs["meanings"]) == set(trials.columns))

    def test_missing_values_are_missing_and_integers_stay_integers(self):
        trials = self.study.trials
        self.assertEqual(str(trials["slot"].dtype), "Int64")
        self.assertTrue(pandas.api.types.is_numeric_dtype(trials["factor_speed_percent"]))
        self.assertTrue(trials[trials.phase == "main"].rating.notna().all())

    def test_tables_that_there_are_not_are_refused_with_those_there_are(self):
        with self.assertRaisesRegex(impetus.InputError, "expected one of its tables .*trials.*got tri"):
            self.study.table("tri")
        with self.assertRaisesRegex(AttributeError, "no table trails; it has .*trials"):
            self.study.trails

    def test_a_file_that_is_no_study_is_refused_in_one_sentence(self):
        other = self.folder / "other.sqlite"
        other.write_text("not a study")
        with self.assertRaisesRegex(impetus.InputError, "other.sqlite: expected"):
            impetus.read(other)

    def test_a_replay_has_the_recorded_hashes(self):
        trial = int(self.study.trials.id.iloc[-1])
        replay = self.study.replay(trial)
        steps = list(replay)
        self.assertEqual(len(steps), len(replay))
        self.assertGreater(len(steps), 100)
        self.assertTrue(all(step["hash"] == step["recorded_hash"] for step in steps))
        self.assertEqual(replay.divergence, "")
        self.assertEqual(len(steps[0]["positions_m"]), len(replay.bodies))

    def test_trials_and_intervals_that_were_not_shown_are_refused(self):
        with self.assertRaisesRegex(impetus.InputError, "expected a trial that was shown, got 99999"):
            self.study.replay(99999)
        with self.assertRaisesRegex(impetus.InputError, "interval from 1 to 1, got 2"):
            self.study.replay(int(self.study.trials.id.iloc[0]), interval=2)

    def test_a_what_if_with_the_recorded_settings_changes_nothing_and_another_does(self):
        trials = self.study.trials
        coarse = trials[trials.condition.str.contains('"level":0')]
        trial = int(coarse.id.iloc[0])
        same = self.study.what_if(trial, {"/engine/level": 0})
        self.assertIsNone(same["parts_at_step"])
        self.assertEqual(same["then"], same["now"])
        finer = self.study.what_if(trial, {"/engine/level": 2})
        self.assertIsNotNone(finer["parts_at_step"])
        first = finer["collisions"][0]
        self.assertLess(first["now"]["gap_arcmin"], first["then"]["gap_arcmin"])

    def test_settings_that_there_are_not_are_refused(self):
        with self.assertRaisesRegex(impetus.InputError, "expected"):
            self.study.what_if(int(self.study.trials.id.iloc[0]), {"nonsense": 1})


if __name__ == "__main__":
    unittest.main()
