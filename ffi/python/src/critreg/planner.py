"""A planner: PDDL operators with continuous parameters, refined in the program's simulator."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_double, c_size_t, c_uint32, c_void_p
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Optional, Sequence, TypedDict, Union

from ._library import (
    ADVISE,
    EXECUTE,
    HOLDS,
    SAMPLE,
    check,
    checked_id,
    complaint,
    configured,
    encoded,
    library,
    made,
    memory,
    out,
    text_of,
)
from ._numbers import matrix, vector
from ._structs import (
    MAX_PARAMETERS,
    NO_REASON,
    CallbacksStruct,
    DrawnStruct,
    DrawStruct,
    GroundStruct,
    Metrics,
    PlannerConfig,
    StepStruct,
)
from .region import Rng
from .status import EmptyRegion, NoPlan, NoSample, Status

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._numbers import Matrix, Vector


class Advice(IntEnum):
    """What to do with a sequence of operators."""

    KEEP = 0
    """Go on with it."""
    POSTPONE = 1
    """Leave it out until patience is at its end: for what may be wrong."""
    PRUNE = 2
    """Drop it: for what is certain."""


class Heuristic(IntEnum):
    """What guides the search."""

    LM_CUT = 1
    H_MAX = 2
    H_ADD = 3
    BLIND = 4


class PlannerOptions(TypedDict, total=False):
    """How to plan; critreg_planner_config in critreg.h says more of each."""

    heuristic: int
    """One of `Heuristic`."""
    max_skeletons: int
    """Most plan skeletons to refine."""
    max_tries: int
    """Tries of a step before an earlier one is tried again."""
    max_length: int
    """Most operators in a plan."""
    max_actions: int
    """Most low-level actions in a plan."""
    max_samples: int
    """Most tries in all."""
    patience: int
    """How much advice may cost before planning begins anew without it."""
    skeletons_per_state: int
    """Sequences to one abstract state that are extended before all others are."""
    nodes: int
    """Nodes of the search to have room for."""


class Ground(NamedTuple):
    """A ground atom or operator: a predicate or a PDDL action, with its objects."""

    name: str
    objects: tuple[str, ...]

    def __str__(self) -> str:
        return f"({' '.join([self.name, *self.objects])})"


class Step(NamedTuple):
    """A step of a plan."""

    ground: Ground
    """The operator."""
    parameters: list[float]
    """Its parameters."""
    state: list[float]
    """The state afterwards."""
    actions: int
    """How many low-level actions it takes."""


class Draw(NamedTuple):
    """A step whose parameters are to be drawn."""

    skeleton: list[Ground]
    """The operators of the whole plan skeleton."""
    step: int
    """The step to draw for, from 0."""
    state: list[float]
    """The state before it."""
    parameter_count: int
    """How many parameters are to be drawn; may be 0."""
    attempt: int
    """Which try of the step in this state it is, from 1."""
    advised: bool
    """False once patience is at its end: then draw as if nothing were known."""


class Drawn(NamedTuple):
    """Parameters that were drawn."""

    parameters: Vector
    informed: bool = True
    """Whether they are from where they are expected to work, such as a learned region."""


Execute = Callable[[Ground, list[float], list[float]], Union[None, "Vector", tuple["Vector", int]]]
Holds = Callable[[Ground, list[float]], bool]
Sample = Callable[[Draw, Rng], Union["Vector", Drawn]]
Advise = Callable[[list[Ground], list[float]], Union[Advice, tuple[Advice, int]]]


def _ground(raw: GroundStruct) -> Ground:
    objects = tuple(raw.object_names[i].decode() for i in range(raw.object_count))
    return Ground(raw.name.decode(), objects)


def _grounds(address: Optional[int], count: int) -> list[Ground]:
    if not address:
        return []
    return [_ground(raw) for raw in (GroundStruct * count).from_address(address)]


class _World:
    """The callbacks for one planning, and what one of them raised."""

    def __init__(
        self,
        planner: Planner,
        execute: Execute,
        holds: Holds,
        sample: Optional[Sample],
        advise: Optional[Advise],
    ) -> None:
        self.raised: Optional[BaseException] = None
        self._state_len = planner._state_len
        self._counts = planner._counts
        self._user = execute, holds, sample, advise
        callbacks = made(CallbacksStruct, library.critreg_callbacks_init)
        wanted: dict[str, Any] = {"execute": (EXECUTE, self._execute), "holds": (HOLDS, self._holds)}
        if sample is not None:
            wanted["sample"] = SAMPLE, self._sample
        if advise is not None:
            wanted["advise"] = ADVISE, self._advise
        # They must live as long as they can be called.
        self._functions = {name: kind(self._kept(body)) for name, (kind, body) in wanted.items()}
        for name, function in self._functions.items():
            setattr(callbacks, name, ctypes.cast(function, c_void_p))
        self.callbacks = callbacks

    def _kept(self, body: Callable[..., int]) -> Callable[..., int]:
        """What a callback raises waits until planning has ended."""

        def guarded(_: Any, *arguments: Any) -> int:
            try:
                return int(body(*arguments))
            except BaseException as raised:
                self.raised = raised
                return int(Status.USER_STATUS)

        return guarded

    def _execute(
        self, ground: int, parameters: Any, before: Any, after: Any, length: int, actions: Any
    ) -> int:
        operator = _grounds(ground, 1)[0]
        own = parameters[: self._counts.get(operator.name.lower(), 0)]
        answer: Any = self._user[0](operator, own, before[:length])
        if answer is None:
            return 0  # It failed.
        pair = isinstance(answer, tuple) and len(answer) == 2 and hasattr(answer[0], "__len__")
        state, taken = answer if pair else (answer, 1)
        numbers = vector(state, length, f"the state after {operator}")
        ctypes.memmove(after, numbers, ctypes.sizeof(numbers))
        actions[0] = checked_id(taken, "actions", 32)
        return 0

    def _holds(self, ground: int, state: Any, length: int, holds: Any) -> int:
        holds[0] = bool(self._user[1](_grounds(ground, 1)[0], state[:length]))
        return 0

    def _sample(self, draw: int, state: Any, drawn: int) -> int:
        raw, into = DrawStruct.from_address(draw), DrawnStruct.from_address(drawn)
        place = (c_double * raw.state_len).from_address(raw.state)
        asked = Draw(
            _grounds(raw.skeleton, raw.length),
            raw.step,
            list(place),
            raw.parameter_count,
            raw.attempt,
            bool(raw.advised),
        )
        assert self._user[2] is not None
        try:
            answer = self._user[2](asked, Rng._borrowed(state.contents))
        except (EmptyRegion, NoSample) as none:
            if none.reason is not None:
                into.reason = checked_id(none.reason, "reason", 32)
            return int(none.status)
        found = answer if isinstance(answer, Drawn) else Drawn(answer, informed=False)
        for index, number in enumerate(vector(found.parameters, raw.parameter_count, "parameters")):
            into.parameters[index] = number
        into.informed = found.informed
        return 0

    def _advise(
        self, prefix: int, length: int, initial: Any, state_len: int, advice: Any, reason: Any
    ) -> int:
        assert self._user[3] is not None
        answer = self._user[3](_grounds(prefix, length), initial[:state_len])
        what, why = answer if isinstance(answer, tuple) else (answer, NO_REASON)
        advice[0], reason[0] = Advice(what), checked_id(why, "reason", 32)
        return 0


class Planner:
    """Plans for a PDDL problem whose actions may have continuous parameters.

        planner = Planner(PDDL_DOMAIN, PDDL_PROBLEM, state_len=2)
        planner.set_ranges("Drive", [(-4.0, 4.0)])
        steps = planner.plan([0.0, 0.0], execute, holds, seed=1)

    A state is `state_len` numbers of the program's own. Texts that are wrong raise `Error`
    with line and column. The memory is as large as the texts need. A planner belongs to one
    thread at a time.
    """

    def __init__(
        self, domain: str, problem: str, state_len: int, **options: Unpack[PlannerOptions]
    ) -> None:
        texts = encoded(domain), encoded(problem)
        check(*complaint(library.critreg_check_pddl, *texts))
        config = made(PlannerConfig, library.critreg_planner_config_init)
        check(library.critreg_planner_measure(*texts, byref(config)))
        configured(config, {"state_len": state_len, **options})
        size = library.critreg_planner_size(byref(config))
        self._memory = memory(size)  # The handle lies at its start.
        self._handle = c_void_p()
        self._state_len = state_len
        self._counts: dict[str, int] = {}  # Parameters of actions, by their names.
        check(
            library.critreg_planner_init(
                self._memory, size, *texts, byref(config), byref(self._handle)
            )
        )

    def _checked(self, status: int) -> None:
        if status in (Status.BUSY, Status.NOT_A_HANDLE):
            check(status)  # These leave no words.
        elif status != Status.OK:
            check(status, text_of(library.critreg_planner_message, self._handle))

    def set_ranges(self, action: str, ranges: Matrix) -> None:
        """The continuous parameters of a PDDL action: least and greatest value of each."""
        ends, count = matrix(ranges, 2, "ranges")
        self._checked(
            library.critreg_planner_set_ranges(self._handle, encoded(action), ends, count)
        )
        self._counts[action.lower()] = min(count, MAX_PARAMETERS)

    def plan(
        self,
        initial: Vector,
        execute: Execute,
        holds: Holds,
        sample: Optional[Sample] = None,
        advise: Optional[Advise] = None,
        seed: int = 0,
    ) -> list[Step]:
        """Plans from a state: first which operators, then with which parameters.

        - `execute(ground, parameters, state)` runs an operator: the state afterwards, or
          that and how many low-level actions it took, or None if it failed.
        - `holds(ground, state)`: whether an atom holds.
        - `sample(draw, rng)` draws parameters, such as `Drawn(region.sample(..., rng))`.
          What that raises may pass: `EmptyRegion` has an earlier step tried again,
          `NoSample` is a failed try. Without it draws are uniform over the ranges.
        - `advise(prefix, initial)`: an `Advice`, or that and the number of a reason.

        What they raise ends planning and is raised here. Raises `NoPlan` with the reason
        if there is none.
        """
        state = vector(initial, self._state_len, "initial")
        world, length = _World(self, execute, holds, sample, advise), c_size_t()
        status = library.critreg_plan(
            self._handle,
            byref(world.callbacks),
            state,
            checked_id(seed, "seed"),
            None,
            byref(length),
        )
        if world.raised is not None:
            raise world.raised
        if status == Status.NO_PLAN:
            raise NoPlan(self.why() or text_of(library.critreg_planner_message, self._handle))
        self._checked(status)
        return [self._step(index) for index in range(length.value)]

    def _step(self, index: int) -> Step:
        step = made(StepStruct, library.critreg_step_init)
        self._checked(library.critreg_planner_step(self._handle, index, byref(step)))
        state = (c_double * self._state_len).from_address(step.state)
        parameters = step.parameters[: step.parameter_count]
        return Step(_ground(step.ground), parameters, list(state), step.actions)

    def why(self) -> str:
        """Why the last `plan` found none, and what to change first; empty if it did."""
        code = c_uint32()
        return text_of(library.critreg_planner_why, self._handle, byref(code))

    def metrics(self) -> Metrics:
        """What the last `plan` cost, however it ended."""
        metrics = made(Metrics, library.critreg_metrics_init)
        check(library.critreg_planner_metrics(self._handle, byref(metrics)))
        return metrics

    def failures(self, action: str) -> int:
        """How often steps of a PDDL action failed in the last `plan`."""
        name = encoded(action)
        return int(out(c_uint32, library.critreg_planner_failures, self._handle, name))

    def reasons(self, reason: int) -> int:
        """How often a reason was given in the last `plan`."""
        number = checked_id(reason, "reason", 32)
        return int(out(c_uint32, library.critreg_planner_reasons, self._handle, number))
