"""The structs of critreg.h, field by field; a test compares them with the header.

A field is declared once: its annotation is its C type, and to a type checker what Python
makes of it.
"""

import ctypes
from typing import TYPE_CHECKING, Any, Type, TypeVar

MAX_PARAMETERS = 6
MAX_ARGUMENTS = 10
MAX_INTERVALS = 33
MAX_QUESTIONS = 64
DEFAULT_INSTANCES = 16
NO_REASON = 65535

if TYPE_CHECKING:
    uint32 = int
    uint64 = int
    int32 = int
    size = int
    double = float
    text = bytes
    pointer = Any
    parameters = Any
    names = Any
    indices = Any
    words = Any
else:
    uint32, uint64, int32 = ctypes.c_uint32, ctypes.c_uint64, ctypes.c_int32
    size, double, text, pointer = (
        ctypes.c_size_t,
        ctypes.c_double,
        ctypes.c_char_p,
        ctypes.c_void_p,
    )
    parameters = double * MAX_PARAMETERS
    names, indices = text * MAX_ARGUMENTS, uint32 * MAX_ARGUMENTS
    words = uint64 * 2

_Struct = TypeVar("_Struct", bound=ctypes.Structure)


def _laid_out(struct: Type[_Struct]) -> Type[_Struct]:
    struct._fields_ = list(struct.__annotations__.items())
    return struct


@_laid_out
class Config(ctypes.Structure):
    """critreg_config."""

    struct_size: uint32
    learner: uint32
    seed: uint64
    forms: uint32
    observations: uint32
    calls: uint32
    certifying: uint32
    instances: uint32
    steps: uint32
    noise: double
    exploring: double
    slack: double
    confidence: double
    negative: pointer
    positive: pointer
    progress: pointer
    progress_data: pointer
    tracked: uint32
    precision: uint32
    sums: uint32
    precision_wanted: double
    questions: uint32


class _Shown(ctypes.Structure):
    """What is handed out: it prints what it holds."""

    def __repr__(self) -> str:
        fields = [field[0] for field in self._fields_]
        shown = [name for name in fields if name not in ("struct_size", "reserved")]
        values = ", ".join(f"{name}={getattr(self, name)!r}" for name in shown)
        return f"{type(self).__name__}({values})"


@_laid_out
class Report(_Shown):
    """How learning went so far: critreg_report."""

    struct_size: uint32
    quality: uint32
    enumerated: uint64
    kept: uint64
    left_out: uint64
    after_negative: uint64
    after_positive: uint64
    remaining: uint64
    calls: uint64
    feasible: uint64
    infeasible: uint64
    unknown: uint64
    strays: uint64
    constraints_left_out: uint64
    certificate_draws: uint64
    certificate_feasible: uint64
    certificate_lower_bound: double
    precision_low: double
    precision_high: double
    recall_low: double
    recall_high: double
    observed: uint64


@_laid_out
class ProofStruct(ctypes.Structure):
    """critreg_proof."""

    struct_size: uint32
    max_boxes: uint32
    tolerance: double
    verdict: uint32
    too_fine: uint32
    statement: uint32
    boxes: uint32
    open: double


@_laid_out
class ConstraintStruct(ctypes.Structure):
    """critreg_constraint."""

    struct_size: uint32
    has_evidence: int32
    step: uint32
    support: uint32
    feasible: double
    infeasible: double


@_laid_out
class RngStruct(ctypes.Structure):
    """critreg_rng."""

    state: words


@_laid_out
class PlannerConfig(ctypes.Structure):
    """critreg_planner_config."""

    struct_size: uint32
    heuristic: uint32
    state_len: uint32
    max_skeletons: uint32
    max_tries: uint32
    max_length: uint32
    max_actions: uint32
    max_samples: uint32
    patience: uint32
    pddl_bytes: uint32
    operators: uint32
    nodes: uint32
    atoms: uint32
    facts: uint32
    skeletons_per_state: uint32
    lookahead: uint32


@_laid_out
class GroundStruct(ctypes.Structure):
    """critreg_ground."""

    name: text
    object_names: names
    index: uint32
    object_count: uint32
    objects: indices


@_laid_out
class DrawStruct(ctypes.Structure):
    """critreg_draw."""

    skeleton: pointer
    length: size
    step: size
    state: pointer
    state_len: size
    parameter_count: size
    attempt: uint32
    advised: int32


@_laid_out
class DrawnStruct(ctypes.Structure):
    """critreg_drawn."""

    parameters: parameters
    informed: int32
    reason: uint32


@_laid_out
class CallbacksStruct(ctypes.Structure):
    """critreg_callbacks."""

    struct_size: uint32
    prune: uint32
    execute: pointer
    holds: pointer
    sample: pointer
    advise: pointer
    skills: pointer


@_laid_out
class StepStruct(ctypes.Structure):
    """critreg_step."""

    struct_size: uint32
    actions: uint32
    ground: GroundStruct
    parameter_count: size
    parameters: parameters
    state: pointer


@_laid_out
class Metrics(_Shown):
    """What planning cost, and what stood in its way: critreg_metrics."""

    struct_size: uint32
    conclusion: uint32
    plan_length: uint32
    samples: uint32
    skeletons: uint32
    nodes_expanded: uint32
    nodes_created: uint32
    pruned: uint32
    postponed: uint32
    cut_off: uint32
    empty_draws: uint32
    informed_draws: uint32
    patience_ended: uint32
    uncounted: uint32
    actions: uint64
    most_failed: text
    main_reason: uint32
    repeated: uint32


@_laid_out
class Training(_Shown):
    """How learning of skills goes: critreg_training."""

    struct_size: uint32
    skill: uint32
    skills: uint32
    runs: uint32


@_laid_out
class SkillsConfig(ctypes.Structure):
    """critreg_skills_config."""

    struct_size: uint32
    state_len: uint32
    learner: pointer
    chained: uint32
    budget: uint32
    situations: uint32
    states: uint32
    situation_tasks: uint32
    tasks: uint32
    controllers: uint32
    skills: uint32
    texts: uint32
    nodes: uint32
    facts: uint32
    runs: uint32
    way: uint32
    progress: pointer
    progress_data: pointer


@_laid_out
class SkillReport(_Shown):
    """What it took to learn a skill: critreg_skill_report."""

    struct_size: uint32
    finished: uint32
    has_region: uint32
    quality: uint32
    why: uint32
    tasks: uint32
    situations: uint32
    runs: uint32
    calls: uint32
    feasible: uint32
    infeasible: uint32
    certificate_draws: uint32
    certificate_feasible: uint32
    reserved: uint32
    certificate_lower_bound: double
