"""A planner: PDDL operators with continuous parameters, refined in the program's simulator."""

from __future__ import annotations

from ctypes import byref, c_double, c_size_t, c_uint32, c_void_p
from enum import IntEnum
from typing import TYPE_CHECKING, NamedTuple, Optional, TypedDict

from ._library import (
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
from ._structs import MAX_PARAMETERS, Metrics, PlannerConfig, StepStruct
from .status import NoPlan, Status
from .world import Advise, Execute, Ground, Holds, Sample, World, ground_of

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._numbers import Matrix, Vector
    from .skills import Skills


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
    lookahead: int
    """With skills: draws that are followed in what is expected of the steps after them."""
    nodes: int
    """Nodes of the search to have room for."""


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
        skills: Optional[Skills] = None,
        prune: bool = False,
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
        - `skills`: what was learned. Parameters are drawn from where the step and those
          after it are expected to work, and what cannot work is postponed; or dropped, with
          `prune`. `sample` is then asked where nothing is known. The parameters of actions
          are those of their controllers.

        What they raise ends planning and is raised here. Raises `NoPlan` with the reason
        if there is none.
        """
        state = vector(initial, self._state_len, "initial")
        counts = self._counts if skills is None else {**self._counts, **skills.counts}
        world, length = World(counts, execute, holds, sample, advise), c_size_t()
        if skills is not None:
            world.callbacks.skills, world.callbacks.prune = skills.handle, prune
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
        return Step(ground_of(step.ground), parameters, list(state), step.actions)

    def why(self) -> str:
        """Why the last `plan` found none, and what to change first; empty if it did."""
        code = c_uint32()
        return text_of(library.critreg_planner_why, self._handle, byref(code))

    def reason(self) -> str:
        """What stood in the way most often in the last `plan`, in the words of its skills."""
        return text_of(library.critreg_planner_reason_text, self._handle)

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
