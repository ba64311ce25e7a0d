"""The reasons why joining a network can fail, each in one sentence with the remedy."""

from __future__ import annotations


class NoNetwork(RuntimeError):
    """The network was not joined; the message gives the reason and the remedy."""
