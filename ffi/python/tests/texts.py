"""What the tests share: an action whose truth is known, and how it is tried."""

import math

DOMAIN = """
object stick  { x: length, y: length, theta: angle }
constant zone.top     = 3.0: length
constant stick.width  = 3.0: length
constant robot.radius = 0.1: length
parameter mu in [0, 1]   # parameter nu in [0, 1] is none
point grasp = stick + (mu * stick.width, 0)
"""
TRUTH = "grasp.y <= zone.top - robot.radius"
INSTANCES = [[2.0, 0.7, 1.57], [5.0, 1.1, 1.57], [7.5, 1.5, 1.57], [4.0, 0.9, 1.57]]
PLANE = "object cup { x: length, y: length }\nparameter u in [0, 1]\nparameter v in [0, 1]\n"


def try_grasp(instance, theta):
    """Whether the robot stays in its zone."""
    return instance[1] + theta[0] * 3.0 * math.sin(instance[2]) <= 2.9
