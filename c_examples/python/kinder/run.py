"""Learns skills in a KinDER environment, plans with them, and plans with KinDER's own planner.

    python run.py stickbutton2d --variants 3 --seeds 5

Progress goes to the error output; what was learned and the table to the output.
"""

import argparse
import sys
import time

import numpy
from bilevel_planning.refiners.backtracking_refiner import BacktrackingRefiner
from bilevel_planning.sesame import run_sesame
from bilevel_planning.trajectory_samplers.parameterized_controller_sampler import (
    ParameterizedControllerTrajectorySampler,
)

import critreg
from critreg.bilevel import World
from worlds import Environment


HORIZON = 200
"""Most actions of a controller: across the room and to the stick it takes more than KinDER's 100."""


def told(*words):
    print(*words, file=sys.stderr, flush=True)


def untaught(world, environment, tasks):
    """Skills of which nothing is known, with tasks of the training variants."""
    text = environment.text
    states = [
        environment.state(text.TRAINING[place % len(text.TRAINING)], 1000 + place)
        for place in range(tasks)
    ]
    return world.skills(states, **text.LEARNING)


def learn(world, skills):
    """Learns all skills; how long it took."""
    start = time.perf_counter()

    def progress(training):
        if training.runs % 25 == 0:
            seconds = time.perf_counter() - start
            name = skills[training.skill].name
            told(f"{name}: {training.runs} runs of controllers, {seconds:.0f} s")

    skills.learn(world.practise, world.holds, world.sample, progress)
    return time.perf_counter() - start


def ours(world, skills, state, seed):
    """Whether it is solved, samples, steps of the plan."""
    planner = world.planner(
        state, lookahead=32, patience=20000, max_samples=60, max_tries=2, nodes=100000
    )
    try:
        world.plan(state, skills, seed, planner)
    except critreg.NoPlan as why:
        told(f"  seed {seed}: {why}")
    metrics = planner.metrics()
    solved = metrics.plan_length > 0
    return solved, metrics.samples, metrics.plan_length


class Counted:
    """KinDER's planner, whose samples are counted."""

    def __init__(self):
        self.samples, self.steps = 0, 0
        sample, refine = ParameterizedControllerTrajectorySampler.__call__, BacktrackingRefiner.__call__

        def counting(*arguments):
            self.samples += 1
            return sample(*arguments)

        def noting(refiner, x0, s_plan, a_plan, *arguments):
            self.steps = len(a_plan)
            return refine(refiner, x0, s_plan, a_plan, *arguments)

        ParameterizedControllerTrajectorySampler.__call__ = counting
        BacktrackingRefiner.__call__ = noting

    def plan(self, models, state, seed, seconds):
        """Whether it is solved, samples, steps of the plan."""
        self.samples = self.steps = 0
        plan, _ = run_sesame(
            models,
            state,
            seed=seed,
            max_abstract_plans=10,
            samples_per_step=3,
            max_skill_horizon=HORIZON,
            timeout=seconds,
        )
        return plan is not None, self.samples, self.steps if plan else 0


def measured(name, variant, seeds, plan):
    """A row of the table."""
    results = []
    for seed in seeds:
        start = time.perf_counter()
        results.append((*plan(seed), time.perf_counter() - start))
        told(f"  {name}, variant {variant}, seed {seed}: {results[-1]}")
    solved = [one for one in results if one[0]]
    samples, seconds = (numpy.mean([one[place] for one in results]) for place in (1, 3))
    steps = numpy.mean([one[2] for one in solved]) if solved else float("nan")
    share = f"{len(solved)}/{len(results)}"
    return f"| {variant} | {name} | {share} | {samples:.2f} | {steps:.2f} | {seconds:.2f} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("environment", help="stickbutton2d, obstruction2d, or a file like these")
    parser.add_argument("--variants", type=int, nargs="*")
    parser.add_argument("--seeds", type=int, default=20, help="tasks of each variant")
    parser.add_argument("--first", type=int, default=0, help="the seed of the first task")
    parser.add_argument("--baseline", type=int, default=5, help="tasks for KinDER's planner")
    parser.add_argument("--tasks", type=int, default=60, help="training tasks")
    parser.add_argument("--timeout", type=float, default=60.0, help="of KinDER's planner")
    parser.add_argument("--save", help="a file for what was learned")
    parser.add_argument("--load", help="a file that was saved, with the same tasks")
    options = parser.parse_args()

    environment = Environment(options.environment)
    text = environment.text
    variants = options.variants or text.VARIANTS
    models = environment.of_all(sorted({*text.TRAINING, *variants}))
    world = World(models, text.TEXTS, HORIZON, text.REFUSED)
    skills = untaught(world, environment, options.tasks)
    if options.load:
        with open(options.load, "rb") as file:
            skills.resume(file.read())
    seconds = learn(world, skills)
    if options.save:
        with open(options.save, "wb") as file:
            file.write(skills.save())
    for skill in skills:
        report = skill.report
        print(f"{skill.name}, after {report.runs} runs of controllers:\n    {skill.text}")
    print(f"learned in {seconds:.0f} s\n", flush=True)

    print("| variant | planner | solved | samples | plan length | seconds |")
    print("|---|---|---|---|---|---|")
    counted = Counted()
    for variant in variants:
        seeds = range(options.first, options.first + options.seeds)
        states = {seed: environment.state(variant, seed) for seed in seeds}
        own = environment.models(variant)
        print(
            measured(
                "KinDER",
                variant,
                seeds[: options.baseline],
                lambda seed: counted.plan(own, states[seed], seed, options.timeout),
            ),
            flush=True,
        )
        print(
            measured(
                "critreg",
                variant,
                seeds,
                lambda seed: ours(world, skills, states[seed], seed),
            ),
            flush=True,
        )


if __name__ == "__main__":
    main()
