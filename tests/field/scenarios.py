"""Actions as a robot engineer would describe them, and the truth about each.

README.md tells what a scenario is.
"""

from bodies import BODIES
from plain import PLAIN

SCENARIOS = BODIES + PLAIN
