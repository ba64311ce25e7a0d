"""The reasons why joining a network can fail, in one sentence with the cure."""

from __future__ import annotations


class NoNetwork(RuntimeError):
    """The network was not joined; the text says why, and what to do."""
