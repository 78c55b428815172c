"""How well a region agrees with the truth of a scenario, in fresh instances."""

import random
from typing import NamedTuple

INSTANCES = 60
PARAMETERS = 400  # tried in each instance, uniform over their ranges


class Score(NamedTuple):
    """`precision`: the share of the region that works; `recall`: the share of what works
    that is in the region. Both are 0 where there is nothing to take a share of."""

    precision: float
    recall: float

    def is_exact(self):
        return self.precision >= 0.995 and self.recall >= 0.98

    def is_useful(self):
        return self.precision > 0.95 and self.recall > 0.8


class Truth:
    """What works in fresh instances, which `draw` makes of a random generator."""

    def __init__(self, scenario, draw, stream):
        rng = random.Random(stream)
        ranges = list(zip(scenario.lo, scenario.hi))
        self._cases = []
        for _ in range(INSTANCES):
            instance = draw(rng)
            thetas = [[rng.uniform(*ends) for ends in ranges] for _ in range(PARAMETERS)]
            works = [bool(scenario.works(instance, theta)) for theta in thetas]
            self._cases.append((instance, thetas, works))

    def score(self, region, instances=INSTANCES):
        """Compares a region with the truth in the first so many instances."""
        both = claimed = true = 0
        for instance, thetas, works in self._cases[:instances]:
            inside = region.contains_many(instance, thetas)
            both += sum(a and b for a, b in zip(inside, works))
            claimed += sum(inside)
            true += sum(works)
        return Score(both / max(claimed, 1), both / max(true, 1))
