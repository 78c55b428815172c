"""Scenarios that need no bodies: sums, limits, headings, chains, wrong answers."""

import math
from math import pi

from common import Scenario, wrapped


class Reach(Scenario):
    """A hand reaches a cup that is neither too near nor too far from where the base stops."""

    name = "reach"
    calls, instances = 100, 8
    lo, hi = [-1.0, -1.0], [1.0, 1.0]
    text = """object cup { x: length, y: length }
constant nearest = 0.25: length
constant farthest = 0.8: length
parameter bx in [-1, 1]: length
parameter by in [-1, 1]: length
point base = world + (bx, by)
"""

    def instance(self, rng):
        return [rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)]

    def works(self, i, t):
        return 0.25 <= math.dist(t, i) <= 0.8


class UnreliableReach(Reach):
    """The same, where one answer of fifty is wrong."""

    name = "unreliable_reach"
    calls = 400
    noise = 0.02


class PickAndHang(Scenario):
    """A stick is picked where the hand can go, and then its end has to get to a hook."""

    name = "pick_and_hang"
    calls, instances = 150, 8
    steps = 2
    lo, hi = [0.0], [1.0]
    text = """object stick { x: length, y: length }
object hook { x: length, y: length }
constant stick.length = 2.0: length
constant ceiling = 2.5: length
constant arm.length = 1.5: length
parameter mu in [0, 1]
point grasp = stick + (0, mu * stick.length)
"""

    def instance(self, rng):
        hook = [rng.uniform(0, 1), rng.uniform(0.5, 2.5)]
        return [rng.uniform(0, 1), rng.uniform(0.5, 1.5)] + hook

    def fails(self, i, t):
        grasp = [i[0], i[1] + 2.0 * t[0]]
        if grasp[1] > 2.5:
            return 1
        return 2 if math.dist(grasp, i[2:]) > 1.5 else 0


class Fit(Scenario):
    """A part fits between the fingers, whatever the parameter, and is held below a beam."""

    name = "fit"
    calls, instances = 300, 64
    lo, hi = [0.0], [1.0]
    text = """object gripper { open: length }
object part { x: length, y: length, width: length }
constant part.length = 0.4: length
constant beam = 0.5: length
parameter mu in [0, 1]
point grasp = part + (0, mu * part.length)
"""

    def instance(self, rng):
        return [rng.uniform(0.06, 0.1), rng.uniform(0, 1), rng.uniform(0, 0.4), rng.uniform(0.03, 0.12)]

    def works(self, i, t):
        return i[3] <= i[0] and i[2] + 0.4 * t[0] <= 0.5


class Joint(Scenario):
    """A joint turns by dq and stays within limits, which differ from robot to robot."""

    name = "joint"
    lo, hi = [-pi], [pi]
    text = """object arm { q: angle, lower: angle, upper: angle }
parameter dq in [-pi, pi]: angle
"""

    def instance(self, rng):
        return [rng.uniform(-0.5, 0.5), rng.uniform(-2.5, -1), rng.uniform(1, 2.5)]

    def works(self, i, t):
        return i[1] <= i[0] + t[0] <= i[2]


class Front(Scenario):
    """A mug is approached from the front of the robot, within six degrees."""

    name = "front"
    lo, hi = [-pi], [pi]
    text = """object robot { x: length, y: length, theta: angle }
object mug   { x: length, y: length, theta: angle }
constant tolerance = 0.10471975511965977: angle
parameter phi in [-pi, pi]: angle
point pregrasp = mug turned phi + (-0.15, 0)
"""

    def instance(self, rng):
        return [end * rng.uniform(-1, 1) for end in [1, 1, pi, 1, 1, pi]]

    def works(self, i, t):
        return abs(wrapped(i[5] + t[0] - i[2])) <= pi / 30


class Wrench(Front):
    """A square nut is taken by any of its four sides."""

    name = "wrench"
    text = """object nut  { x: length, y: length, theta: angle }
object hand { x: length, y: length, theta: angle }
parameter phi in [-pi, pi]: angle
point jaw = hand turned phi + (0.05, 0)
"""

    def works(self, i, t):
        return abs(wrapped(4 * (i[5] + t[0] - i[2]))) / 4 <= 0.2


class Overlap(Scenario):
    """A plank may lie beyond a rack by what keeps it from tipping: a factor of no list."""

    name = "overlap"
    lo, hi = [-1.0], [1.0]
    text = """object rack { x: length, width: length, height: length }
parameter px in [-1, 1]: length
point plank = world + (px, 0)
"""

    def instance(self, rng):
        return [rng.uniform(-0.4, 0.4), rng.uniform(0.2, 1.2), rng.uniform(0.1, 1)]

    def works(self, i, t):
        return abs(t[0] - i[0]) <= 0.37 * i[1]


class Slope(Scenario):
    """A foot stays below a line that is parallel to no axis."""

    name = "slope"
    calls = 300
    lo, hi = [-1.0, 0.0], [1.0, 1.0]
    text = """object stone { x: length, y: length }
parameter px in [-1, 1]: length
parameter py in [0, 1]: length
point foot = world + (px, py)
"""

    def instance(self, rng):
        return [rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0)]

    def works(self, i, t):
        return (t[0] - i[0]) + (t[1] - i[1]) <= 0.7


class Notch(Scenario):
    """A notch of a thousandth of the range, of which two places are known beforehand."""

    name = "notch"
    demonstrations = 2
    lo, hi = [0.0], [1.0]
    text = """object notch { x: length }
parameter px in [0, 1]: length
"""

    def instance(self, rng):
        return [rng.uniform(0.1, 0.9)]

    def demonstrate(self, i):
        return [i[0] - 0.0002]

    def works(self, i, t):
        return abs(t[0] - i[0]) <= 0.0005


class Wrist(Reach):
    """A reach in which the wrist flips in 5% of the space, of which the text knows nothing."""

    name = "wrist"
    calls, instances = 300, 16
    goal = "useful"

    def works(self, i, t):
        distance, bearing = math.dist(t, i), math.atan2(t[1] - i[1], t[0] - i[0])
        return super().works(i, t) and math.sin(5 * bearing + 13 * distance) > -0.985


PLAIN = [
    Reach,
    UnreliableReach,
    PickAndHang,
    Fit,
    Joint,
    Front,
    Wrench,
    Overlap,
    Slope,
    Notch,
    Wrist,
]
