"""Regions: the parameters with which an action is expected to work."""

from __future__ import annotations

from ctypes import addressof, byref, c_char_p, c_double, c_int32, c_size_t, c_uint8, c_uint32
from ctypes import c_void_p, sizeof
from enum import IntEnum
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Optional, Sequence, Union

from ._library import (
    check,
    checked_id,
    complaint,
    encoded,
    filled,
    library,
    made,
    memory,
    out,
    text_of,
)
from ._numbers import flags_of, matrix, rows_of, vector
from ._structs import MAX_INTERVALS, ConstraintStruct, ProofStruct, RngStruct
from .domain import Domain, as_domain

if TYPE_CHECKING:
    from ._numbers import Flags, Matrix, Vector


class Quality(IntEnum):
    """How good a region is; a larger number is better."""

    NO_QUALITY = 0
    """Nothing is known: it was parsed or loaded, or comes from ALGORITHM1."""
    PROVISIONAL = 1
    """It agrees with the answers so far, but they are too few to tell it from chance."""
    APPROXIMATE = 2
    """It is wrong about some answers; the report estimates how good it is."""
    EXACT = 3
    """It agrees with all answers, but for a few strays that the report counts."""


class Verdict(IntEnum):
    """Whether a region satisfies a specification."""

    UNDECIDED = 0
    """Neither a proof nor a counterexample was found."""
    PROVEN = 1
    """It does, in all instances in the ranges and with all parameters."""
    REFUTED = 2
    """It does not: there is a counterexample."""


class Proof(NamedTuple):
    """The answer of `Region.implies`."""

    verdict: Verdict
    """Proven, refuted or undecided."""
    statement: int
    """If it is not proven: which of the statements that "and" joins is not, from 0."""
    instance: Optional[list[float]]
    """If it is refuted: an instance,"""
    theta: Optional[list[float]]
    """and parameters that are in the region and not in the specification."""
    open: float
    """If it is undecided: the share of the cases that is open."""
    too_fine: bool
    """If it is undecided: whether more boxes do not help."""
    boxes: int
    """How many boxes were examined."""


class Rng:
    """A generator of random numbers: the same stream for a seed on every machine.

    It belongs to one thread at a time.
    """

    def __init__(self, seed: int) -> None:
        self._state: RngStruct = library.critreg_rng_seed(checked_id(seed, "seed"))

    @classmethod
    def _borrowed(cls, state: RngStruct) -> Rng:
        """The generator of a planner, which moves on with this one."""
        rng = cls.__new__(cls)
        rng._state = state
        return rng

    def uniform(self) -> float:
        """A number uniform in [0, 1)."""
        return float(out(c_double, library.critreg_rng_uniform, byref(self._state)))


class Evidence(NamedTuple):
    """What supports a constraint: any bound between the two values fits the answers."""

    step: int
    """The step of the sequence of actions that needs it, from 1."""
    support: int
    """How many samples that failed it excludes."""
    feasible: float
    """The extreme value of its left side at samples that worked (S)."""
    infeasible: float
    """The value at the first sample that failed and that it has to exclude (G)."""


class Constraint(NamedTuple):
    """A constraint of a region."""

    text: str
    """As it stands in the region, with the name of its bound."""
    name: str
    """What the bound is in words of the domain, such as "zone.top - robot.radius"."""
    evidence: Optional[Evidence]
    """What supports it; None unless the region was learned in this process."""


def constraints_of(handle: c_void_p) -> tuple[Constraint, ...]:
    """The constraints of a region of the library, from left to right."""
    count = out(c_size_t, library.critreg_region_constraint_count, handle)
    return tuple(_constraint(handle, index) for index in range(count))


def _constraint(handle: c_void_p, index: int) -> Constraint:
    known = made(ConstraintStruct, library.critreg_constraint_init)
    check(library.critreg_region_constraint(handle, index, byref(known)))
    evidence = Evidence(known.step, known.support, known.feasible, known.infeasible)
    return Constraint(
        text_of(library.critreg_region_constraint_format, handle, index),
        text_of(library.critreg_region_constraint_name, handle, index),
        evidence if known.has_evidence else None,
    )


class Picture(str):
    """An SVG picture: its text, which a notebook shows as what it is."""

    def _repr_svg_(self) -> str:
        return str(self)


class Region:
    """The parameters with which an action is expected to work, as constraints.

    It can be used by several threads at once, pickled and copied.

        region = Region(DOMAIN, "grasp.y <= zone.top - robot.radius")
        region.sample(instance, Rng(7))
    """

    constraints: tuple[Constraint, ...]
    """Its constraints, from left to right, with what supports them."""
    quality: Quality
    """How good it was found to be when it was learned."""

    def __init__(self, domain: Union[Domain, str], text: str) -> None:
        """Reads a region text; an `Error` tells line and column of what is wrong."""
        texts = encoded(as_domain(domain).text), encoded(text)
        check(*complaint(library.critreg_check_region, *texts))
        self._make(library.critreg_region_parse, *texts)

    @classmethod
    def load(cls, data: bytes) -> Region:
        """The region that `save` wrote."""
        region = cls.__new__(cls)
        region._make(library.critreg_region_load, c_char_p(data), len(data))
        return region

    @classmethod
    def _copied(cls, handle: c_void_p) -> Region:
        """A copy of a region that belongs to a learner, with what only that one knows."""
        region = cls.load(filled(library.critreg_region_save, handle))
        region.constraints = constraints_of(handle)
        region.quality = Quality(out(c_uint32, library.critreg_region_quality, handle))
        return region

    def _make(self, make: Any, *arguments: Any) -> None:
        size = library.critreg_region_size()
        self._memory = memory(size)  # The handle lies at its start.
        self._handle = c_void_p()
        check(make(self._memory, size, *arguments, byref(self._handle)))
        self._instance_len = out(c_size_t, library.critreg_region_instance_len, self._handle)
        self._parameters = out(c_size_t, library.critreg_region_parameter_count, self._handle)
        self.constraints = constraints_of(self._handle)
        self.quality = Quality(out(c_uint32, library.critreg_region_quality, self._handle))

    def save(self) -> bytes:
        """The region and its domain as bytes, the same on every machine."""
        return filled(library.critreg_region_save, self._handle)

    def __reduce__(self) -> Any:
        return _restored, (self.save(), self.constraints, self.quality)

    @property
    def text(self) -> str:
        """The constraints as text, which `Region` reads again."""
        return text_of(library.critreg_region_format, self._handle)

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<Region {self.text}>"

    def contains(self, instance: Vector, theta: Vector) -> bool:
        """Whether the action is expected to work with these parameters."""
        place = vector(instance, self._instance_len, "instance")
        sample = vector(theta, self._parameters, "theta")
        return bool(out(c_int32, library.critreg_region_contains, self._handle, place, sample))

    def contains_many(self, instance: Vector, thetas: Matrix) -> Flags:
        """The same of many samples, one a row."""
        place = vector(instance, self._instance_len, "instance")
        samples, count = matrix(thetas, self._parameters, "thetas")
        inside = (c_uint8 * count)()
        check(
            library.critreg_region_contains_many(self._handle, place, samples, count, inside)
        )
        return flags_of([answer == 1 for answer in inside])

    def margins(self, instance: Vector, theta: Vector) -> tuple[list[float], Matrix]:
        """For optimisers: of each constraint a value that is at most zero where it holds, and
        the gradient of that by the parameters, one a row."""
        place = vector(instance, self._instance_len, "instance")
        sample = vector(theta, self._parameters, "theta")
        count = len(self.constraints)
        values, gradients = (c_double * count)(), (c_double * (count * self._parameters))()
        check(library.critreg_region_margins(self._handle, place, sample, values, gradients))
        return list(values), rows_of(gradients, self._parameters, count)

    def implies(
        self,
        specification: Region,
        ranges: Matrix,
        max_boxes: Optional[int] = None,
        tolerance: Optional[float] = None,
    ) -> Proof:
        """Whether all that the region admits satisfies a specification, a region of the same
        domain, in every instance whose numbers are in `ranges`: a lower and an upper end for
        each."""
        return proof_of(
            library.critreg_region_implies, self._handle, specification, ranges, max_boxes, tolerance
        )

    def to_smt2(
        self, specification: Region, ranges: Matrix, tolerance: Optional[float] = None
    ) -> list[str]:
        """The questions of `implies` as SMT-LIB 2, for another prover, which answers "unsat"
        to each if the region satisfies the specification."""
        ends, count = matrix(ranges, 2, "ranges")
        if count != self._instance_len:
            raise ValueError(f"ranges: {count} of them, where {self._instance_len} are wanted")
        proof = made(ProofStruct, library.critreg_proof_init)
        if tolerance is not None:
            proof.tolerance = tolerance
        number = out(c_size_t, library.critreg_region_question_count, specification._handle)
        given = self._handle, specification._handle, ends, byref(proof)
        return [text_of(library.critreg_region_to_smt2, *given, k) for k in range(number)]

    def to_c(self, name: str) -> str:
        """The region as C that needs no library, in functions whose names begin with this."""
        return text_of(library.critreg_region_to_c, self._handle, encoded(name))

    def to_rust(self, precision: int = 64) -> str:
        """The region as a module of Rust that needs the crate libm only; it computes with
        numbers of 64 or 32 bits."""
        return text_of(library.critreg_region_to_rust, self._handle, precision)

    def picture(self, instance: Vector) -> Picture:
        """The region in an instance, as a picture that a notebook shows."""
        place = vector(instance, self._instance_len, "instance")
        return Picture(text_of(library.critreg_region_to_svg, self._handle, place))

    def sample(self, instance: Vector, rng: Rng) -> list[float]:
        """Parameters from the region in an instance, uniform.

        Raises `EmptyRegion` if it is proven that there are none, and `NoSample` if none
        were found.
        """
        return sample([(self, instance)], rng)

    def sample_many(self, instance: Vector, rng: Rng, count: int) -> Matrix:
        """So many samples, one a row, as `sample` draws them."""
        place = vector(instance, self._instance_len, "instance")
        samples = (c_double * (checked_id(count, "count", 32) * self._parameters))()
        at = addressof(samples)
        for _ in range(count):
            check(library.critreg_sample_region(self._handle, place, byref(rng._state), at))
            at += self._parameters * sizeof(c_double)
        return rows_of(samples, self._parameters, count)

    def is_empty(self, instance: Vector) -> bool:
        """Whether it is proven that the region has no parameters in an instance."""
        place = vector(instance, self._instance_len, "instance")
        return bool(out(c_int32, library.critreg_region_is_empty, self._handle, place))

    def intervals(self, instance: Vector) -> list[tuple[float, float]]:
        """The exact set in an instance, if the action has one parameter: sorted intervals."""
        place = vector(instance, self._instance_len, "instance")
        ends = (c_double * (2 * MAX_INTERVALS))()
        count = c_size_t()
        if self._parameters != 1:
            raise ValueError(f"intervals: the action has {self._parameters} parameters, not one")
        check(
            library.critreg_region_intervals(
                self._handle, place, ends, MAX_INTERVALS, byref(count)
            )
        )
        return [(ends[2 * i], ends[2 * i + 1]) for i in range(count.value)]


def proof_of(
    function: Callable[..., int],
    handle: c_void_p,
    specification: Region,
    ranges: Matrix,
    max_boxes: Optional[int],
    tolerance: Optional[float],
    checked: Callable[[int], None] = check,
) -> Proof:
    """What a function that proves finds out about what a handle has learned."""
    ends, count = matrix(ranges, 2, "ranges")
    if count != specification._instance_len:
        wanted = specification._instance_len
        raise ValueError(f"ranges: {count} of them, where {wanted} are wanted")
    proof = made(ProofStruct, library.critreg_proof_init)
    if max_boxes is not None:
        proof.max_boxes = checked_id(max_boxes, "max_boxes", 32)
    if tolerance is not None:
        proof.tolerance = tolerance
    instance, theta = (c_double * count)(), (c_double * specification._parameters)()
    checked(function(handle, specification._handle, ends, byref(proof), instance, theta))
    refuted = proof.verdict == Verdict.REFUTED
    return Proof(
        Verdict(proof.verdict),
        proof.statement,
        list(instance) if refuted else None,
        list(theta) if refuted else None,
        proof.open,
        proof.too_fine == 1,
        proof.boxes,
    )


def _restored(data: bytes, constraints: tuple[Constraint, ...], quality: Quality) -> Region:
    region = Region.load(data)
    region.constraints, region.quality = constraints, quality
    return region


Part = tuple[Region, "Vector"]
"""A region, and the instance to ground it in."""


def _parts(parts: Sequence[Part]) -> tuple[Any, Any, list[Any]]:
    """Arrays of handles and of instances; and what these point into."""
    places = [vector(at, region._instance_len, "instance") for region, at in parts]
    handles = (c_void_p * len(parts))(*(region._handle.value for region, _ in parts))
    return handles, (c_void_p * len(parts))(*map(addressof, places)), places


def sample(parts: Sequence[Part], rng: Rng) -> list[float]:
    """Parameters that several regions admit, each in an instance of its own.

    Raises as `Region.sample`.
    """
    handles, instances, _places = _parts(parts)
    theta = (c_double * (parts[0][0]._parameters if parts else 0))()
    check(
        library.critreg_sample_regions(handles, instances, len(parts), byref(rng._state), theta)
    )
    return list(theta)


def are_empty(parts: Sequence[Part]) -> bool:
    """Whether it is proven that several regions admit no parameters together."""
    handles, instances, _places = _parts(parts)
    return bool(
        out(c_int32, library.critreg_regions_are_empty, handles, instances, len(parts))
    )
