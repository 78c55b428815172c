"""What can be said of the controllers of Obstruction2D: a block, its target, others in the way."""

ENVIRONMENT = "kinder/Obstruction2D-o{}-v0"
COUNTED = "num_obstructions"
VARIANTS = [0, 1, 2, 4]
TRAINING = [0, 1]
REFUSED = 0
LEARNING = {
    "learner": {"calls": 200, "forms": 8192},
    "situations": 32,
    "states": 32,
    "way": 4,
}

WORLD = """
constant room.width     = 1.618: length
constant room.height    = 1:     length
constant table.height   = 0.1:   length
constant robot.radius   = 0.1:   length
constant gripper.height = 0.07:  length
constant gripper.width  = 0.01:  length
constant arm.length     = 0.2:   length
object crv_robot { x: length, y: length }
object rectangle { x: length, y: length, width: length, height: length }            # the block
object other_rectangle[6] { x: length, y: length, width: length, height: length }   # the others
point room = world + (0.5 * room.width, 0.5 * room.height)
shape room = rectangle(room.width, room.height) centred
shape other_rectangle = rectangle(other_rectangle.width, other_rectangle.height)
"""
PICK = WORLD + """
parameter offset in [-0.035, 0.235]: length
# Above the block: the gripper on it, and the robot an arm higher.
point gripper = world + (rectangle.x + offset, table.height + rectangle.height + 0.5 * gripper.width)
point base    = gripper + (0, arm.length)
shape rectangle = rectangle(rectangle.width, rectangle.height)
shape gripper = rectangle(gripper.height, gripper.width) centred
shape base    = circle(robot.radius)
shape robot   = base + gripper                  # they move as one
relate robot, gripper, rectangle, other_rectangle, room
"""
# The robot drives to x, with the block where it was picked, and lowers it onto the table.
MOVE = WORLD + """
parameter x in [0, 1.618]: length
point spot    = world + (x + rectangle.x - crv_robot.x, table.height)
point gripper = world + (x, table.height + rectangle.height + 0.5 * gripper.width)
point base    = gripper + (0, arm.length)
shape spot    = rectangle(rectangle.width, rectangle.height)
shape gripper = rectangle(gripper.height, gripper.width) centred
shape base    = circle(robot.radius)
shape robot   = base + gripper + spot           # they move as one
"""
PLACE_ON_TABLE = MOVE + """
relate robot, spot, other_rectangle, room
"""
PLACE_ON_TARGET = MOVE + """
object target_surface { x: length, y: length, width: length, height: length }
shape target_surface = rectangle(target_surface.width, target_surface.height)
relate robot, spot, target_surface, other_rectangle, room
"""
TEXTS = {
    "PickController": PICK,
    "PlaceOnTableController": PLACE_ON_TABLE,
    "PlaceOnTargetController": PLACE_ON_TARGET,
}
