"""The program's world: what a planner, or skills, ask of it by callbacks."""

from __future__ import annotations

import ctypes
from ctypes import c_double, c_void_p
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Callable, Mapping, NamedTuple, Optional, Union

from ._library import ADVISE, EXECUTE, HOLDS, SAMPLE, checked_id, library, made
from ._numbers import vector
from ._structs import NO_REASON, CallbacksStruct, DrawnStruct, DrawStruct, GroundStruct
from .region import Rng
from .status import EmptyRegion, NoSample, Status

if TYPE_CHECKING:
    from ._numbers import Vector


class Advice(IntEnum):
    """What to do with a sequence of operators."""

    KEEP = 0
    """Go on with it."""
    POSTPONE = 1
    """Leave it out until patience is at its end: for what may be wrong."""
    PRUNE = 2
    """Drop it: for what is certain."""


class Ground(NamedTuple):
    """A ground atom or operator: a predicate or a PDDL action, with its objects."""

    name: str
    objects: tuple[str, ...]

    def __str__(self) -> str:
        return f"({' '.join([self.name, *self.objects])})"


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


def ground_of(raw: GroundStruct) -> Ground:
    objects = tuple(raw.object_names[i].decode() for i in range(raw.object_count))
    return Ground(raw.name.decode(), objects)


def _grounds(address: Optional[int], count: int) -> list[Ground]:
    if not address:
        return []
    return [ground_of(raw) for raw in (GroundStruct * count).from_address(address)]


class World:
    """The callbacks for one planning or learning, and what one of them raised."""

    def __init__(
        self,
        counts: Mapping[str, int],
        execute: Execute,
        holds: Holds,
        sample: Optional[Sample] = None,
        advise: Optional[Advise] = None,
    ) -> None:
        """`counts` tells how many parameters actions have, by their names in small letters."""
        self.raised: Optional[BaseException] = None
        self._counts = counts
        self._user = execute, holds, sample, advise
        callbacks = made(CallbacksStruct, library.critreg_callbacks_init)
        wanted: dict[str, Any] = {"execute": (EXECUTE, self._execute), "holds": (HOLDS, self._holds)}
        if sample is not None:
            wanted["sample"] = SAMPLE, self._sample
        if advise is not None:
            wanted["advise"] = ADVISE, self._advise
        # They must live as long as they can be called.
        self._functions = {name: kind(self.kept(body)) for name, (kind, body) in wanted.items()}
        for name, function in self._functions.items():
            setattr(callbacks, name, ctypes.cast(function, c_void_p))
        self.callbacks = callbacks

    def kept(self, body: Callable[..., int]) -> Callable[..., int]:
        """What a callback raises waits until the library returns."""

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
