"""Scenarios about laws: products, quotients, slopes, and several windows of one number."""

import math

from common import Scenario


class Payload(Scenario):
    """The heavier a load is, the nearer to its base the arm has to hold it."""

    name = "payload"
    lo, hi = [-1.0, 0.0], [1.0, 1.0]
    text = """object base { x: length, y: length }
object load { mass: none, size: length }
parameter px in [-1, 1]: length
parameter py in [0, 1]: length
point hand = world + (px, py)
"""

    def instance(self, rng):
        place = [rng.uniform(-0.3, 0.3), rng.uniform(0, 0.2)]
        return place + [rng.uniform(0.5, 5), rng.uniform(0.1, 0.4)]

    def works(self, i, t):
        return i[2] * math.dist(t, i[:2]) <= 1.3


class Torque(Scenario):
    """How far out a bar is pushed, of which its mass and its drag differ."""

    name = "torque"
    lo, hi = [0.0], [1.0]
    text = """object bar { mass: none, drag: none, length: length }
parameter s in [0, 1]: length
"""

    def instance(self, rng):
        return [rng.uniform(0.5, 3), rng.uniform(0.5, 2), rng.uniform(0.5, 1)]

    def works(self, i, t):
        return i[0] * i[1] * t[0] <= 0.7


class Slide(Scenario):
    """With which speed something is pushed that has to slide as far as its goal."""

    name = "slide"
    lo, hi = [0.1], [3.0]
    text = """object ground { friction: none }
object goal { far: length }
object tray { length: length }
parameter v in [0.1, 3]
"""

    def instance(self, rng):
        return [rng.uniform(0.2, 0.6), rng.uniform(0.3, 1), rng.uniform(0.1, 0.3)]

    def works(self, i, t):
        return 0.85 * i[1] <= t[0] ** 2 / (2 * 9.81 * i[0]) <= 1.15 * i[1]


class Cone(Scenario):
    """A foot stands where it is not too flat as seen from a pad."""

    name = "cone"
    lo, hi = [-1.0, -1.0], [1.0, 1.0]
    text = """object pad { x: length, y: length }
parameter px in [-1, 1]: length
parameter py in [-1, 1]: length
point foot = world + (px, py)
"""

    def instance(self, rng):
        return [rng.uniform(-0.8, 0.4), rng.uniform(-0.8, 0.4)]

    def works(self, i, t):
        return abs(t[0] - i[0]) <= 0.35 * abs(t[1] - i[1])


class Rungs(Scenario):
    """A hook holds between the rungs of a ladder that are there."""

    name = "rungs"
    instances = 8
    lo, hi = [0.0], [8.0]
    WINDOWS = [(0.6, 1.3), (2.1, 2.9), (4.0, 5.1), (6.2, 7.2)]
    text = """object ladder { x: length, y: length }
parameter up in [0, 8]: length
point hook = ladder + (0, up)
"""

    def instance(self, rng):
        return [rng.uniform(-1, 1), rng.uniform(-1, 1)]

    def works(self, i, t):
        return any(low <= t[0] <= high for low, high in self.WINDOWS)


LAWS = [Payload, Torque, Slide, Cone, Rungs]
