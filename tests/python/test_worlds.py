# SPDX-License-Identifier: MIT
"""The engine in Python is the program's: the same bits, no copies, metrics of one's own."""

import math
import pathlib
import tempfile
import unittest

import impetus
import numpy

CROWD = "stimuli/creatures-in-a-cube.json"


class Worlds(unittest.TestCase):
    def test_a_condition_steps_to_the_hashes_that_the_program_recorded(self):
        protocol = impetus.load_protocol("protocols/causality.json")
        with tempfile.TemporaryDirectory() as folder:
            study = impetus.run(protocol, pathlib.Path(folder) / "s.sqlite", observer="causality",
                                participants=1, seed=3)
            trial = study.trials[study.trials.phase == "main"].iloc[0]
            recorded = [step["recorded_hash"] for step in study.replay(int(trial.id))]
        levels = {name.removeprefix("factor_"): trial[name]
                  for name in trial.index if name.startswith("factor_")}
        condition = next(each for each in protocol.conditions()
                         if all(float(each[key]) == float(levels[key]) for key in each))
        world = protocol.world(condition)
        own = [world.hash] + [world.step().hash for _ in recorded[1:]]
        self.assertEqual(own, recorded)

    def test_states_are_the_worlds_own_memory(self):
        world = impetus.world("stimuli/two-spheres.json")
        positions = world.positions
        before = positions.copy()
        self.assertFalse(positions.flags.owndata)
        world.step()
        self.assertFalse(numpy.array_equal(positions, before))
        numpy.testing.assert_array_equal(positions, world.positions)
        positions[0] = (1.0, 2.0, 3.0)
        numpy.testing.assert_array_equal(world.positions[0], (1.0, 2.0, 3.0))

    def test_arrays_outlive_the_world(self):
        positions = impetus.world("stimuli/two-spheres.json").positions
        self.assertTrue(numpy.isfinite(positions).all())

    def test_free_motion_keeps_momentum_and_energy(self):
        world = impetus.world("stimuli/two-spheres.json")
        energy = world.kinetic_energy_J
        momenta = world.linear_momenta.sum(axis=0)
        while world.time_s < world.ends_s:
            world.step()
        self.assertAlmostEqual(world.kinetic_energy_J / energy, 1.0, places=9)
        numpy.testing.assert_allclose(world.linear_momenta.sum(axis=0), momenta, atol=1e-12)
        numpy.testing.assert_allclose(numpy.linalg.norm(world.orientations, axis=1), 1.0)

    def test_two_spheres_meet_once_and_the_contact_says_how(self):
        world = impetus.world("stimuli/two-spheres.json")
        began = []
        while world.time_s < world.ends_s:
            began += [each for each in world.step().collisions if each.began]
        self.assertEqual(len(began), 1)
        self.assertEqual({began[0].body_a, began[0].body_b}, set(world.bodies))
        self.assertAlmostEqual(float(numpy.linalg.norm(began[0].normal)), 1.0)
        self.assertGreater(began[0].impulse_Ns, 0.0)
        self.assertEqual(len(began[0].contacts), 1)

    def test_trees_bound_their_bodies_ever_closer(self):
        world = impetus.world("stimuli/two-l-blocks.json")
        tree = world.tree(world.bodies[0])
        errors = [tree.fit_error_m(level) for level in range(tree.levels)]
        self.assertGreater(tree.levels, 1)
        self.assertLess(errors[-1], errors[0])
        self.assertEqual(tree.spheres(0).shape, (1, 4))
        with self.assertRaisesRegex(IndexError, "expected a level from 0 to"):
            tree.spheres(tree.levels)
        with self.assertRaisesRegex(KeyError, "expected a body of the world, got nobody"):
            world.tree("nobody")

    def test_work_limits_what_is_refined(self):
        full, limited = impetus.world(CROWD), impetus.world(CROWD)
        levels = {"full": [], "limited": []}
        for _ in range(120):
            levels["full"] += [each.level for each in full.step().collisions]
            levels["limited"] += [each.level for each in limited.step(work=0).collisions]
        self.assertGreater(max(levels["full"]), 0)
        self.assertLess(numpy.mean(levels["limited"]), numpy.mean(levels["full"]))

    def test_steps_that_cannot_be_meant_are_refused(self):
        world = impetus.world(CROWD)
        with self.assertRaisesRegex(ValueError, "work: expected 0 units or more, got -1"):
            world.step(work=-1)
        for place in ((math.nan, 0.0), (0.0, math.inf)):
            with self.assertRaisesRegex(ValueError, "looks_at_m: expected two finite numbers"):
                world.step(looks_at_m=place)
        self.assertEqual(world.number, 0)

    def test_a_metric_in_python_is_as_good_as_the_engines_own(self):
        own, named = impetus.world(CROWD), impetus.world(CROWD)
        asked = []

        def distance(pair):
            asked.append((pair.a, pair.b))
            return float(numpy.linalg.norm((pair.centre_a + pair.centre_b) / 2 - pair.eye))

        own.set_metric(distance, urgent="small")
        named.set_metric("distance")
        for _ in range(60):
            self.assertEqual(own.step(work=200).hash, named.step(work=200).hash)
        self.assertTrue(asked)

    def test_another_metric_leads_elsewhere(self):
        crowd = impetus.load_protocol("protocols/crowd.json")
        worlds = {urgent: crowd.world(crowd.conditions()[0]) for urgent in ("small", "large")}
        for urgent, world in worlds.items():
            world.set_metric(lambda pair: float(pair.centre_a[2]), urgent=urgent)
        last = {urgent: [world.step().hash for _ in range(90)][-1]
                for urgent, world in worlds.items()}
        self.assertNotEqual(last["small"], last["large"])

    def test_what_a_metric_raises_arrives_and_the_world_says_that_it_is_broken(self):
        world = impetus.world(CROWD)
        world.set_metric(lambda pair: 1 / 0)
        with self.assertRaises(ZeroDivisionError):
            for _ in range(240):
                world.step(work=300)
        with self.assertRaisesRegex(RuntimeError, "in the middle of a step"):
            world.step()

    def test_metrics_that_are_none_are_refused(self):
        world = impetus.world(CROWD)
        with self.assertRaisesRegex(ValueError, "nearness"):
            world.set_metric("nearness")
        with self.assertRaisesRegex(ValueError, 'expected "large" or "small", got "big"'):
            world.set_metric(lambda pair: 1.0, urgent="big")
        world.set_metric(lambda pair: float("nan"))
        with self.assertRaisesRegex(ValueError, "expected a finite number for every pair"):
            for _ in range(240):
                world.step(work=300)


if __name__ == "__main__":
    unittest.main()
