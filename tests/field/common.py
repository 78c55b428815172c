"""What our scenarios share: plain geometry to judge by, groups and the usual budget."""

import math

QUARTERS = [0.0, math.pi / 2, math.pi, -math.pi / 2]
ABSENT = math.nan  # each number of a member of a group that is not there


class Scenario:
    """What most have."""

    calls, instances = 250, 16


class Turned(Scenario):
    """Something whose heading is the third number of an instance."""

    def aligned(self, rng):
        instance = self.instance(rng)
        instance[2] = rng.choice(QUARTERS)
        return instance


def members(numbers, each):
    """The members of a group that are there, from its numbers."""
    groups = [numbers[k : k + each] for k in range(0, len(numbers), each)]
    return [group for group in groups if not math.isnan(group[0])]


def group(there, capacity, each):
    """The numbers of a group: the members that are there, then the absent ones."""
    absent = [ABSENT] * (each * (capacity - len(there)))
    return [number for member in there for number in member] + absent


def wrapped(angle):
    """The same angle from -pi to pi."""
    return (angle + math.pi) % (2 * math.pi) - math.pi


def turned(x, y, angle):
    """A vector after a turn."""
    c, s = math.cos(angle), math.sin(angle)
    return c * x - s * y, s * x + c * y


def seen_from(frame, x, y):
    """A point of the world in a frame (x, y, theta)."""
    return turned(x - frame[0], y - frame[1], -frame[2])


def corners(frame, width, depth):
    """The corners of a rectangle that is centred in a frame."""
    for u, v in [(1, 1), (-1, 1), (-1, -1), (1, -1)]:
        dx, dy = turned(u * width / 2, v * depth / 2, frame[2])
        yield frame[0] + dx, frame[1] + dy


def is_in_rectangle(frame, width, depth, points):
    """Whether all points are in a rectangle that is centred in a frame."""
    local = [seen_from(frame, x, y) for x, y in points]
    return all(abs(u) <= width / 2 and abs(v) <= depth / 2 for u, v in local)


def do_overlap(one, other):
    """Whether two rectangles (frame, width, depth) meet: no axis of theirs separates them."""
    both = [list(corners(*rectangle)) for rectangle in (one, other)]
    for heading in (frame[2] + turn for frame, _, _ in (one, other) for turn in (0.0, math.pi / 2)):
        along = [[turned(x, y, -heading)[0] for x, y in points] for points in both]
        if max(along[0]) < min(along[1]) or max(along[1]) < min(along[0]):
            return False
    return True


def from_rectangle(frame, width, depth, x, y):
    """How far a point is from such a rectangle; 0 inside."""
    u, v = seen_from(frame, x, y)
    return math.hypot(max(abs(u) - width / 2, 0.0), max(abs(v) - depth / 2, 0.0))


def from_segment(ends, x, y):
    """How far a point is from a straight line between two points."""
    (ax, ay), (bx, by) = ends
    dx, dy = bx - ax, by - ay
    share = ((x - ax) * dx + (y - ay) * dy) / max(dx * dx + dy * dy, 1e-12)
    share = min(max(share, 0.0), 1.0)
    return math.hypot(ax + share * dx - x, ay + share * dy - y)
