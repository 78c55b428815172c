"""Scenarios with several bodies and several conditions at once."""

import math
from math import pi

from bodies import Fingers
from common import QUARTERS, Scenario, Turned
from common import corners, do_overlap, from_rectangle, from_segment, is_in_rectangle
from common import group, members, turned, wrapped


class TiltedFingers(Fingers):
    """Where along a bar two fingers close, and at which angle to it."""

    name = "tilted_fingers"
    calls = 300
    lo, hi = [-0.15, -0.8], [0.15, 0.8]
    text = Fingers.text.replace(
        "point grip  = bar + (s, 0)",
        """parameter phi in [-0.8, 0.8]: angle
point spot  = bar + (s, 0)
point grip  = spot turned phi""",
    )

    def works(self, i, t):
        if abs(t[0]) > i[3] / 2:
            return False
        x, y = turned(t[0], 0.0, i[2])
        for side in [1, -1]:
            dx, dy = turned(0.0, side * (self.OPEN + self.THICK) / 2, i[2] + t[1])
            finger = [i[0] + x + dx, i[1] + y + dy, i[2] + t[1]]
            if do_overlap((finger, self.WIDE, self.THICK), (i[:3], i[3], i[4])):
                return False
            for cx, cy, radius in members(i[5:], 3):
                if from_rectangle(finger, self.WIDE, self.THICK, cx, cy) < radius:
                    return False
        return True


class Kit(Turned):
    """An item at any yaw in a turned tray, beside up to four others."""

    name = "kit"
    calls = 300
    lo, hi = [-0.5, -0.5, -pi], [0.5, 0.5, pi]
    text = """object tray { x: length, y: length, theta: angle, width: length, depth: length }
object other[4] { x: length, y: length, theta: angle, width: length, depth: length }
object item { width: length, depth: length }
parameter px in [-0.5, 0.5]: length
parameter py in [-0.5, 0.5]: length
parameter yaw in [-pi, pi]: angle
point spot = world + (px, py)
point place = spot turned yaw
shape tray = rectangle(tray.width, tray.depth) centred
shape other = rectangle(other.width, other.depth) centred
shape place = rectangle(item.width, item.depth) centred
"""

    def instance(self, rng):
        heading = rng.uniform(-pi, pi)
        x, y = rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1)
        others = []
        for _ in range(rng.randint(0, 4)):
            dx, dy = turned(rng.uniform(-0.35, 0.35), rng.uniform(-0.3, 0.3), heading)
            sizes = [rng.uniform(0.05, 0.15) for _ in range(2)]
            others.append([x + dx, y + dy, rng.uniform(-pi, pi)] + sizes)
        tray = [x, y, heading, rng.uniform(0.5, 0.8), rng.uniform(0.4, 0.7)]
        return tray + group(others, 4, 5) + [rng.uniform(0.05, 0.15) for _ in range(2)]

    def works(self, i, t):
        width, depth = i[25:27]
        if not is_in_rectangle(i[:3], i[3], i[4], corners(t, width, depth)):
            return False
        others = ((m[:3], m[3], m[4]) for m in members(i[5:25], 5))
        return not any(do_overlap((t, width, depth), other) for other in others)


class Satellite(Scenario):
    """A satellite sees another one: near enough, not in its way, and past others."""

    name = "satellite"
    calls = 300
    lo, hi = [0.0, 0.0], [1.0, 1.0]
    RADIUS, VIEW = 0.04, 0.35
    text = """object target { x: length, y: length }
object other[3] { x: length, y: length }
constant radius = 0.04: length
constant view = 0.35: length
parameter px in [0, 1]: length
parameter py in [0, 1]: length
point satellite = world + (px, py)
shape satellite = circle(radius)
shape target = circle(radius)
shape other = circle(radius)
"""

    def instance(self, rng):
        others = [[rng.uniform(0, 1), rng.uniform(0, 1)] for _ in range(rng.randint(1, 3))]
        return [rng.uniform(0.2, 0.8), rng.uniform(0.2, 0.8)] + group(others, 3, 2)

    def works(self, i, t):
        if not 2 * self.RADIUS <= math.dist(t, i[:2]) <= self.VIEW:
            return False
        return all(
            math.dist(t, (x, y)) >= 2 * self.RADIUS
            and from_segment([t, i[:2]], x, y) >= self.RADIUS
            for x, y in members(i[2:], 2)
        )


class Spray(Scenario):
    """A nozzle that turns freely hits a part: in its cone, neither too near nor too far."""

    name = "spray"
    calls = 300
    lo, hi = [-1.0, -1.0, -pi], [1.0, 1.0, pi]
    text = """object part { x: length, y: length }
constant cone = 0.4: angle
constant near = 0.2: length
constant far = 0.8: length
parameter px in [-1, 1]: length
parameter py in [-1, 1]: length
parameter yaw in [-pi, pi]: angle
point spot = world + (px, py)
point nozzle = spot turned yaw
"""

    def instance(self, rng):
        return [rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4)]

    def works(self, i, t):
        direction = math.atan2(i[1] - t[1], i[0] - t[0])
        return 0.2 <= math.dist(t[:2], i) <= 0.8 and abs(wrapped(direction - t[2])) <= 0.4


class Elbow(Scenario):
    """Two joints bring a hand to a ball, and the forearm past a post."""

    name = "elbow"
    calls = 300
    lo, hi = [-pi, -2.5], [pi, 2.5]
    UPPER, FORE = 0.5, 0.4
    text = """object base { x: length, y: length }
object ball { x: length, y: length, radius: length }
object post { x: length, y: length, radius: length }
constant upper = 0.5: length
constant fore = 0.4: length
parameter q1 in [-pi, pi]: angle
parameter q2 in [-2.5, 2.5]: angle
point shoulder = base turned q1
point elbow = shoulder + (upper, 0)
point forearm = elbow turned q2
point hand = forearm + (fore, 0)
shape forearm = segment(fore)
shape ball = circle(ball.radius)
shape post = circle(post.radius)
"""

    def instance(self, rng):
        base = [rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)]
        ball = turned(rng.uniform(0.3, 0.85), 0.0, rng.uniform(-pi, pi))
        post = turned(rng.uniform(0.3, 0.9), 0.0, rng.uniform(-pi, pi))
        there = [[base[0] + dx, base[1] + dy] for dx, dy in (ball, post)]
        return base + there[0] + [rng.uniform(0.1, 0.2)] + there[1] + [rng.uniform(0.05, 0.12)]

    def works(self, i, t):
        dx, dy = turned(self.UPPER, 0.0, t[0])
        elbow = (i[0] + dx, i[1] + dy)
        dx, dy = turned(self.FORE, 0.0, t[0] + t[1])
        hand = (elbow[0] + dx, elbow[1] + dy)
        return math.dist(hand, i[2:4]) <= i[4] and from_segment([elbow, hand], *i[5:7]) >= i[7]


class Door(Scenario):
    """How far a door is opened, and where a round robot stands before it."""

    name = "door"
    lo, hi = [0.0, 0.0], [pi / 2, 1.5]
    text = """object door { x: length, y: length, theta: angle, width: length }
object robot { radius: length }
parameter open in [0, 0.5 * pi]: angle
parameter ahead in [0, 1.5]: length
point leaf = door turned open
point stand = door + (0.5 * door.width, ahead)
shape leaf = segment(door.width)
shape stand = circle(robot.radius)
"""

    def instance(self, rng):
        return self.with_heading(rng, rng.uniform(-pi, pi))

    def aligned(self, rng):
        return self.with_heading(rng, rng.choice(QUARTERS))

    def with_heading(self, rng, heading):
        place = [rng.uniform(-1, 1), rng.uniform(-1, 1), heading]
        return place + [rng.uniform(0.7, 1.1), rng.uniform(0.2, 0.4)]

    def works(self, i, t):
        leaf = [(0.0, 0.0), turned(i[3], 0.0, t[0])]
        return from_segment(leaf, i[3] / 2, t[1]) >= i[4]


CLUTTER = [TiltedFingers, Kit, Satellite, Spray, Elbow, Door]
