"""Skills: boxes on a table, and a shelf with a low board; a box that is gripped too high cannot be
pushed in, as the palm hits the board."""

import random
import unittest

import critreg

DOMAIN = """
(define (domain boxes) (:types box shelf)
  (:predicates (Stored ?b - box) (Held ?b - box) (HandEmpty))
  (:action Pick :parameters (?b - box) :precondition (HandEmpty)
    :effect (and (Held ?b) (not (HandEmpty))))
  (:action PushIn :parameters (?b - box ?s - shelf) :precondition (Held ?b)
    :effect (and (Stored ?b) (HandEmpty) (not (Held ?b)))))
"""
LAYOUT = """
type hand { grip: length }
type shelf { room: length }
type box { height: length, held: flag, stored: flag }
object hand: hand
object shelf: shelf
object boxes[3]: box
"""
PICK = """
constant finger.length = 0.06: length  constant hand.height = 0.11: length
object box { height: length }
object hand { grip: length }
parameter grip in [0, 0.4]: length
"""
PUSH_IN = """
constant finger.length = 0.06: length  constant hand.height = 0.11: length
object hand { grip: length }
object shelf { room: length }
"""


def execute(ground, parameters, state):
    after = list(state)
    box = 2 + 3 * int(ground.objects[0][1:])
    if ground.name == "Pick":
        height = state[box]
        after[0], after[box + 1] = parameters[0], 1.0
        return after if height - 0.06 <= parameters[0] <= height else None
    after[box + 1], after[box + 2] = 0.0, 1.0
    return after if state[0] + 0.11 <= state[1] else None


def holds(ground, state):
    if ground.name == "HandEmpty":
        return not any(state[3::3])
    box = 2 + 3 * int(ground.objects[0][1:])
    return state[box + (1 if ground.name == "Held" else 2)] > 0.5


def task(seed):
    """A problem, and its state: hand, shelf, then height, held and stored of each box."""
    chance = random.Random(seed)
    room = chance.uniform(0.2, 0.35)
    boxes = range(1 + seed % 3)
    state = [0.0, room]
    for _ in boxes:
        state += [chance.uniform(0.08, room - 0.11 + 0.05), 0.0, 0.0]
    names = " ".join(f"b{box}" for box in boxes)
    problem = f"""(define (problem tidy) (:domain boxes)
        (:objects {names} - box shelf - shelf) (:init (HandEmpty)) (:goal (Stored b0)))"""
    return problem, state


def make(pair=True, **options):
    options = {"situations": 12, "states": 60, "chained": 60, **options}
    skills = critreg.Skills(
        DOMAIN, LAYOUT, [task(seed) for seed in range(60)], learner={"calls": 60}, **options
    )
    skills.add_controller("Pick", [(0.0, 0.4)], objects=["?b"])
    skills.add("Pick", PICK)
    skills.add("PushIn", PUSH_IN)
    if pair:
        skills.add_pair("Pick", "PushIn")
    return skills


class Learning(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.skills = make()
        cls.skills.learn(execute, holds)

    def plans(self, seed, lookahead=0, **options):
        problem, state = task(seed)
        planner = critreg.Planner(
            DOMAIN, problem, state_len=len(state), max_tries=40, lookahead=lookahead
        )
        planner.set_ranges("Pick", [(0.0, 0.4)])
        steps = planner.plan(state, execute, holds, seed=seed, **options)
        return planner, steps

    def test_regions_are_those_of_the_world(self):
        pick, push, pair = self.skills
        self.assertEqual([pick.name, push.name, pair.name], ["Pick", "PushIn", "Pick, then PushIn"])
        self.assertIn("hand.grip", push.text)
        for skill in self.skills:
            self.assertEqual(skill.report.has_region, 1, skill.text)
            self.assertGreater(skill.report.calls, 0)
        # A box of 0.2: gripped by its upper 0.06, and below what the shelf leaves.
        self.assertTrue(pick.region.contains([0.2, 0.0], [0.17]))
        self.assertFalse(pick.region.contains([0.2, 0.0], [0.1]))
        domain = critreg.Domain(pair.domain)
        self.assertEqual(len(domain.parameters), 1)

    def test_planning_needs_as_many_samples_as_steps(self):
        samples = {False: 0, True: 0}
        for seed in range(100, 110):
            for learned in samples:
                options = {"skills": self.skills} if learned else {}
                planner, steps = self.plans(seed, **options)
                self.assertEqual([step.ground.name for step in steps], ["Pick", "PushIn"])
                samples[learned] += planner.metrics().samples
        self.assertEqual(samples[True], 20)
        self.assertGreater(samples[False], 60)

    def test_a_look_ahead_needs_no_pair(self):
        # That the hand is afterwards where it gripped is seen, so it is known what PushIn will
        # find.
        alone = make(pair=False)
        alone.learn(execute, holds)
        again = make(pair=False)
        again.resume(alone.save())
        samples = {0: 0, 32: 0}
        for lookahead in samples:
            for seed in range(100, 130):
                planner, _ = self.plans(seed, lookahead, skills=again)
                samples[lookahead] += planner.metrics().samples
        self.assertEqual(samples[32], 60)
        self.assertGreater(samples[0], 62)

    def test_what_cannot_work_is_said(self):
        problem, state = task(0)
        state[1] = 0.1  # Lower than the hand.
        planner = critreg.Planner(DOMAIN, problem, state_len=len(state))
        with self.assertRaises(critreg.NoPlan):
            planner.plan(state, execute, holds, skills=self.skills, prune=True)
        self.assertIn("needs", planner.reason())
        self.assertEqual(planner.metrics().samples, 0)

    def test_saved_and_resumed(self):
        again = make()
        again.resume(self.skills.save())
        again.learn(lambda *_: self.fail("all is known"), holds)
        self.assertEqual([skill.text for skill in again], [skill.text for skill in self.skills])

    def test_what_a_callback_raises_stops_and_learning_goes_on(self):
        skills, runs = make(), []

        def stop(training):
            runs.append((training.skill, training.runs))
            if len(runs) == 30:
                raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            skills.learn(execute, holds, progress=stop)
        self.assertEqual(runs[0], (0, 1))
        self.assertEqual(skills[2].report.finished, 0)
        self.assertIsNone(skills[2].region)
        resumed = make()
        resumed.resume(skills.save())
        resumed.learn(execute, holds, progress=stop)
        self.assertEqual([skill.text for skill in resumed], [skill.text for skill in self.skills])

    def test_a_sampler_proposes(self):
        asked = []

        def sample(draw, rng):
            asked.append(draw.skeleton[0].name)
            return [0.4 * rng.uniform() for _ in range(draw.parameter_count)]

        make().learn(execute, holds, sample)
        self.assertIn("Pick", asked)

    def test_wrong_texts_and_names(self):
        skills = make()
        with self.assertRaisesRegex(critreg.Error, "line 1, column"):
            skills.add("Pick", "object box [")
        with self.assertRaisesRegex(critreg.Error, "controller"):
            skills.add("Fly", PICK)
        with self.assertRaises(TypeError):
            skills.add_controller("PushIn", objects="?b")
        with self.assertRaisesRegex(critreg.Error, "line 1, column"):
            critreg.Skills(DOMAIN, "type hand {", [])
        with self.assertRaises(TypeError):
            critreg.Skills(DOMAIN, LAYOUT, [task(0)], speed=3)
        with self.assertRaises(critreg.Error):
            make().resume(b"nothing")


if __name__ == "__main__":
    unittest.main()
