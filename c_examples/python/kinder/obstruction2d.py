"""What can be said of the controllers of Obstruction2D: a block, its target, others in the way."""

ENVIRONMENT = "kinder/Obstruction2D-o{}-v0"
COUNTED = "num_obstructions"
VARIANTS = [0, 1, 2, 4]
TRAINING = [0, 1]
LEARNING = {"learner": {"calls": 200}, "situations": 48, "way": 6}

WORLD = """
constant room.width     = 1.618: length
constant table.height   = 0.1:   length
constant robot.radius   = 0.1:   length
constant gripper.height = 0.07:  length
constant gripper.width  = 0.01:  length
constant arm.length     = 0.2:   length
object crv_robot { x: length, y: length }
object rectangle { x: length, y: length, width: length, height: length }            # the block
object other_rectangle[6] { x: length, y: length, width: length, height: length }   # the others
point wall.left  = world + (0, 0)
point wall.right = world + (room.width, 0)
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
"""
PLACE = WORLD + """
object target_surface { x: length, y: length, width: length, height: length }
parameter x in [0, 1.618]: length
# The robot drives to x, with the block where it was picked, and lowers it onto the table.
point spot    = world + (x + rectangle.x - crv_robot.x, table.height)
point gripper = world + (x, table.height + rectangle.height + 0.5 * gripper.width)
point base    = gripper + (0, arm.length)
shape spot    = rectangle(rectangle.width, rectangle.height)
shape gripper = rectangle(gripper.height, gripper.width) centred
shape base    = circle(robot.radius)
shape target_surface = rectangle(target_surface.width, target_surface.height)
"""
TEXTS = {
    "PickController": PICK,
    "PlaceOnTableController": PLACE,
    "PlaceOnTargetController": PLACE,
}
