"""Scenarios whose texts say with shapes what is where, and nothing else.

No helper point carries a part of the answer.
"""

import math
from math import pi

from common import QUARTERS, Scenario, Turned
from common import corners, from_rectangle, from_segment, is_in_rectangle, seen_from, turned
from common import group, members


class Ledge(Scenario):
    """A jar has to stand on a ledge with all of its width."""

    name = "ledge"
    lo, hi = [0.0], [8.0]
    text = """object ledge { x: length, y: length, width: length }
object jar { width: length }
constant ledge.depth = 0.4: length
constant jar.depth = 0.2: length
parameter px in [0, 8]: length
point place = world + (px, ledge.y)
shape ledge = rectangle(ledge.width, ledge.depth) centred
shape place = rectangle(jar.width, jar.depth) centred
"""

    def instance(self, rng):
        return [rng.uniform(2, 6), rng.uniform(-1, 1), rng.uniform(1.5, 4), rng.uniform(0.2, 1)]

    def works(self, i, t):
        return abs(t[0] - i[0]) <= (i[2] - i[3]) / 2


class Crate(Scenario):
    """A box in a crate that is parallel to the axes."""

    name = "crate"
    lo, hi = [-0.5, -0.5], [0.5, 0.5]
    text = """object crate { x: length, y: length, width: length, depth: length }
object box { width: length, depth: length }
parameter px in [-0.5, 0.5]: length
parameter py in [-0.5, 0.5]: length
point place = world + (px, py)
shape crate = rectangle(crate.width, crate.depth) centred
shape place = rectangle(box.width, box.depth) centred
"""

    def instance(self, rng):
        sizes = [rng.uniform(a, b) for a, b in [(0.3, 0.6), (0.3, 0.6), (0.05, 0.2), (0.05, 0.2)]]
        return [rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)] + sizes

    def works(self, i, t):
        return is_in_rectangle([i[0], i[1], 0.0], i[2] - i[4], i[3] - i[5], [t])


class TurnedCrate(Turned):
    """The crate at any heading, the box parallel to it."""

    name = "turned_crate"
    lo, hi = [-0.5, -0.5], [0.5, 0.5]
    text = """object crate { x: length, y: length, theta: angle, width: length, depth: length }
object box { width: length, depth: length }
parameter px in [-0.5, 0.5]: length
parameter py in [-0.5, 0.5]: length
point spot  = world + (px, py)
point place = spot turned crate.theta
shape crate = rectangle(crate.width, crate.depth) centred
shape place = rectangle(box.width, box.depth) centred
"""

    def instance(self, rng):
        x, y, *sizes = Crate().instance(rng)
        return [x, y, rng.uniform(-pi, pi)] + sizes

    def works(self, i, t):
        return is_in_rectangle(i[:3], i[3] - i[5], i[4] - i[6], [t])


class CrateYaw(Turned):
    """Where in the crate and with which yaw."""

    name = "crate_yaw"
    calls = 300
    lo, hi = [-0.5, -0.5, -pi / 2], [0.5, 0.5, pi / 2]
    text = """object crate { x: length, y: length, theta: angle, width: length, depth: length }
object box { width: length, depth: length }
parameter px in [-0.5, 0.5]: length
parameter py in [-0.5, 0.5]: length
parameter yaw in [-0.5 * pi, 0.5 * pi]: angle
point spot  = world + (px, py)
point place = spot turned yaw
shape crate = rectangle(crate.width, crate.depth) centred
shape place = rectangle(box.width, box.depth) centred
"""

    def instance(self, rng):
        return TurnedCrate().instance(rng)

    def works(self, i, t):
        return is_in_rectangle(i[:3], i[3], i[4], corners(t, i[5], i[6]))


class Pile(Turned):
    """A brick on another one that lies at any heading: its centre must be above it."""

    name = "pile"
    lo, hi = [-0.12, -0.12], [0.12, 0.12]
    text = """object lower { x: length, y: length, theta: angle, width: length, depth: length }
object upper { width: length, depth: length }
parameter dx in [-0.12, 0.12]: length
parameter dy in [-0.12, 0.12]: length
point place = world + (lower.x + dx, lower.y + dy)
shape lower = rectangle(lower.width, lower.depth) centred
shape place = rectangle(upper.width, upper.depth) centred
"""

    def instance(self, rng):
        sizes = [rng.uniform(0.05, 0.16) for _ in range(4)]
        return [rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), rng.uniform(-pi, pi)] + sizes

    def works(self, i, t):
        return is_in_rectangle(i[:3], i[3], i[4], [(i[0] + t[0], i[1] + t[1])])


class Pillars(Scenario):
    """A round robot stands clear of up to six pillars, each with its own radius."""

    name = "pillars"
    lo, hi = [0.0, 0.0], [2.0, 2.0]
    RADIUS = 0.1
    text = """object pillar[6] { x: length, y: length, radius: length }
constant robot.radius = 0.1: length
parameter px in [0, 2]: length
parameter py in [0, 2]: length
point robot = world + (px, py)
shape robot  = circle(robot.radius)
shape pillar = circle(pillar.radius)
"""

    def instance(self, rng):
        there = [
            [rng.uniform(0, 2), rng.uniform(0, 2), rng.uniform(0.05, 0.3)]
            for _ in range(rng.randint(1, 6))
        ]
        return group(there, 6, 3)

    def works(self, i, t):
        return all(math.dist(t, (x, y)) >= r + self.RADIUS for x, y, r in members(i, 3))


class Fingers(Scenario):
    """Where along a bar two fingers close, between up to three cans of their own sizes.

    The bar has to fill the width of the fingers. They are one body, because they are rigid.
    """

    name = "fingers"
    lo, hi = [-0.15], [0.15]
    THICK, WIDE, OPEN = 0.012, 0.02, 0.09
    text = """object bar { x: length, y: length, theta: angle, length: length, width: length }
type can { x: length, y: length, radius: length }
object can[3]: can
constant finger.thick = 0.012: length
constant finger.width = 0.02: length
constant opening = 0.09: length
parameter s in [-0.15, 0.15]: length
point grip  = bar + (s, 0)
point left  = grip + (0, 0.5 * opening + 0.5 * finger.thick)
point right = grip + (0, -0.5 * opening - 0.5 * finger.thick)
shape bar    = rectangle(bar.length, bar.width) centred
shape can    = circle(can.radius)
shape left   = rectangle(finger.width, finger.thick) centred
shape right  = rectangle(finger.width, finger.thick) centred
shape fingers = left + right
"""

    def instance(self, rng):
        return self.with_bar(rng, rng.uniform(-pi, pi))

    def aligned(self, rng):
        return self.with_bar(rng, rng.choice(QUARTERS))

    def with_bar(self, rng, heading):
        x, y = rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)
        length, width = rng.uniform(0.12, 0.25), rng.uniform(0.02, 0.06)
        cans, count = [], rng.randint(0, 3)
        while len(cans) < count:
            u, v = rng.uniform(-0.16, 0.16), rng.uniform(-0.1, 0.1)
            radius = rng.uniform(0.01, 0.025)
            if from_rectangle([0, 0, 0], length, width, u, v) < radius + 0.003:
                continue
            dx, dy = turned(u, v, heading)
            cans.append([x + dx, y + dy, radius])
        return [x, y, heading, length, width] + group(cans, 3, 3)

    def works(self, i, t):
        if abs(t[0]) > (i[3] - self.WIDE) / 2:
            return False
        for side in [1, -1]:
            dx, dy = turned(t[0], side * (self.OPEN + self.THICK) / 2, i[2])
            finger = [i[0] + dx, i[1] + dy, i[2]]
            for x, y, radius in members(i[5:], 3):
                if from_rectangle(finger, self.WIDE, self.THICK, x, y) < radius:
                    return False
        return True


class Camera(Scenario):
    """A camera on a ring sees a sign: in range, in front of it, and past up to two posts."""

    name = "camera"
    calls = 300
    lo, hi = [0.1, -pi], [1.2, pi]
    text = """object sign { x: length, y: length, theta: angle }
type post { x: length, y: length, radius: length }
object post[2]: post
constant near = 0.3: length
constant far = 0.9: length
parameter d in [0.1, 1.2]: length
parameter az in [-pi, pi]: angle
point ray = sign turned az
point camera = ray + (d, 0)
shape post = circle(post.radius)
"""

    def instance(self, rng):
        x, y, heading = rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2), rng.uniform(-pi, pi)
        posts = []
        for _ in range(rng.randint(0, 2)):
            dx, dy = turned(rng.uniform(0.2, 0.4), 0.0, heading + rng.uniform(-1.3, 1.3))
            posts.append([x + dx, y + dy, rng.uniform(0.03, 0.08)])
        return [x, y, heading] + group(posts, 2, 3)

    def works(self, i, t):
        if not 0.3 <= t[0] <= 0.9 or abs(t[1]) > pi / 3:
            return False
        dx, dy = turned(t[0], 0.0, i[2] + t[1])
        line = [(i[0], i[1]), (i[0] + dx, i[1] + dy)]
        return all(from_segment(line, x, y) >= radius for x, y, radius in members(i[3:], 3))


class Corridor(Scenario):
    """A round robot drives straight to a place, past up to three posts."""

    name = "corridor"
    calls = 300
    lo, hi = [-1.0, -1.0], [1.0, 1.0]
    RADIUS = 0.08
    text = """object robot { x: length, y: length }
type post { x: length, y: length, radius: length }
object post[3]: post
constant robot.radius = 0.08: length
parameter px in [-1, 1]: length
parameter py in [-1, 1]: length
point place = world + (px, py)
shape robot = circle(robot.radius)
shape place = circle(robot.radius)
shape post  = circle(post.radius)
"""

    def instance(self, rng):
        robot, posts, count = [rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)], [], rng.randint(1, 3)
        while len(posts) < count:
            post = [rng.uniform(-0.8, 0.8), rng.uniform(-0.8, 0.8), rng.uniform(0.05, 0.15)]
            if math.dist(robot, post[:2]) >= post[2] + self.RADIUS + 0.05:
                posts.append(post)
        return robot + group(posts, 3, 3)

    def works(self, i, t):
        line = [i[:2], t]
        return all(from_segment(line, x, y) >= r + self.RADIUS for x, y, r in members(i[2:], 3))


class Poke(Scenario):
    """A stick that keeps its heading reaches a button, while the hand stays in its zone.

    The stick and the button have to touch: contact is wanted.
    """

    name = "poke"
    lo, hi = [-2.0, 0.0], [2.0, 2.0]
    LENGTH, WIDTH, HAND = 1.2, 0.1, 0.15
    text = """object tool { theta: angle }
object button { x: length, y: length, radius: length }
constant stick.length = 1.2: length
constant stick.width = 0.1: length
constant hand.radius = 0.15: length
parameter px in [-2, 2]: length
parameter py in [0, 2]: length
point hand  = world + (px, py)
point stick = hand turned tool.theta + (0.5 * stick.length, 0)
point zone  = world + (0, 0.75)
shape hand   = circle(hand.radius)
shape stick  = rectangle(stick.length, stick.width) centred
shape button = circle(button.radius)
shape zone   = rectangle(4, 1.5) centred
"""

    def instance(self, rng):
        return self.with_heading(rng, rng.uniform(0.1 * pi, 0.9 * pi))

    def aligned(self, rng):
        return self.with_heading(rng, pi / 2)

    def with_heading(self, rng, heading):
        return [heading, rng.uniform(-1, 1), rng.uniform(1, 1.8), rng.uniform(0.1, 0.25)]

    def works(self, i, t):
        if abs(t[0]) > 2 - self.HAND or abs(t[1] - 0.75) > 0.75 - self.HAND:
            return False
        dx, dy = turned(self.LENGTH / 2, 0.0, i[0])
        stick = [t[0] + dx, t[1] + dy, i[0]]
        return from_rectangle(stick, self.LENGTH, self.WIDTH, i[1], i[2]) <= i[3]


class Shelf(Scenario):
    """A parcel goes into a compartment of a shelf: in space, at the heading of the shelf."""

    name = "shelf"
    calls = 300
    lo, hi = [-0.3, -0.3, 0.0], [0.3, 0.3, 0.6]
    text = """object room { x: length, y: length, z: length, theta: angle,
              width: length, depth: length, height: length }
object parcel { width: length, depth: length, height: length }
parameter px in [-0.3, 0.3]: length
parameter py in [-0.3, 0.3]: length
parameter pz in [0, 0.6]: length
point spot  = world + (px, py, pz)
point place = spot turned room.theta
shape room  = box(room.width, room.depth, room.height) centred
shape place = box(parcel.width, parcel.depth, parcel.height) centred
"""

    def instance(self, rng):
        return self.with_heading(rng, rng.uniform(-pi, pi))

    def aligned(self, rng):
        return self.with_heading(rng, rng.choice(QUARTERS))

    def with_heading(self, rng, heading):
        place = [rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), rng.uniform(0.25, 0.35), heading]
        rooms = [rng.uniform(0.3, 0.5) for _ in range(3)]
        return place + rooms + [rng.uniform(0.04, 0.12) for _ in range(3)]

    def works(self, i, t):
        u, v = seen_from([i[0], i[1], i[3]], t[0], t[1])
        off = [u, v, t[2] - i[2]]
        return all(abs(off[k]) <= (i[4 + k] - i[7 + k]) / 2 for k in range(3))


BODIES = [
    Ledge,
    Crate,
    TurnedCrate,
    CrateYaw,
    Pile,
    Pillars,
    Fingers,
    Camera,
    Corridor,
    Poke,
    Shelf,
]
