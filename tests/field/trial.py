"""One scenario with one seed: what is learned, how fast, and how good it is."""

import random
import time
from dataclasses import dataclass, field
from typing import Optional

import critreg
from judge import Score, Truth

# While a learner learns, its region is judged in fewer instances, to save time.
INSTANCES_WHILE_LEARNING = 10


@dataclass
class Options:
    """What the command line says about all trials."""

    calls_factor: float  # of the budget of the scenario
    forms: int  # to have room for; 0: what the library has by default


@dataclass
class Trial:
    """What came of one seed."""

    region: Optional[str] = None
    score: Optional[Score] = None  # with `region`
    aligned: Optional[Score] = None  # with `region`, if the scenario has aligned instances
    calls_until_exact: Optional[int] = None  # after which it stays exact to the end
    milliseconds: list = field(default_factory=list)  # each ask and tell together
    error: Optional[str] = None  # why it was broken off


def training(scenario, seed):
    """The instances that are learned from."""
    rng = random.Random(seed)
    return [scenario.instance(rng) for _ in range(scenario.instances)]


def room_for_demonstrations(scenario):
    """They are told beside what is asked."""
    if not scenario.demonstrations:
        return {}
    return {"observations": scenario.calls + scenario.demonstrations + 2}


def make_learner(scenario, seed, options):
    """A fresh learner for a scenario."""
    learner = critreg.Learner(
        scenario.text,
        training(scenario, seed),
        seed=seed,
        calls=max(1, round(scenario.calls * options.calls_factor)),
        forms=options.forms,
        steps=scenario.steps,
        noise=scenario.noise,
        **room_for_demonstrations(scenario),
    )
    parameters = learner.domain.parameters
    if not len(parameters) == len(scenario.lo) == len(scenario.hi):
        raise ValueError(f"{scenario.name}: the text has the parameters {parameters}")
    return learner


def outcome(scenario, instance, theta, rng):
    """What a simulator says: the truth, or something else if this answer is a wrong one."""
    if scenario.steps == 1:
        failed = 0 if scenario.works(instance, theta) else 1
    else:
        failed = scenario.fails(instance, theta)
    if scenario.noise and rng.random() < scenario.noise:
        failed = 0 if failed else rng.randint(1, scenario.steps)
    if failed == 0:
        return critreg.FEASIBLE
    return -failed if scenario.steps > 1 else critreg.INFEASIBLE


def run(scenario, seed, options):
    """Learns and judges."""
    trial = Trial()
    try:
        learn_and_judge(scenario, seed, options, trial)
    except critreg.Error as error:
        trial.error = f"CRITREG_{error.status.name}: {error}"
    return trial


def ask_and_tell(learner, answer):
    """One question and its answer. Returns the milliseconds that the learner takes."""
    started = time.perf_counter()
    index, theta = learner.ask()
    asked = time.perf_counter()
    told = answer(index, theta)
    answered = time.perf_counter()
    learner.tell(told)
    return 1e3 * (time.perf_counter() - answered + asked - started)


def learn_and_judge(scenario, seed, options, trial):
    instances = training(scenario, seed)
    learner = make_learner(scenario, seed, options)
    truth = Truth(scenario, scenario.instance, f"fresh {seed}")
    rng = random.Random(f"wrong answers {seed}")

    def answer(index, theta):
        return outcome(scenario, instances[index], theta, rng)

    for index, instance in enumerate(instances[: scenario.demonstrations]):
        learner.observe(index, scenario.demonstrate(instance), critreg.FEASIBLE)
    region, text, exact_since = None, None, None
    while not learner.is_finished:
        trial.milliseconds.append(ask_and_tell(learner, answer))
        region = learner.region()
        before, text = text, region and region.text
        if text == before:
            continue
        if region is None or not truth.score(region, INSTANCES_WHILE_LEARNING).is_exact():
            exact_since = None
        elif exact_since is None:
            exact_since = len(trial.milliseconds)
    if region is None:
        return
    trial.region, trial.score = text, truth.score(region)
    if trial.score.is_exact():
        # Fewer instances may have said otherwise.
        trial.calls_until_exact = exact_since or len(trial.milliseconds)
    if scenario.aligned:
        trial.aligned = Truth(scenario, scenario.aligned, f"aligned {seed}").score(region)
