"""Learns with which parameters a robot's action will work.

    import critreg

    learner = critreg.Learner(DOMAIN, instances, seed=7)
    region = learner.learn(try_grasp, workers=4)      # a readable critreg.Region
    theta = region.sample(new_instance, critreg.Rng(1))

The functions behind it are those of critreg.h, which is their manual; ACTIONS.md says how
to describe an action.
"""

from . import _library
from ._structs import NO_REASON, Metrics, Report, SkillReport, Training
from .domain import Domain
from .generator import Generator
from .learner import (
    ALGORITHM1,
    FEASIBLE,
    INFEASIBLE,
    UNKNOWN,
    VERSION_SPACE,
    Learner,
    Options,
    Query,
    Question,
    Why,
)
from .planner import Heuristic, Planner, PlannerOptions, Step
from .region import (
    Constraint,
    Evidence,
    Picture,
    Proof,
    Quality,
    Region,
    Rng,
    Verdict,
    are_empty,
    sample,
)
from .skills import Skill, Skills, SkillsOptions
from .status import EmptyRegion, Error, NoPlan, NoRegion, NoSample, Status
from .world import Advice, Draw, Drawn, Ground

__version__: str = _library.library.critreg_version().decode()

__all__ = [
    "ALGORITHM1",
    "FEASIBLE",
    "INFEASIBLE",
    "NO_REASON",
    "UNKNOWN",
    "VERSION_SPACE",
    "Advice",
    "Constraint",
    "Domain",
    "Draw",
    "Drawn",
    "EmptyRegion",
    "Error",
    "Evidence",
    "Generator",
    "Ground",
    "Heuristic",
    "Learner",
    "Metrics",
    "NoPlan",
    "NoRegion",
    "NoSample",
    "Options",
    "Picture",
    "Planner",
    "PlannerOptions",
    "Proof",
    "Quality",
    "Query",
    "Question",
    "Region",
    "Report",
    "Rng",
    "Skill",
    "SkillReport",
    "Skills",
    "SkillsOptions",
    "Status",
    "Step",
    "Training",
    "Verdict",
    "Why",
    "are_empty",
    "sample",
]
