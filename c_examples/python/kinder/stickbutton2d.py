"""What can be said of the controllers of StickButton2D: a robot, a stick, buttons on and off a table."""

ENVIRONMENT = "kinder/StickButton2D-b{}-v0"
COUNTED = "num_buttons"
VARIANTS = [1, 2, 3, 5]
TRAINING = [2]
REFUSED = None
LEARNING = {
    "learner": {"calls": 100, "forms": 8192},
    "situations": 20,
    "states": 120,
    "way": 3,
}

WORLD = """
constant room.width     = 3.5:  length
constant room.height    = 2.5:  length
constant table.y        = 1.25: length
constant robot.radius   = 0.1:  length
constant stick.width    = 0.05: length
constant stick.height   = 1.25: length
object crv_robot { x: length, y: length }
object rectangle { x: length, y: length }      # the stick
point room  = world + (0.5 * room.width, 0.5 * room.height)
point table = world + (0, table.y)
shape room      = rectangle(room.width, room.height) centred
shape table     = rectangle(room.width, table.y)
shape crv_robot = circle(robot.radius)
shape rectangle = rectangle(stick.width, stick.height)
"""
PRESS = WORLD + """
object circle { x: length, y: length }         # the button
point there = world + (circle.x, circle.y)     # where the robot drives
shape there = circle(robot.radius)
feature way = clear(sweep(crv_robot, there), rectangle): length
relate there, table, room, rectangle
"""
PICK = WORLD + """
constant gripper.width  = 0.01: length
constant gripper.height = 0.07: length
constant grasps.length  = stick.width + 2 * gripper.height: length   # of all grasps
"""
LEFT = PICK + """
parameter ratio in [0, 0.36842]
parameter arm   in [0.1, 0.2]: length
point base = rectangle + (-arm - gripper.width, gripper.height - ratio * grasps.length)
shape base = circle(robot.radius)
relate base, room, table, crv_robot
"""
BOTTOM = PICK + """
parameter ratio in [0.36843, 0.63157]
parameter arm   in [0.1, 0.2]: length
point base = rectangle + (ratio * grasps.length - gripper.height, -arm - gripper.width)
shape base = circle(robot.radius)
relate base, room, table, crv_robot
"""
RIGHT = PICK + """
parameter ratio in [0.63158, 1]
parameter arm   in [0.1, 0.2]: length
point base = rectangle + (stick.width + arm + gripper.width, ratio * grasps.length - gripper.height - stick.width)
shape base = circle(robot.radius)
relate base, room, table, crv_robot
"""
STICK_PRESS = WORLD + """
object circle { x: length, y: length }         # the button
# Robot and stick move so that the far corner of the stick comes to the button.
point there = crv_robot + (circle.x - rectangle.x - stick.width, circle.y - rectangle.y - stick.height)
point held  = world + (circle.x - stick.width, circle.y - stick.height)
shape there = circle(robot.radius)
shape held  = rectangle(stick.width, stick.height)
shape robot = there + held                     # they move as one
relate robot, there, room, table
"""
TEXTS = {
    "RobotPressButtonController": PRESS,
    "PickStickController": {"left": LEFT, "bottom": BOTTOM, "right": RIGHT},
    "StickPressButtonController": STICK_PRESS,
}
