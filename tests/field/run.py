#!/usr/bin/env python3
"""Learns the scenarios of a Python file, judges the regions and prints `key: value` lines.

README.md beside this file says what a scenario is and what the lines mean.
"""

import argparse
import functools
import importlib.util
import os
import re
import statistics
import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor

# The package of the checkout, with the library that was built last.
sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "ffi", "python", "src"))

import critreg
import trial
from trial import Options

# A scenario reaches its goal if this share of the seeds does.
SHARE_OF_SEEDS = 0.95


class Scenario:
    """An entry of SCENARIOS, a class or an object, with everything that it may leave out."""

    noise = 0.0
    steps = 1
    demonstrations = 0
    aligned = None
    goal = "exact"

    def __init__(self, entry):
        self._entry = entry() if isinstance(entry, type) else entry
        for name in ["noise", "steps", "demonstrations", "aligned", "goal"]:
            setattr(self, name, getattr(self._entry, name, getattr(Scenario, name)))

    def __getattr__(self, name):
        return getattr(self._entry, name)

    def works(self, instance, theta):
        """Whether the action works: no step fails."""
        if hasattr(self._entry, "works"):
            return self._entry.works(instance, theta)
        return self._entry.fails(instance, theta) == 0


@functools.cache
def load(path):
    """The scenarios of a file by name, in its order."""
    spec = importlib.util.spec_from_file_location("scenarios", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return {scenario.name: scenario for scenario in map(Scenario, module.SCENARIOS)}


def run(path, name, seed, options):
    """One trial; in a process of its own, which reads the file itself."""
    return trial.run(load(path)[name], seed, options)


def refusal(scenario, seed, options):
    """Why the library cannot learn with the text of a scenario; None if it can."""
    try:
        trial.make_learner(scenario, seed, options)
    except critreg.Error as error:
        return f"CRITREG_{error.status.name}: {error}"
    return None


def family(region):
    """A region without the order of its constraints and the digits of its free thresholds."""
    rounded = re.sub(r"\d+\.\d{4,}(e-?\d+)?", "#", region)
    return tuple(sorted(rounded.split(" and ")))


def most_frequent(regions):
    """The first region of the largest family, and how many there are of it."""
    families = Counter(map(family, regions))
    largest, count = families.most_common(1)[0]
    example = next(region for region in regions if family(region) == largest)
    return example, count


def print_mean_and_least(key, values):
    if values:
        print(f"{key}_mean: {statistics.mean(values):.4f}")
        print(f"{key}_least: {min(values):.4f}")


def median_calls(trials):
    """The median of all trials; those that are never exact come last."""
    never = float("inf")
    calls = [never if t.calls_until_exact is None else t.calls_until_exact for t in trials]
    median = statistics.median(calls)
    return "never" if median == never else f"{median:g}"


def percentile_99(values):
    values = sorted(values)
    return values[round(0.99 * (len(values) - 1))]


def print_block(scenario, trials):
    """Prints what came of a scenario. Returns whether it reached its goal."""
    count = len(trials)
    learned = [t for t in trials if t.score]
    exact = sum(t.score.is_exact() for t in learned)
    useful = sum(t.score.is_useful() for t in learned)
    print(f"exact: {exact}/{count}")
    print(f"useful: {useful}/{count}")
    print_mean_and_least("precision", [t.score.precision for t in learned])
    print_mean_and_least("recall", [t.score.recall for t in learned])
    if scenario.aligned:
        print_mean_and_least("aligned_precision", [t.aligned.precision for t in learned])
    print(f"calls_until_exact_median: {median_calls(trials)}")
    print(f"no_region: {sum(not t.score and not t.error for t in trials)}/{count}")
    times = [time for t in trials for time in t.milliseconds]
    if times:
        print(f"ask_tell_ms_p99: {percentile_99(times):.2f}")
    if learned:
        example, seeds = most_frequent([t.region for t in learned])
        print(f"most_frequent_region: {example}")
        print(f"most_frequent_region_seeds: {seeds}/{count}")
    errors = [t.error for t in trials if t.error]
    if errors:
        print(f"broken_off: {len(errors)}/{count} {errors[0]}")
    reached = exact if scenario.goal == "exact" else useful
    return reached >= SHARE_OF_SEEDS * count


def run_all(path, scenarios, seeds, options):
    """Prints the blocks of all scenarios. Returns how many reached their goals."""
    refusals = {s.name: refusal(s, seeds[0], options) for s in scenarios}
    reached = 0
    with ProcessPoolExecutor(os.cpu_count()) as processes:
        trials = {
            s.name: [processes.submit(run, path, s.name, seed, options) for seed in seeds]
            for s in scenarios
            if refusals[s.name] is None
        }
        for scenario in scenarios:
            print(f"scenario: {scenario.name}")
            if refusals[scenario.name]:
                print(f"refused: {refusals[scenario.name]}")
            else:
                done = []
                for seed, submitted in zip(seeds, trials[scenario.name]):
                    done.append(submitted.result())
                    print(f"{scenario.name}: seed {seed} done", file=sys.stderr)
                reached += print_block(scenario, done)
            print(flush=True)
    return reached


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", help="a Python file that defines SCENARIOS")
    parser.add_argument("--seeds", type=int, default=5, help="learners of each scenario")
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--only", help="names of scenarios, with commas between them")
    parser.add_argument("--calls-factor", type=float, default=1.0, help="share of the budgets")
    parser.add_argument("--forms", type=int, default=0, help="forms to have room for")
    given = parser.parse_args()
    if given.seeds < 1:
        parser.error("--seeds: at least one")
    known = load(given.file)
    names = given.only.split(",") if given.only else list(known)
    for name in names:
        if name not in known:
            parser.error(f"--only: there is no {name}, but {', '.join(known)}")
    return given, [known[name] for name in names]


def main():
    given, scenarios = arguments()
    seeds = range(given.first, given.first + given.seeds)
    options = Options(calls_factor=given.calls_factor, forms=given.forms)
    reached = run_all(given.file, scenarios, seeds, options)
    print(f"reached: {reached} of {len(scenarios)} scenarios")


if __name__ == "__main__":
    main()
