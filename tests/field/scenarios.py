"""Actions as a robot engineer would describe them, and the truth about each.

README.md tells what a scenario is.
"""

from bodies import BODIES
from clutter import CLUTTER
from laws import LAWS
from plain import PLAIN

SCENARIOS = BODIES + CLUTTER + PLAIN + LAWS
