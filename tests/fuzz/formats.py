"""Every format that is read from strangers."""

from __future__ import annotations

from . import classes, maps, messages, packages, robots, simulated

FORMATS = (*robots.FORMATS, *maps.FORMATS, *messages.FORMATS, *packages.FORMATS, *classes.FORMATS, *simulated.FORMATS)
