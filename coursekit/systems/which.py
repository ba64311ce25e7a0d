"""Which system this is."""

from __future__ import annotations

import os
import sys

WINDOWS = os.name == "nt"
"""Read it as `which.WINDOWS`: tests set it, to see on Linux what happens there."""
MAC = sys.platform == "darwin"
"""Likewise: `which.MAC`."""
