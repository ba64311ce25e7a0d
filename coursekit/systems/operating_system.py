"""The operating system of this computer."""

from __future__ import annotations

import os
import sys

WINDOWS = os.name == "nt"
"""Read it as `operating_system.WINDOWS`: tests set it to check Windows' behaviour on Linux."""
MAC = sys.platform == "darwin"
"""Read it as `operating_system.MAC`, likewise."""
