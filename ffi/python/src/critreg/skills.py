"""Skills: what a planner is to know of its controllers, learned by trying them."""

from __future__ import annotations

import ctypes
from ctypes import addressof, byref, c_char_p, c_void_p
from typing import TYPE_CHECKING, Any, Callable, Iterator, Optional, Sequence, TypedDict

from ._library import (
    TRAINING,
    check,
    complaint,
    configured,
    encoded,
    filled,
    library,
    made,
    memory,
    text_of,
)
from ._numbers import matrix, vector
from ._structs import Config, SkillReport, SkillsConfig, Training
from .learner import Options
from .region import Quality, Region
from .status import Status
from .world import Execute, Holds, Sample, World

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._numbers import Matrix, Vector

Task = tuple[str, "Vector"]
"""A training task: a PDDL problem, whose goal does not matter, and the state it begins in."""


class SkillsOptions(TypedDict, total=False):
    """How much is tried; critreg_skills_config in critreg.h says more of each."""

    learner: Options
    """What the learner of a skill is told, such as its seed and how many calls it has."""
    chained: int
    """Questions about two controllers."""
    budget: int
    """Controllers that may be run for one about which there is a single skill."""
    situations: int
    """Situations that a skill with parameters is tried in."""
    states: int
    """Situations that a skill without parameters is tried in, each once."""
    situation_tasks: int
    """Training tasks that the situations of one skill are taken from."""
    state_len: int
    """Most numbers of a state; those of the training tasks unless told."""
    controllers: int
    """Controllers to have room for."""
    skills: int
    """Skills to have room for."""
    texts: int
    """Bytes of texts to have room for, beside the problems of the training tasks."""
    nodes: int
    """Nodes of the search for a way to a situation."""
    facts: int
    """Atoms of :init of a problem to have room for."""
    way: int
    """Controllers that may be run on the way to one situation."""
    runs: int
    """Runs of controllers to keep of the skill that is being learned."""


class Skill:
    """One of the skills: a controller, or one and a later one, and what was learned of it."""

    def __init__(self, skills: Skills, index: int, controller: str, later: Optional[str]) -> None:
        self._skills, self._index = skills, index
        self.controller = controller
        """The name of its controller."""
        self.later = later
        """The name of the later controller, of a pair."""

    @property
    def name(self) -> str:
        """Its controllers, such as "Pick, then Place"."""
        return self.controller if self.later is None else f"{self.controller}, then {self.later}"

    @property
    def domain(self) -> str:
        """Its domain text: as it was added, or as it was made of those of its members."""
        return self._skills._text(library.critreg_skills_domain, self._index)

    @property
    def text(self) -> str:
        """Its region as text; or, if it has none, why."""
        return self._skills._text(library.critreg_skills_format, self._index)

    @property
    def report(self) -> SkillReport:
        """What it took to learn it."""
        report = made(SkillReport, library.critreg_skill_report_init)
        self._skills._checked(
            library.critreg_skills_report(self._skills.handle, self._index, byref(report))
        )
        return report

    @property
    def region(self) -> Optional[Region]:
        """Its region, if it has one."""
        report = self.report
        if not report.has_region:
            return None
        region = Region(self.domain, self.text)
        region.quality = Quality(report.quality)
        return region

    def __repr__(self) -> str:
        return f"<Skill {self.name}: {self.text}>"


class Skills:
    """What is to be known of a program's controllers, for a planner.

        skills = Skills(PDDL_DOMAIN, LAYOUT, tasks)
        skills.add_controller("Pick", [(0.0, 0.4)], objects=["?box"])
        skills.add("Pick", PICK)
        skills.add_pair("Pick", "Place")
        skills.learn(execute, holds)
        planner.plan(state, execute, holds, skills=skills)

    `layout` is a domain text that says which numbers of a state belong to which object;
    critreg.h has a chapter on it, and on how the objects of a skill's text are filled by
    their names. `tasks` are the training tasks: several dozens, with different numbers of
    objects. The memory is as large as the options and the tasks need. It is a sequence of
    `Skill`, in the order in which they were added. They belong to one thread at a time.
    """

    def __init__(
        self, domain: str, layout: str, tasks: Sequence[Task], **options: Unpack[SkillsOptions]
    ) -> None:
        texts = encoded(domain), encoded(layout)
        check(*complaint(library.critreg_check_domain, texts[1]))
        given: dict[str, Any] = dict(options)
        config = made(SkillsConfig, library.critreg_skills_config_init)
        # The library copies what the learner is told.
        learner = made(Config, library.critreg_config_init)
        learner_options: dict[str, Any] = given.pop("learner", {})
        configured(learner, learner_options)
        config.learner = addressof(learner)
        problems = sum(len(encoded(problem)) + 1 for problem, _ in tasks)
        given.setdefault("state_len", max((len(state) for _, state in tasks), default=0))
        given["texts"] = given.get("texts", config.texts) + problems
        configured(config, {**given, "tasks": len(tasks)})
        self.counts: dict[str, int] = {}
        """How many parameters actions have, by their names in small letters."""
        self._skills: list[Skill] = []
        self._progress: Optional[Callable[[Training], None]] = None
        self._world: Optional[World] = None
        self._told = TRAINING(self._tell)  # It must live as long as it can be called.
        config.progress = ctypes.cast(self._told, c_void_p)
        size = library.critreg_skills_size(byref(config))
        self._memory = memory(size)  # The handle lies at its start.
        self.handle: c_void_p = c_void_p()
        """For the library."""
        check(
            library.critreg_skills_init(
                self._memory, size, *texts, byref(config), byref(self.handle)
            )
        )
        for index, (problem, state) in enumerate(tasks):
            numbers = vector(state, len(state), f"the state of tasks[{index}]")
            self._checked(
                library.critreg_skills_add_task(
                    self.handle, encoded(problem), numbers, len(numbers)
                )
            )

    def _checked(self, status: int) -> None:
        if status in (Status.BUSY, Status.NOT_A_HANDLE):
            check(status)  # These leave no words.
        elif status != Status.OK:
            check(status, text_of(library.critreg_skills_message, self.handle))

    def _text(self, function: Callable[..., int], index: int) -> str:
        def checked(status: int) -> None:
            # Then the text says why there is no region.
            if status != Status.NO_REGION:
                self._checked(status)

        return filled(function, self.handle, index, checked=checked).rstrip(b"\0").decode()

    def add_controller(
        self,
        name: str,
        ranges: Matrix = (),
        actions: Sequence[str] = (),
        objects: Sequence[str] = (),
    ) -> None:
        """Adds a controller, with the least and the greatest value of each parameter.

        `actions` are the PDDL actions that it belongs to: that of its name unless told.
        `objects` are those variables of them that it is about: all unless told. Actions that
        no controller names are controllers of their own, without parameters.
        """
        ends, count = matrix(ranges, 2, "ranges")
        self._checked(
            library.critreg_skills_add_controller(
                self.handle, encoded(name), _words(actions), _words(objects), ends, count
            )
        )
        self.counts.update((action.lower(), count) for action in actions or [name])

    def add(self, controller: str, text: Optional[str] = None, members: Sequence[str] = ()) -> None:
        """Adds a skill of a controller, and what can be said of it: a domain text whose
        objects are roles. Without parameters it asks in which states the controller works.
        Without a text the controller is described by its objects.

        Objects are members of groups only if all predicates in `members` that are about their
        type hold of them.
        """
        self._add(controller, None, text, members)

    def add_pair(
        self,
        controller: str,
        later: str,
        text: Optional[str] = None,
        members: Sequence[str] = (),
    ) -> None:
        """Adds a skill of two controllers, of which one runs later: with which parameters of
        the first the later one works, too. Without a text it follows from those of the two.
        """
        self._add(controller, later, text, members)

    def _add(
        self, controller: str, later: Optional[str], text: Optional[str], members: Sequence[str]
    ) -> None:
        if text is not None:
            check(*complaint(library.critreg_check_domain, encoded(text)))
        named = [None if word is None else encoded(word) for word in (later, text)]
        self._checked(
            library.critreg_skills_add(
                self.handle, encoded(controller), named[0], _words(members), named[1]
            )
        )
        self._skills.append(Skill(self, len(self._skills), controller, later))

    def learn(
        self,
        execute: Execute,
        holds: Holds,
        sample: Optional[Sample] = None,
        progress: Optional[Callable[[Training], None]] = None,
    ) -> None:
        """Learns all skills by trying operators in the program's simulator.

        `execute` and `holds` are those of `Planner.plan`; `sample` proposes where to look for
        parameters that work. `progress` is called after each run of a controller. What they
        raise ends learning; `learn` goes on where it was. That a skill has no region is no
        error: its `text` tells why.
        """
        self._progress = progress
        self._world = world = World(self.counts, execute, holds, sample)
        try:
            status = library.critreg_skills_learn(self.handle, byref(world.callbacks), None)
        finally:
            self._progress = self._world = None
        if world.raised is not None:
            raise world.raised
        self._checked(status)

    def _tell(self, _: Any, training: int) -> int:
        if self._progress is None or self._world is None:
            return 0
        progress = self._progress

        def told() -> int:
            progress(Training.from_buffer_copy(Training.from_address(training)))
            return 0

        return self._world.kept(told)(None)

    def save(self) -> bytes:
        """What was learned so far, the same on every machine."""
        return filled(library.critreg_skills_save, self.handle, checked=self._checked)

    def resume(self, data: bytes) -> None:
        """Brings fresh skills, made and added to as those that were saved, to where they
        were; `learn` then goes on from there."""
        self._checked(library.critreg_skills_resume(self.handle, c_char_p(data), len(data)))

    def __len__(self) -> int:
        return len(self._skills)

    def __getitem__(self, index: int) -> Skill:
        return self._skills[index]

    def __iter__(self) -> Iterator[Skill]:
        return iter(self._skills)


def _words(words: Sequence[str]) -> Optional[bytes]:
    """Words as the library takes them: separated by blanks, NULL if there are none."""
    if isinstance(words, str):
        raise TypeError(f"a list of names, not {words!r}")
    return encoded(" ".join(words)) if words else None
