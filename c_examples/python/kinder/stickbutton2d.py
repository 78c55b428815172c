"""What can be said of the controllers of StickButton2D: a robot, a stick, buttons on and off a table."""

ENVIRONMENT = "kinder/StickButton2D-b{}-v0"
COUNTED = "num_buttons"
VARIANTS = [1, 2, 3, 5, 10]
TRAINING = [2]
REFUSED = None
LEARNING = {
    "learner": {"calls": 240, "forms": 8192},
    "situations": 60,
    "states": 110,
    "way": 3,
}

WORLD = """
constant room.width     = 3.5:  length
constant floor.height   = 1.25: length         # the rest of the room is a table
constant robot.radius   = 0.1:  length
constant stick.width    = 0.05: length
constant stick.height   = 1.25: length
object crv_robot { x: length, y: length }
object rectangle { x: length, y: length }      # the stick
point floor = world + (0, 0)
shape floor     = rectangle(room.width, floor.height)
shape crv_robot = circle(robot.radius)
shape rectangle = rectangle(stick.width, stick.height)
"""
PRESS = WORLD + """
object circle { x: length, y: length }         # the button
point there = world + (circle.x, circle.y)     # where the robot drives, straight
shape there = circle(robot.radius)
feature passage = clear(sweep(crv_robot, there), rectangle): length
# How far from there it comes to the end of the floor; below zero.
feature short = inside_y(there, floor) * dist(there, crv_robot) / dist_y(there, crv_robot): length
relate there, floor, rectangle
"""
PICK = WORLD + """
constant gripper.width  = 0.01: length
constant gripper.height = 0.07: length
constant grasps         = stick.width + 2 * gripper.height: length   # the line of all grasps
"""
LEFT = PICK + """
parameter ratio in [0, 0.36842]
parameter arm   in [0.1, 0.2]: length
point base = rectangle + (-arm - gripper.width, gripper.height - ratio * grasps)
shape base = circle(robot.radius)
relate base, floor, crv_robot
"""
BOTTOM = PICK + """
parameter ratio in [0.36843, 0.63157]
parameter arm   in [0.1, 0.2]: length
point base = rectangle + (ratio * grasps - gripper.height, -arm - gripper.width)
shape base = circle(robot.radius)
relate base, floor, crv_robot
"""
RIGHT = PICK + """
parameter ratio in [0.63158, 1]
parameter arm   in [0.1, 0.2]: length
point base = rectangle + (stick.width + arm + gripper.width, ratio * grasps - gripper.height - stick.width)
shape base = circle(robot.radius)
relate base, floor, crv_robot
"""
STICK_PRESS = WORLD + """
object circle { x: length, y: length }         # the button
# Robot and stick move, straight, so that the far corner of the stick comes to the button.
point there = crv_robot + (circle.x - rectangle.x - stick.width, circle.y - rectangle.y - stick.height)
shape there = circle(robot.radius)
# How far from the button they come to the end of the floor; below zero.
feature short = inside(there, floor) * dist_x(there, crv_robot) / dist_y(there, crv_robot): length
relate there, floor
"""
TEXTS = {
    "RobotPressButtonController": PRESS,
    "PickStickController": {"left": LEFT, "bottom": BOTTOM, "right": RIGHT},
    "PlaceStickController": WORLD,
    "StickPressButtonController": STICK_PRESS,
}
