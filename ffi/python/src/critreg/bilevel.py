"""Skills for worlds of the framework bilevel_planning, such as those of KinDER.

    world = World(models, TEXTS)                    # SesameModels as they are
    skills = world.learn(initial_states)            # by running the controllers
    plan = world.plan(state, skills)                # states and actions, or NoPlan

Predicates, operators, controllers and the simulator are those of the models; what is added
are texts that say what there is (ACTIONS.md). Nothing of the framework is imported: models are
whatever has the attributes of its `SesameModels`.
"""

from __future__ import annotations

from typing import Any, Callable, Iterator, Mapping, NamedTuple, Optional, Sequence, Union

import numpy

from .domain import Domain
from .planner import Planner
from .region import Rng
from .skills import Skills
from .status import NoSample
from .world import Draw, Ground

MAX_NUMBERS = 64
"""Most numbers of a state; CRITREG_MAX_STATE_NUMBERS."""
MAX_OBJECTS = 32
"""Most objects of a task; CRITREG_MAX_STATE_OBJECTS."""

Text = Union[str, None, Mapping[str, str]]
"""What can be said of a controller; or of its cases, by their names: parameters that are a
choice among several, each with a text of its own whose ranges are those of that case."""

Texts = Mapping[Union[str, tuple[str, str]], Text]
"""Texts by the names of controllers, or of pairs of them; None: made by the library."""


class Plan(NamedTuple):
    """A plan, step by step and as the framework has it."""

    steps: list[Ground]
    """Its operators."""
    states: list[Any]
    """The states from the first to the last."""
    actions: list[Any]
    """The actions between them."""


class _Action(NamedTuple):
    """An operator of the models, in one of the cases of its controller."""

    name: str
    skill: Any
    controller: str


class _Controller(NamedTuple):
    """A controller, or one of its cases."""

    name: str
    actions: list[_Action]
    objects: list[str]
    domain: Optional[Domain]


class World:
    """The world of some models, with what can be said of its controllers.

    Controllers are called as the classes that make them, and operators that run one class
    share one.
    """

    domain: str
    """The PDDL domain: that of the models, with an operator for each case."""

    def __init__(
        self,
        models: Any,
        texts: Texts,
        max_steps: int = 100,
        refused: Optional[int] = None,
    ) -> None:
        """`refused` is for simulators that leave a state as it is where an action would end
        in a collision: a controller of which more actions than so many change nothing counts
        as failed in training, though it may have done what it promises by the way.
        """
        self.models = models
        self._texts, self._max_steps, self._refused = texts, max_steps, refused
        self._controllers = list(_controllers(models, texts))
        self._actions = {action.name: action for own in self._controllers for action in own.actions}
        self._ranges = {
            action.name: own.domain.ranges if own.domain else ()
            for own in self._controllers
            for action in own.actions
        }
        self.domain = _pddl_domain(models, self._actions.values())
        self._types = _layout_types(models, texts)
        # States by their numbers, the trajectories that led there, and what holds.
        self._states: list[Any] = []
        self._ways: dict[int, tuple[list[Any], list[Any]]] = {}
        self._holding: dict[int, set[tuple[str, ...]]] = {}

    # States

    def _kind(self, thing: Any) -> Optional[str]:
        """The type of an object, or the nearest type above it, that texts speak of."""
        kind = thing.type
        while kind is not None and kind.name not in self._types:
            kind = kind.parent
        return None if kind is None else str(kind.name)

    def _objects(self, state: Any) -> dict[str, list[Any]]:
        """The objects of a state that texts speak of, by their types."""
        objects: dict[str, list[Any]] = {name: [] for name in self._types}
        for thing in sorted(state, key=lambda thing: _numbered(thing.name)):
            kind = self._kind(thing)
            if kind is not None:
                objects[kind].append(thing)
        return objects

    def layout(self, states: Sequence[Any]) -> str:
        """Which numbers of a state belong to which object, for tasks with such states."""
        names = {
            kind: {tuple(thing.name for thing in self._objects(x)[kind]) for x in states}
            for kind in self._types
        }
        single = {kind for kind, own in names.items() if [len(one) for one in own] == [1]}
        groups = {kind for kind, own in names.items() if any(own)} - single
        # Other tasks may have more: groups share what room there is, the state's number aside.
        numbers = MAX_NUMBERS - 1 - sum(len(self._types[kind]) for kind in single)
        objects = MAX_OBJECTS - len(single)
        lines = []
        for kind, attributes in self._types.items():
            listed = ", ".join(f"{name}: {what}" for name, what in attributes.items())
            lines.append(f"type {kind} {{ {listed} }}")
            if kind in single:
                lines.append(f"object {next(iter(names[kind]))[0]}: {kind}")
            elif kind in groups:
                room = min(numbers // max(1, len(attributes)), objects) // len(groups)
                lines.append(f"object all_{kind}[{room}]: {kind}")
        return "\n".join(lines) + "\n"

    def numbers(self, state: Any) -> list[float]:
        """A state as the library has it; the last number says which one it is."""
        self._states.append(state)
        numbers = [
            float(state.get(thing, name))
            for kind, things in self._objects(state).items()
            for thing in things
            for name in self._types[kind]
        ]
        return [*numbers, float(len(self._states) - 1)]

    def problem(self, state: Any) -> str:
        """The PDDL problem of a state."""
        abstract = self.models.state_abstractor(state)
        goal = self.models.goal_deriver(state)
        objects = "\n ".join(
            f"{thing.name} - {thing.type.name}" for thing in sorted(abstract.objects)
        )
        init = "\n ".join(sorted(map(_atom, abstract.atoms)))
        wanted = " ".join(sorted(map(_atom, goal.atoms)))
        return (
            f"(define (problem task) (:domain models)\n(:objects\n {objects})\n"
            f"(:init\n {init})\n(:goal (and {wanted})))\n"
        )

    # Callbacks

    def execute(
        self, ground: Ground, parameters: Sequence[float], numbers: Sequence[float]
    ) -> Optional[tuple[list[float], int]]:
        """Runs the controller of an operator in the simulator of the models."""
        place = int(numbers[-1])
        state = self._states[place]
        way = self.run(ground, parameters, state, numpy.random.default_rng(place))
        if way is None or not way[1]:
            return None
        after = self.numbers(way[0][-1])
        self._ways[int(after[-1])] = way
        return after, len(way[1])

    def practise(
        self, ground: Ground, parameters: Sequence[float], numbers: Sequence[float]
    ) -> Optional[tuple[list[float], int]]:
        """As `execute`, in training."""
        done = self.execute(ground, parameters, numbers)
        if done is None or self._refused is None:
            return done
        states, actions = self._ways[int(done[0][-1])]
        steps = zip(actions, states, states[1:])
        idle = sum(bool(numpy.any(own) and one == next_one) for own, one, next_one in steps)
        return None if idle > self._refused else done

    def run(
        self, ground: Ground, parameters: Sequence[float], state: Any, rng: Any
    ) -> Optional[tuple[list[Any], list[Any]]]:
        """The states and actions of a controller; parameters that are not given are those of
        its own sampler. None if it finds no way."""
        controller = self._grounded(ground, state)
        try:
            own = controller.sample_parameters(state, rng)
            controller.reset(state, _in_form(own, parameters))
            states, actions = [state], []
            for _ in range(self._max_steps):
                if controller.terminated():
                    break
                action = controller.step()
                state = self.models.transition_fn(state, action)
                controller.observe(state)
                states.append(state)
                actions.append(action)
        except BaseException as failure:
            if type(failure).__name__ == "TransitionFailure":
                return states, actions
            if type(failure).__name__ == "TrajectorySamplingFailure":
                return None
            raise
        return states, actions

    def _grounded(self, ground: Ground, state: Any) -> Any:
        known = {thing.name: thing for thing in state}
        known.update((thing.name, thing) for thing in self.models.state_abstractor(state).objects)
        objects = [known[name] for name in ground.objects]
        return self._actions[ground.name].skill.controller.ground(objects)

    def holds(self, ground: Ground, numbers: Sequence[float]) -> bool:
        """Whether an atom holds."""
        place = int(numbers[-1])
        if place not in self._holding:
            atoms = self.models.state_abstractor(self._states[place]).atoms
            self._holding[place] = {_words(atom) for atom in atoms}
        return (ground.name, *ground.objects) in self._holding[place]

    def sample(self, draw: Draw, rng: Rng) -> list[float]:
        """Parameters of the controller's own sampler, within the ranges of the texts."""
        state, ground = self._states[int(draw.state[-1])], draw.skeleton[draw.step]
        lots = numpy.random.default_rng(int(rng.uniform() * 2**53))
        try:
            own = self._grounded(ground, state).sample_parameters(state, lots)
        except BaseException as failure:
            if type(failure).__name__ == "TrajectorySamplingFailure":
                raise NoSample(str(failure)) from None
            raise
        ranges = self._ranges[ground.name]
        values = numpy.atleast_1d(numpy.asarray(own, dtype=float))[: draw.parameter_count]
        if all(low <= value <= high for value, (low, high) in zip(values, ranges)):
            return list(values)
        # It is of another case.
        return [low + rng.uniform() * (high - low) for low, high in ranges]

    # Learning and planning

    def learn(
        self,
        initial: Sequence[Any],
        /,
        progress: Optional[Callable[[Any], None]] = None,
        **options: Any,
    ) -> Skills:
        """Skills, learned from tasks that begin in these states; the options are those of
        `Skills`."""
        skills = self.skills(initial, **options)
        skills.learn(self.practise, self.holds, self.sample, progress)
        return skills

    def skills(self, initial: Sequence[Any], /, **options: Any) -> Skills:
        """Skills of which nothing is known yet."""
        tasks = [(self.problem(state), self.numbers(state)) for state in initial]
        options.setdefault("state_len", MAX_NUMBERS)
        skills = Skills(self.domain, self.layout(initial), tasks, **options)
        for own in self._controllers:
            names = [action.name for action in own.actions]
            ranges = own.domain.ranges if own.domain else ()
            skills.add_controller(own.name, ranges, names, own.objects)
        for key, text in self._texts.items():
            for name, one in _cases(key if isinstance(key, str) else key[0], text):
                if isinstance(key, str):
                    skills.add(name, one)
                else:
                    skills.add_pair(name, key[1], one)
        return skills

    def planner(self, state: Any, **options: Any) -> Planner:
        """A planner for the task of a state."""
        options.setdefault("state_len", len(self.numbers(state)))
        # There is no bound of steps in the framework, but one of each controller.
        options.setdefault("max_actions", MAX_OBJECTS * self._max_steps)
        planner = Planner(self.domain, self.problem(state), **options)
        for action, ranges in self._ranges.items():
            if ranges:
                planner.set_ranges(action, ranges)
        return planner

    def plan(
        self,
        state: Any,
        skills: Optional[Skills] = None,
        seed: int = 0,
        planner: Optional[Planner] = None,
        prune: bool = False,
    ) -> Plan:
        """A plan from a state, by the planner of this package. Raises `NoPlan`."""
        planner = planner or self.planner(state)
        steps = planner.plan(
            self.numbers(state),
            self.execute,
            self.holds,
            self.sample,
            skills=skills,
            prune=prune,
            seed=seed,
        )
        states, actions = [state], []
        for step in steps:
            more, taken = self._ways[int(step.state[-1])]
            states += more[1:]
            actions += taken
        return Plan([step.ground for step in steps], states, actions)


def _cases(name: str, text: Text) -> Iterator[tuple[str, Optional[str]]]:
    """Names and texts of a controller's cases; of itself, if it has none."""
    if isinstance(text, Mapping):
        for case, one in text.items():
            yield f"{name}-{case}", one
    else:
        yield name, text


def _controllers(models: Any, texts: Texts) -> Iterator[_Controller]:
    """The controllers of the models, in the order of their names."""
    groups: dict[str, list[Any]] = {}
    for skill in sorted(models.skills, key=lambda skill: str(skill.operator.name)):
        groups.setdefault(skill.controller.controller_cls.__name__, []).append(skill)
    named = {name for key in texts for name in ([key] if isinstance(key, str) else key)}
    if named - set(groups):
        wrong, known = ", ".join(sorted(named - set(groups))), ", ".join(groups)
        raise ValueError(f"there is no controller {wrong}, but {known}")
    for name, skills in groups.items():
        common = [
            variable.name
            for variable in skills[0].operator.parameters
            if all(variable in skill.operator.parameters for skill in skills)
        ]
        for own, text in _cases(name, texts.get(name)):
            actions = [
                _Action(skill.operator.name + own[len(name) :], skill, own) for skill in skills
            ]
            yield _Controller(own, actions, common, Domain(text) if text else None)


def _layout_types(models: Any, texts: Texts) -> dict[str, dict[str, str]]:
    """The types that texts speak of, with their attributes; a type has those of the types
    above it, too."""
    kinds = {kind.name: kind for kind in _with_parents(models.types)}
    found: dict[str, dict[str, str]] = {}
    for text in texts.values():
        for _, one in _cases("", text):
            for role in Domain(one).objects if one else ():
                name = role.name
                for prefix in ("later_", "other_"):
                    name = name[len(prefix) :] if name.startswith(prefix) else name
                if name not in kinds:
                    name = name.rstrip("0123456789")
                if name not in kinds:
                    raise ValueError(f"object {role.name}: there is no type {name}")
                found.setdefault(name, {}).update(role.attributes)
    for name in found:
        above = kinds[name].parent
        while above is not None:
            found[name] = {**found.get(above.name, {}), **found[name]}
            above = above.parent
    return found


def _with_parents(types: Any) -> list[Any]:
    """The types and all above them, in the order of their names."""
    all_of_them = {}
    for kind in types:
        while kind is not None:
            all_of_them[kind.name] = kind
            kind = kind.parent
    return [all_of_them[name] for name in sorted(all_of_them)]


def _pddl_domain(models: Any, actions: Any) -> str:
    types = "\n ".join(
        f"{kind.name} - {kind.parent.name if kind.parent else 'object'}"
        for kind in _with_parents(models.types)
    )
    predicates = []
    for predicate in sorted(models.predicates, key=lambda own: str(own.name)):
        words = [f"?x{place} - {kind.name}" for place, kind in enumerate(predicate.types)]
        predicates.append(f"({' '.join([predicate.name, *words])})")
    texts = []
    for action in actions:
        own = action.skill.operator
        parameters = " ".join(f"{one.name} - {one.type.name}" for one in own.parameters)
        before = " ".join(sorted(map(_atom, own.preconditions)))
        # What is deleted and added stays.
        gone = sorted(_atom(atom) for atom in own.delete_effects if atom not in own.add_effects)
        after = " ".join(sorted(map(_atom, own.add_effects)) + [f"(not {atom})" for atom in gone])
        texts.append(
            f"(:action {action.name} :parameters ({parameters})\n"
            f"  :precondition (and {before})\n  :effect (and {after}))"
        )
    return (
        f"(define (domain models)\n(:types\n {types})\n(:predicates\n "
        + "\n ".join(predicates)
        + ")\n"
        + "\n".join(texts)
        + ")\n"
    )


def _words(atom: Any) -> tuple[str, ...]:
    return (atom.predicate.name, *(own.name for own in atom.entities))


def _atom(atom: Any) -> str:
    return f"({' '.join(_words(atom))})"


def _numbered(name: str) -> tuple[str, int]:
    """Names in the order of the library: box2 before box10."""
    stem = name.rstrip("0123456789")
    return stem.lower(), int(name[len(stem) :] or -1)


def _in_form(own: Any, given: Sequence[float]) -> Any:
    """Parameters in the form of those that a controller draws itself; the first are given."""
    if isinstance(own, (tuple, list)):
        return type(own)([*map(float, given), *own[len(given) :]])
    if isinstance(own, numpy.ndarray):
        values = own.copy()
        values.flat[: len(given)] = list(given)
        return values
    return float(given[0]) if given else own
