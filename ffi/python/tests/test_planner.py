"""Planning: a cart that drives along a rail and lights a lamp."""

import unittest

import critreg

DOMAIN = """
(define (domain rail)
  (:types lamp)
  (:predicates (At ?l - lamp) (Lit ?l - lamp))
  (:action Drive :parameters (?l - lamp) :effect (At ?l))
  (:action Light :parameters (?l - lamp) :precondition (At ?l) :effect (Lit ?l)))
"""
PROBLEM = """
(define (problem light) (:domain rail) (:objects red - lamp) (:init) (:goal (Lit red)))
"""
RAIL = "object cart { x: length }\nconstant lamp.x = 3.0: length\nparameter by in [-4, 4]: length\n"


def execute(ground, parameters, state):
    if ground.name == "Drive":
        return [state[0] + parameters[0], state[1]]
    return [state[0], 1.0], 2


def holds(ground, state):
    return 2.9 < state[0] < 3.1 if ground.name == "At" else state[1] > 0.5


class Planning(unittest.TestCase):
    def setUp(self):
        self.planner = critreg.Planner(DOMAIN, PROBLEM, state_len=2)
        self.planner.set_ranges("Drive", [(-4.0, 4.0)])
        self.region = critreg.Region(
            RAIL, "cart.x + by >= lamp.x - 0.05 and cart.x + by <= lamp.x + 0.05"
        )

    def sample(self, draw, rng):
        if draw.parameter_count == 0:
            return critreg.Drawn([])
        return critreg.Drawn(self.region.sample([draw.state[0]], rng))

    def test_a_plan_reaches_the_goal(self):
        drive, light = self.planner.plan([0.0, 0.0], execute, holds, seed=1)
        self.assertEqual((str(drive.ground), str(light.ground)), ("(Drive red)", "(Light red)"))
        self.assertAlmostEqual(drive.parameters[0], 3.0, delta=0.1)
        self.assertEqual((light.parameters, light.state[1], light.actions), ([], 1.0, 2))
        self.assertEqual(self.planner.metrics().plan_length, 2)
        self.assertEqual(self.planner.why(), "")

    def test_a_region_saves_samples(self):
        self.planner.plan([0.0, 0.0], execute, holds, seed=1)
        blind = self.planner.metrics().samples
        steps = self.planner.plan([0.0, 0.0], execute, holds, self.sample, seed=1)
        self.assertEqual((len(steps), self.planner.metrics().samples), (2, 2))
        self.assertGreater(blind, 2)
        again = self.planner.plan([0.0, 0.0], execute, holds, self.sample, seed=1)
        self.assertEqual(again, steps)

    def test_an_empty_region_is_no_plan_and_reasons_are_counted(self):
        def sample(draw, rng):
            raise critreg.EmptyRegion("out of reach", reason=5)

        with self.assertRaises(critreg.NoPlan) as caught:
            self.planner.plan([0.0, 0.0], lambda *_: None, holds, sample)
        self.assertEqual(caught.exception.status, critreg.Status.NO_PLAN)
        self.assertEqual(str(caught.exception), self.planner.why())
        self.assertGreater(self.planner.reasons(5), 0)
        self.assertGreater(self.planner.metrics().empty_draws, 0)
        self.assertGreater(self.planner.failures("Drive"), 0)

    def test_advice(self):
        asked = []

        def advise(prefix, initial):
            asked.append([str(ground) for ground in prefix])
            return critreg.Advice.PRUNE, 3

        with self.assertRaises(critreg.NoPlan):
            self.planner.plan([0.0, 0.0], execute, holds, advise=advise)
        self.assertEqual(asked[0], ["(Drive red)"])
        self.assertGreater(self.planner.metrics().pruned, 0)
        self.assertGreater(self.planner.reasons(3), 0)

    def test_what_callbacks_raise_comes_through(self):
        def broken(*_):
            raise OSError("no power")

        for callbacks in (
            {"execute": broken, "holds": holds},
            {"execute": execute, "holds": broken},
            {"execute": execute, "holds": holds, "sample": broken},
            {"execute": execute, "holds": holds, "advise": broken},
        ):
            with self.assertRaisesRegex(OSError, "no power"):
                self.planner.plan([0.0, 0.0], **callbacks)
        self.assertEqual(len(self.planner.plan([0.0, 0.0], execute, holds, seed=1)), 2)

    def test_wrong_answers_of_callbacks(self):
        for execute_wrongly in (lambda *_: [0.0], lambda *_: "ab", lambda *_: ([0.0, 0.0], -1)):
            with self.assertRaises((TypeError, ValueError)):
                self.planner.plan([0.0, 0.0], execute_wrongly, holds)
        with self.assertRaises(ValueError):
            self.planner.plan([0.0, 0.0], execute, holds, lambda draw, rng: [1.0, 2.0])
        with self.assertRaises(ValueError):
            self.planner.plan([0.0, 0.0], execute, holds, advise=lambda *_: 7)

    def test_wrong_texts_and_numbers(self):
        with self.assertRaisesRegex(critreg.Error, "problem, line 2, column"):
            critreg.Planner(DOMAIN, PROBLEM.replace("red - lamp", "red - star"), state_len=2)
        with self.assertRaisesRegex(critreg.Error, "Fly|action"):
            self.planner.set_ranges("Fly", [(0.0, 1.0)])
        with self.assertRaises(ValueError):
            self.planner.set_ranges("Drive", [(0.0, 1.0, 2.0)])
        with self.assertRaises(ValueError):
            self.planner.plan([0.0], execute, holds)


if __name__ == "__main__":
    unittest.main()
