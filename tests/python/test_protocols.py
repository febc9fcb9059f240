# SPDX-License-Identifier: MIT
"""Protocols written in Python: the same checks, the same sentences, recorded sessions and pilots."""

import json
import pathlib
import subprocess
import tempfile
import unittest

import impetus
import numpy


def refusal_of_program(path: pathlib.Path) -> str:
    done = subprocess.run([impetus.program(), "check", path], capture_output=True, text=True)
    return done.stderr.strip().splitlines()[-1].removeprefix("impetus: ")


class Protocols(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.causality = impetus.load_protocol("protocols/causality.json")

    def test_a_protocol_tells_of_itself(self):
        self.assertEqual(self.causality.name, "causality")
        self.assertEqual(len(self.causality.conditions()), 27)
        plan = self.causality.plan("P01", 1)
        self.assertEqual(sum(trial["phase"] == "main" for trial in plan), 81)
        self.assertIn("# ", self.causality.page())

    def test_a_dictionary_is_the_protocol_that_its_file_is(self):
        same = impetus.protocol(self.causality.document, self.causality.scene)
        self.assertEqual(same.plan(), self.causality.plan())
        self.assertEqual(same.hash, self.causality.hash)
        beside = impetus.protocol(self.causality.document, path="protocols/mine.json")
        self.assertEqual(beside.hash, self.causality.hash)

    def test_mistakes_are_told_as_the_program_tells_them(self):
        mistakes = {
            "design/repetitions": lambda d: d["design"].update(repetitions=0),
            "an unknown key": lambda d: d.update(colour="red"),
            "a pointer to nothing": lambda d: d["design"]["factors"][0].update(pointer="/nowhere"),
            "no scene": lambda d: d.update(scene="nothing.json"),
        }
        for name, spoil in mistakes.items():
            document = self.causality.document
            spoil(document)
            file = self.folder / "protocols" / "spoilt.json"
            file.parent.mkdir(exist_ok=True)
            stimulus = self.folder / "stimuli" / "two-spheres.json"
            stimulus.parent.mkdir(exist_ok=True)
            stimulus.write_text(pathlib.Path("stimuli/two-spheres.json").read_text())
            file.write_text(json.dumps(document, indent=2) + "\n")
            with self.assertRaises(impetus.InputError, msg=name) as raised:
                impetus.protocol(document, path=file)
            self.assertEqual(str(raised.exception), refusal_of_program(file), name)

    def test_scenes_are_checked_too(self):
        scene = impetus.load_scene("stimuli/two-spheres.json")
        scene["engine"]["restitution"] = 7
        with self.assertRaisesRegex(impetus.InputError, "mine.json:/engine/restitution: expected"):
            impetus.scene(scene, "mine.json")
        with self.assertRaisesRegex(impetus.InputError, "/engine/restitution: expected"):
            impetus.protocol(self.causality.document, scene)

    def test_times_that_are_no_whole_frames_are_refused(self):
        document = self.causality.document
        document["design"]["factors"][0]["levels"] = [0, 90]
        document["design"]["practice"] = []
        delays = impetus.protocol(document, self.causality.scene)
        delays.check_frames(60.0, allow_rounding=True)
        with self.assertRaisesRegex(impetus.InputError, "expected"):
            delays.check_frames(60.0)
        for refresh_hz in (0.0, -60.0, float("nan")):
            with self.assertRaisesRegex(ValueError, "refresh_hz: expected 20 to 1000 Hz, got "):
                delays.check_frames(refresh_hz)

    def test_what_no_file_of_json_can_hold_is_refused(self):
        itself = {}
        itself["itself"] = itself
        for value in (float("nan"), {1, 2}, "\udc80", itself):
            document = {**self.causality.document, "title": value}
            with self.assertRaisesRegex(impetus.InputError,
                                        "^protocol.json: expected what a JSON file can hold, got "):
                impetus.protocol(document, self.causality.scene)

    def test_a_pilot_of_nobody_is_refused(self):
        with self.assertRaisesRegex(ValueError, "participants: expected 1 or more, got -3"):
            impetus.pilot(self.causality, lambda question, shown: 0, participants=-3)

    def test_saved_files_are_the_protocol_and_are_not_overwritten(self):
        file = impetus.save(self.causality, self.folder / "protocols" / "again.json")
        self.assertEqual(impetus.load_protocol(file).hash, self.causality.hash)
        with self.assertRaisesRegex(FileExistsError, "nothing is overwritten"):
            impetus.save(self.causality, file)

    def test_numbers_of_a_data_frame_are_numbers(self):
        own = self.causality.conditions()[0]
        levels = {name: numpy.int64(level) for name, level in own.items()}
        self.assertEqual(self.causality.world(levels).number, 0)

    def test_conditions_that_there_are_not_are_refused(self):
        with self.assertRaisesRegex(impetus.InputError, "expected one of its conditions"):
            self.causality.world({"delay_ms": 7})

    def test_a_simulated_group_is_that_of_the_program(self):
        study = impetus.run(self.causality, self.folder / "own.sqlite", observer="causality",
                            participants=2, seed=9)
        subprocess.run([impetus.program(), "run", "protocols/causality.json", "--db",
                        self.folder / "other.sqlite", "--observer", "causality",
                        "--participants", "2", "--seed", "9"], check=True, capture_output=True)
        other = impetus.read(self.folder / "other.sqlite")
        self.assertEqual(len(study.trials), 2 * 87)
        self.assertEqual(list(study.trials.rating), list(other.trials.rating))
        with self.assertWarnsRegex(UserWarning, "2 of them had finished before"):
            impetus.run(self.causality, self.folder / "own.sqlite", observer="causality",
                        participants=2, seed=9)

    def test_what_the_program_refuses_is_raised_in_its_words(self):
        with self.assertRaisesRegex(impetus.CommandError, "expected"):
            impetus.run(self.causality, self.folder / "s.sqlite", observer="nobody-knows",
                        participants=1)

    def test_nothing_written_in_python_decides_a_recorded_session(self):
        for given in ({"metric": lambda pair: 1.0, "observer": "causality"},
                      {"observer": lambda question, shown: 0}):
            with self.assertRaisesRegex(impetus.InputError, "expected no function in a recorded"):
                impetus.run(self.causality, self.folder / "s.sqlite", participants=1, **given)
        self.assertFalse((self.folder / "s.sqlite").exists())


class Pilots(unittest.TestCase):
    def setUp(self):
        self.causality = impetus.load_protocol("protocols/causality.json")

    def test_an_observer_in_python_answers_by_what_was_shown(self):
        def observer(question, shown):
            self.assertEqual(question["kind"], "rating")
            return 2 if shown[0]["realised_hold_s"] > 0.05 else question["best_choice"]

        trials = impetus.pilot(self.causality, observer, participants=2)
        self.assertEqual(len(trials), 2 * 87)
        self.assertEqual(list(trials.participant.unique()), ["S01", "S02"])
        late = trials.factor_delay_ms > 0
        self.assertEqual(set(trials[late].rating), {3})
        self.assertEqual(set(trials[~late].rating), {1})

    def test_two_intervals_are_both_shown(self):
        protocol = impetus.load_protocol("protocols/gap-thresholds.json")
        seen = []

        def observer(question, shown):
            seen.append((question["kind"], len(shown)))
            return 0

        impetus.pilot(protocol, observer)
        self.assertEqual(set(seen) & {("two_interval", 1)}, set())
        self.assertTrue(seen)

    def test_a_pilots_trial_is_simulated_as_a_recorded_one(self):
        with tempfile.TemporaryDirectory() as folder:
            study = impetus.run(self.causality, pathlib.Path(folder) / "s.sqlite",
                                observer="causality", participants=1, seed=4)
            slot = int(study.trials.slot.iloc[-1])
            recorded = list(study.replay(int(study.trials.id.iloc[-1])))[-1]["recorded_hash"]
            own = impetus.pilot(self.causality, lambda question, shown: 0, seed=4)
        self.assertEqual(own[own.slot == slot].hash.iloc[0], recorded)

    def test_a_metric_in_python_measures_pairs(self):
        measured = []

        def metric(pair):
            measured.append(pair.b)
            return float(pair.radius_a)

        trials = impetus.pilot(self.causality, lambda question, shown: 0, metric=metric)
        self.assertEqual(set(measured), {1})  # the two spheres, where they are near
        self.assertTrue(trials.collisions.map(lambda all: all[0]["priority"] > 0).all())

    def test_answers_that_are_no_choice_are_refused(self):
        for given in (7, "late", None):
            with self.assertRaisesRegex(ValueError, "expected an index from 0 to 2, got"):
                impetus.pilot(self.causality, lambda question, shown: given)

    def test_marks_beside_a_sliders_line_are_refused(self):
        protocol = impetus.load_protocol("protocols/two-balls.json")
        for given in (1e9, -500, float("nan"), "far", None):
            with self.assertRaisesRegex(ValueError, r"expected a number from -?\d+ to 100, got"):
                impetus.pilot(protocol, lambda question, shown: given)

    def test_what_an_observer_raises_arrives(self):
        with self.assertRaises(ZeroDivisionError):
            impetus.pilot(self.causality, lambda question, shown: 1 // 0)

    def test_a_protocol_that_follows_the_gaze_is_refused(self):
        with self.assertRaisesRegex(impetus.InputError, "does not follow the gaze"):
            impetus.pilot(impetus.load_protocol("protocols/gaze-contingent.json"),
                          lambda question, shown: 0)


if __name__ == "__main__":
    unittest.main()
