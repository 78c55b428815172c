"""Learners: they ask for samples, are told what came of them, and know a region."""

from __future__ import annotations

import threading
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from ctypes import addressof, byref, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64
from ctypes import c_void_p
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Optional, TypedDict, Union

from ._library import (
    MAKE,
    SIMULATE,
    check,
    checked_id,
    configured,
    encoded,
    filled,
    library,
    made,
    memory,
    out,
    text_of,
)
from ._numbers import matrix, outcome_of, vector
from ._structs import DEFAULT_INSTANCES, MAX_QUESTIONS, Config, Report
from .domain import Domain, as_domain
from .region import Picture, Proof, Quality, Region, proof_of
from .status import NoRegion, Status

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._numbers import Matrix, Vector

FEASIBLE = 1
"""The outcome of a trial that worked, which True is, too."""
INFEASIBLE = 0
"""The outcome of a trial that failed, which False is, too."""
UNKNOWN = 2
"""The outcome of a trial without an answer: it crashed, or took too long."""
ALGORITHM1 = 1
"""For the option `learner`: the learner of the thesis, for comparison."""
VERSION_SPACE = 2
"""For the option `learner`: the sound one, the default."""


class Why(IntEnum):
    """Why there is no region, or none that is exact."""

    EXPLAINED = 0
    NOTHING_TOLD = 1
    NONE_WORKED = 2
    ALL_WORKED = 3
    NO_INFLUENCE = 4
    TOO_FEW = 5
    CONTRADICTION = 6
    UNEXPLAINED = 7


class Options(TypedDict, total=False):
    """What a learner does; critreg_config in critreg.h says more of each."""

    seed: int
    """Of all random choices; the same seed and outcomes give the same region."""
    calls: int
    """Outcomes to ask for in all; 100 unless told."""
    certifying: int
    """How many of them, the last ones, certify the region."""
    steps: int
    """Steps of the sequence of actions that is learned about."""
    noise: float
    """Share of outcomes that is wrong, up to 0.2."""
    slack: float
    """How far the boundary may lie elsewhere in single instances."""
    exploring: float
    """Share of the questions that look for what nothing hints at."""
    confidence: float
    """Of the certificate."""
    precision_wanted: float
    """Which share of the region must work where no region agrees with all outcomes."""
    questions: int
    """Questions that can be open at once."""
    room: int
    """Instances to have room for; critreg_config.instances."""
    observations: int
    """Outcomes to have room for."""
    forms: int
    """Forms to have room for: more reach more complex constraints."""
    sums: int
    """Forms with a sum on the right to have room for."""
    tracked: int
    """Of how many forms is kept what the outcomes say about them."""
    precision: int
    """64 or 32: the bits of the numbers that are computed with."""
    learner: int
    """VERSION_SPACE or ALGORITHM1."""
    negative: Vector
    """ALGORITHM1: parameters that are expected to fail."""
    positive: Vector
    """ALGORITHM1: parameters that are expected to work."""


class Query(NamedTuple):
    """A sample to try."""

    instance: int
    """The index of the instance to try it in."""
    theta: list[float]
    """The parameters to try."""


class Question(NamedTuple):
    """A sample to try, of several that are open."""

    id: int
    """By which `tell_id` knows it."""
    instance: int
    """The index of the instance to try it in."""
    theta: list[float]
    """The parameters to try."""


Simulate = Callable[[list[float], list[float]], Any]
"""Tries parameters in an instance: True if the action worked, or another outcome."""


# For a learner that is finished: it asks nothing.
_never = SIMULATE(lambda *_: int(Status.CANCELLED))


class Learner:
    """Learns with which parameters an action works.

        learner = Learner(DOMAIN, instances, seed=7, calls=200)
        region = learner.learn(try_grasp, workers=4)

    `instances` has a row for each scene to learn in, with a number for each attribute of
    every object; the members that a group does not have are NaN. The options are those of
    `Options`. What fails raises `Error` and leaves the learner usable. Its methods may be
    called from several threads; they wait for each other.
    """

    def __init__(
        self, domain: Union[Domain, str], instances: Matrix, **options: Unpack[Options]
    ) -> None:
        self.domain: Domain = as_domain(domain)
        self._instances, self._count = matrix(instances, self.domain.instance_len, "instances")
        config = made(Config, library.critreg_config_init)
        given: dict[str, Any] = dict(options)
        given["instances"] = given.pop("room", max(DEFAULT_INSTANCES, self._count))
        given.setdefault("questions", MAX_QUESTIONS)
        # The library copies them.
        kept = [
            (name, vector(given.pop(name), len(self.domain.parameters), name))
            for name in ("negative", "positive")
            if name in given
        ]
        configured(config, given)
        for name, sample in kept:
            setattr(config, name, addressof(sample))
        size = library.critreg_learner_size(byref(config))
        self._memory = memory(size)  # The handle lies at its start.
        self._handle = c_void_p()
        self._lock = threading.RLock()
        check(
            library.critreg_learner_init(
                self._memory, size, encoded(self.domain.text), byref(config), byref(self._handle)
            )
        )

    def _checked(self, status: int) -> None:
        if status in (Status.BUSY, Status.NOT_A_HANDLE):
            check(status)  # These leave no words.
        elif status != Status.OK:
            check(status, text_of(library.critreg_learner_message, self._handle))

    def _call(self, function: Callable[..., int], *arguments: Any) -> None:
        """A function that needs the learner for itself, and the instances."""
        with self._lock:
            self._checked(function(self._handle, self._instances, self._count, *arguments))

    @property
    def instances(self) -> list[list[float]]:
        """The instances that are learned in, one a row."""
        width, flat = self.domain.instance_len, list(self._instances)
        return [flat[i * width : (i + 1) * width] for i in range(self._count)]

    def add_instances(self, more: Matrix) -> None:
        """Learns in more instances from now on, as far as there is room (option `room`)."""
        added, count = matrix(more, self.domain.instance_len, "instances")
        with self._lock:
            self._instances = (c_double * (len(self._instances) + len(added)))(
                *self._instances, *added
            )
            self._count += count

    def choose_instances(
        self, make: Callable[[int], Vector], offered: int, room: int = DEFAULT_INSTANCES
    ) -> None:
        """Learns in instances of a source instead: `make(number)` makes any of so many. Those
        that differ most are chosen, as many as there is room for (option `room`, too); before
        anything is asked or told.
        """
        width = self.domain.instance_len
        raised: list[BaseException] = []

        def write(_: Any, number: int, instance: Any) -> int:
            try:
                values = vector(make(number), width, "an instance")
                for place in range(width):
                    instance[place] = values[place]
            except BaseException as error:  # It is raised again below.
                raised.append(error)
                return Status.CANCELLED
            return Status.OK

        chosen, count = (c_double * (checked_id(room, "room") * width))(), c_size_t()
        with self._lock:
            status = library.critreg_choose_instances(
                self._handle,
                checked_id(offered, "offered"),
                MAKE(write),
                None,
                chosen,
                room,
                byref(count),
            )
            if raised:
                raise raised[0]
            self._checked(status)
            self._count = count.value
            self._instances = (c_double * (self._count * width))(*chosen[: self._count * width])

    # Asking and telling

    def ask(self) -> Query:
        """The sample to try next; the same one until it is told."""
        instance, theta = c_size_t(), (c_double * len(self.domain.parameters))()
        self._call(library.critreg_ask, byref(instance), theta)
        return Query(instance.value, list(theta))

    def tell(self, outcome: Any) -> None:
        """What came of the sample that was asked for: a bool, UNKNOWN, or -k if step k failed."""
        self._call(library.critreg_tell, outcome_of(outcome))

    def ask_many(self, wanted: int) -> list[Question]:
        """Up to so many samples to try at once. Fewer, or none, if no more are worth asking."""
        with self._lock:
            return self._questions(
                wanted,
                lambda *arrays: library.critreg_ask_many(
                    self._handle, self._instances, self._count, *arrays
                ),
            )

    def open_questions(self) -> list[Question]:
        """The questions that were asked and not told, also of a run that was resumed."""
        with self._lock:
            return self._questions(
                MAX_QUESTIONS,
                lambda *arrays: library.critreg_open_questions(self._handle, *arrays),
            )

    def _questions(self, wanted: int, give: Callable[..., int]) -> list[Question]:
        wanted = min(checked_id(wanted, "wanted"), MAX_QUESTIONS)
        width, given = len(self.domain.parameters), c_size_t()
        ids, numbers = (c_uint64 * wanted)(), (c_size_t * wanted)()
        thetas = (c_double * (wanted * width))()
        self._checked(give(wanted, ids, numbers, thetas, byref(given)))
        return [
            Question(ids[i], numbers[i], thetas[i * width : (i + 1) * width])
            for i in range(given.value)
        ]

    def tell_id(self, id: int, outcome: Any) -> None:
        """What came of a question of `ask_many`, in any order."""
        self._call(library.critreg_tell_id, checked_id(id, "id"), outcome_of(outcome))

    def forget(self, id: int) -> None:
        """Waits no longer for the answer to a question."""
        with self._lock:
            self._checked(library.critreg_forget(self._handle, checked_id(id, "id")))

    def observe(self, instance: int, theta: Vector, outcome: Any) -> None:
        """What came of a sample that was not asked for: of a log, or a demonstration."""
        sample = vector(theta, len(self.domain.parameters), "theta")
        told = outcome_of(outcome)
        self._call(library.critreg_observe, checked_id(instance, "instance"), sample, told)

    def conclude(self) -> None:
        """Brings the region up to date with everything that was told."""
        self._call(library.critreg_conclude)

    @property
    def is_finished(self) -> bool:
        """Whether there is nothing more to ask."""
        with self._lock:
            return bool(out(c_int32, library.critreg_is_finished, self._handle))

    # Learning with a simulator

    def learn(
        self,
        simulate: Simulate,
        workers: int = 1,
        progress: Optional[Callable[[Report], None]] = None,
    ) -> Region:
        """Tries samples until there is nothing more to ask, and returns the region.

        `simulate(instance, theta)` tells whether the action worked, or gives another
        outcome. With several workers it is called in as many threads at once, so it must
        allow for that; it gains where it waits for another process or leaves the
        interpreter. With one worker it is called in this thread, and the same seed gives
        the same region; with more that depends on who answers first.

        `progress` is called with the report after each outcome. What it or `simulate`
        raises ends learning, after the trials under way; `learn` goes on where it was.

        Raises `NoRegion` with the reason if nothing was learned.
        """
        if workers < 1:
            raise ValueError(f"workers is {workers}: at least one")
        instances = self.instances

        def tried(question: Question) -> Any:
            return simulate(list(instances[question.instance]), list(question.theta))

        def told(question: Question, outcome: Any) -> None:
            self.tell_id(question.id, outcome)
            if progress is not None:
                progress(self.report())

        left = self.open_questions()
        if workers == 1:
            while left or (left := self.ask_many(1)):
                told(left[0], tried(left[0]))
                left = left[1:]
        else:
            with ThreadPoolExecutor(workers) as pool:
                self._share(pool, workers, left, tried, told)
        return self._learned()

    def _share(
        self,
        pool: ThreadPoolExecutor,
        workers: int,
        left: list[Question],
        tried: Callable[[Question], Any],
        told: Callable[[Question, Any], None],
    ) -> None:
        """Keeps all workers busy. After an error the answers under way are still told."""
        running: dict[Future[Any], Question] = {}
        failure: Optional[BaseException] = None
        while True:
            if failure is None:
                idle = workers - len(running)
                fresh, left = left[:idle], left[idle:]
                fresh += self.ask_many(idle - len(fresh)) if not left else []
                running.update((pool.submit(tried, question), question) for question in fresh)
            if not running:
                break
            done, _ = wait(running, return_when=FIRST_COMPLETED)
            # In the order in which they were asked.
            for future in sorted(done, key=lambda each: running[each].id):
                question = running.pop(future)
                try:
                    told(question, future.result())
                except BaseException as raised:
                    failure = failure or raised
        if failure is not None:
            raise failure

    def _learned(self) -> Region:
        region = c_void_p()
        with self._lock:
            status = library.critreg_learn_region(
                self._handle, self._instances, self._count, _never, None, byref(region)
            )
            if status == Status.NO_REGION:
                raise NoRegion(self.why()[1])
            self._checked(status)
            return Region._copied(region)

    # What was learned

    def region(self) -> Optional[Region]:
        """A copy of what is learned so far, of whatever quality; None if nothing is."""
        region = c_void_p()
        with self._lock:
            status = library.critreg_learner_region(self._handle, byref(region))
            if status == Status.NO_REGION:
                return None
            self._checked(status)
            return Region._copied(region)

    def challenge(
        self,
        specification: Region,
        ranges: Matrix,
        max_boxes: Optional[int] = None,
        tolerance: Optional[float] = None,
    ) -> Proof:
        """Whether what is learned satisfies a specification, as `Region.implies`. If not, the
        counterexample is what to try next: append its instance, and observe what comes of it."""
        with self._lock:
            return proof_of(
                library.critreg_learner_challenge,
                self._handle,
                specification,
                ranges,
                max_boxes,
                tolerance,
                self._checked,
            )

    def quality(self) -> Quality:
        """How good the region is."""
        return Quality(self.report().quality)

    def why(self) -> tuple[Why, str]:
        """Why there is no region, or none that is exact: a code, and a sentence."""
        with self._lock:
            code = c_uint32()
            text = text_of(library.critreg_learner_why, self._handle, byref(code))
            return Why(code.value), text

    def report(self) -> Report:
        """How learning went so far, in numbers."""
        report = made(Report, library.critreg_report_init)
        with self._lock:
            check(library.critreg_learner_report(self._handle, byref(report)))
        return report

    def picture(self, instance: int) -> Picture:
        """What is learned and was told so far of an instance, as a picture."""
        index = checked_id(instance, "instance")
        with self._lock:
            svg = filled(
                library.critreg_learner_to_svg,
                self._handle,
                self._instances,
                self._count,
                index,
                checked=self._checked,
            )
        return Picture(svg.rstrip(b"\0").decode())

    # Stopping and going on

    def save(self) -> bytes:
        """What was told and asked, for `resume`."""
        with self._lock:
            return filled(
                library.critreg_learner_save,
                self._handle,
                self._instances,
                self._count,
                checked=self._checked,
            )

    def resume(self, data: bytes) -> None:
        """Brings a fresh learner, of the same domain and options, to where `save` was called."""
        self._call(library.critreg_learner_resume, c_char_p(data), len(data))

    def journal(self, start: int = 0) -> bytes:
        """Records of the outcomes from this one on, to be appended to a file as they come."""
        with self._lock:
            return filled(
                library.critreg_learner_journal,
                self._handle,
                self._instances,
                self._count,
                checked_id(start, "start"),
                checked=self._checked,
            )

    def resume_journal(self, data: bytes) -> int:
        """Brings a fresh learner to the end of a journal.

        Returns how many bytes of it stand: what is behind was torn, and is to be cut off
        before anything is appended.
        """
        stands = c_size_t()
        self._call(
            library.critreg_learner_resume_journal, c_char_p(data), len(data), byref(stands)
        )
        return stands.value
