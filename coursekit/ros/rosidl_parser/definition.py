"""The types in a message's SLOT_TYPES; see coursekit.interfaces.definition."""

from coursekit.interfaces.definition import *  # noqa: F403
