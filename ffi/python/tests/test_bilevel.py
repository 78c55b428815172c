"""Worlds of the framework bilevel_planning: a cart that drives onto a mark of some width."""

import dataclasses
import random
import types
import unittest
from typing import Any

from critreg import Ground

try:
    from critreg.bilevel import World
except ImportError:  # Without NumPy, which the framework needs.
    World = None


@dataclasses.dataclass(frozen=True, order=True)
class Type:
    name: str
    parent: Any = None


@dataclasses.dataclass(frozen=True, order=True)
class Thing:
    name: str
    type: Type


@dataclasses.dataclass(frozen=True)
class Predicate:
    name: str
    types: tuple


@dataclasses.dataclass(frozen=True)
class Atom:
    predicate: Predicate
    entities: tuple


class State(dict):
    def get(self, thing, name):
        return self[thing][name]


CART, MARK = Type("cart"), Type("mark")
ON = Predicate("On", (CART, MARK))
cart, mark = Thing("cart", CART), Thing("mark", MARK)


class DriveController:
    def __init__(self, objects):
        self.objects = objects

    def sample_parameters(self, state, rng):
        return (rng.uniform(-1, 1), 7.0)

    def reset(self, state, parameters):
        assert isinstance(parameters, tuple) and parameters[1] == 7.0
        self.left = [parameters[0] / 2] * 2

    def terminated(self):
        return not self.left

    def step(self):
        return self.left.pop()

    def observe(self, state):
        pass


def moved(state, by):
    after = State({thing: dict(values) for thing, values in state.items()})
    after[cart]["x"] += by
    return after


def abstract(state):
    near = abs(state[cart]["x"] - state[mark]["x"]) <= 0.5 * state[mark]["width"]
    atoms = {Atom(ON, (cart, mark))} if near else set()
    return types.SimpleNamespace(atoms=atoms, objects={cart, mark})


def task(seed):
    chance = random.Random(seed)
    return State(
        {
            cart: {"x": chance.uniform(-0.5, 0.5)},
            mark: {"x": chance.uniform(-0.5, 0.5), "width": chance.uniform(0.05, 0.2)},
        }
    )


def models():
    variables = Thing("?cart", CART), Thing("?mark", MARK)
    drive = types.SimpleNamespace(
        name="Drive",
        parameters=variables,
        preconditions=set(),
        add_effects={Atom(ON, variables)},
        delete_effects=set(),
    )
    controller = types.SimpleNamespace(controller_cls=DriveController, ground=DriveController)
    return types.SimpleNamespace(
        types={CART, MARK},
        predicates={ON},
        skills=[types.SimpleNamespace(operator=drive, controller=controller)],
        transition_fn=moved,
        state_abstractor=abstract,
        goal_deriver=lambda state: types.SimpleNamespace(atoms={Atom(ON, (cart, mark))}),
    )


class RingController(DriveController):
    def sample_parameters(self, state, rng):
        return (0.0, 7.0)


RUNG = Predicate("Rung", (MARK,))


def ringing():
    """Models in which a bell rings in the inner half of the mark, where the cart is."""

    def rung(state, by):
        after = moved(state, by)
        if by == 0.0 and abs(state[cart]["x"] - state[mark]["x"]) <= 0.25 * state[mark]["width"]:
            after[mark]["rung"] = 1.0
        return after

    def atoms(state):
        found = abstract(state)
        if state[mark].get("rung"):
            found.atoms.add(Atom(RUNG, (mark,)))
        return found

    own = models()
    variables = Thing("?cart", CART), Thing("?mark", MARK)
    ring = types.SimpleNamespace(
        name="Ring",
        parameters=variables,
        preconditions={Atom(ON, variables)},
        add_effects={Atom(RUNG, variables[1:])},
        delete_effects=set(),
    )
    controller = types.SimpleNamespace(controller_cls=RingController, ground=RingController)
    own.predicates.add(RUNG)
    own.skills.append(types.SimpleNamespace(operator=ring, controller=controller))
    own.transition_fn, own.state_abstractor = rung, atoms
    own.goal_deriver = lambda state: types.SimpleNamespace(atoms={Atom(RUNG, (mark,))})
    return own


RING = """
object cart { x: length }
object mark { x: length, width: length }
feature beside = cart.x - mark.x: length
"""
TEXT = """
object cart { x: length }
object mark { x: length, width: length }
parameter by in [LOW, HIGH]: length
point there = world + (cart.x + by, 0)
"""
WHOLE = TEXT.replace("LOW", "-1").replace("HIGH", "1")
CASES = {
    "back": TEXT.replace("LOW", "-1").replace("HIGH", "0"),
    "forth": TEXT.replace("LOW", "0").replace("HIGH", "1"),
}


@unittest.skipIf(World is None, "the framework needs NumPy")
class Worlds(unittest.TestCase):
    def solve(self, text):
        world = World(models(), {"DriveController": text})
        tasks = [task(seed) for seed in range(40)]
        skills = world.learn(tasks, learner={"calls": 100})
        samples = 0
        for seed in range(100, 120):
            state = task(seed)
            planner = world.planner(state, lookahead=8)
            plan = world.plan(state, skills, seed, planner)
            self.assertTrue(abstract(plan.states[-1]).atoms)
            self.assertEqual((len(plan.states), len(plan.actions)), (3, 2))
            samples += planner.metrics().samples
        return skills, samples

    def test_skills_are_learned_and_planned_with(self):
        skills, samples = self.solve(WHOLE)
        self.assertIsNotNone(skills[0].region, skills[0].text)
        self.assertLessEqual(samples, 22)

    def test_a_case_is_an_operator(self):
        skills, samples = self.solve(CASES)
        names = [skill.name for skill in skills]
        self.assertEqual(names, ["DriveController-back", "DriveController-forth"])
        self.assertLessEqual(samples, 24)

    def test_what_is_foreseen_keeps_away_from_where_later_steps_fail(self):
        world = World(ringing(), {"DriveController": WHOLE, "RingController": RING})
        tasks = [task(seed) for seed in range(40)]
        skills = world.learn(tasks, learner={"calls": 100}, states=80)
        ring = skills[1]
        self.assertIsNotNone(ring.region, ring.text)
        self.assertEqual(ring.domain.split(), RING.split())
        off = []
        for seed in range(100, 120):
            state = task(seed)
            plan = world.plan(state, skills, seed, world.planner(state, lookahead=32))
            self.assertEqual([step.name for step in plan.steps], ["Drive", "Ring"])
            place = plan.states[2][cart]["x"] - state[mark]["x"]
            off.append(abs(place) / (0.25 * state[mark]["width"]))
        # Of draws that are uniform half would be nearer to the middle than half way.
        self.assertLess(sum(off) / len(off), 0.25, off)

    def test_what_is_refused_too_often_fails_in_training(self):
        def stopped(state, by):
            after = moved(state, by)
            return state if after[cart]["x"] > 0.6 else after

        own = models()
        own.transition_fn = stopped
        world = World(own, {"DriveController": WHOLE}, refused=0)
        numbers = world.numbers(State({cart: {"x": 0.0}, mark: {"x": 0.5, "width": 0.2}}))
        drive = Ground("Drive", ("cart", "mark"))
        # It is stopped half way, where it happens to be on the mark.
        self.assertIsNotNone(world.execute(drive, [1.0], numbers))
        self.assertIsNone(world.practise(drive, [1.0], numbers))
        self.assertIsNotNone(world.practise(drive, [0.5], numbers))

    def test_wrong_names_are_told(self):
        with self.assertRaisesRegex(ValueError, "no controller Fly, but DriveController"):
            World(models(), {"Fly": WHOLE})
        with self.assertRaisesRegex(ValueError, "object cat: there is no type cat"):
            World(models(), {"DriveController": "object cat { x: length }"})


if __name__ == "__main__":
    unittest.main()
