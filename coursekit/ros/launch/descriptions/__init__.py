"""Descriptions of the objects of actions."""

from .executable import Executable

__all__ = ["Executable"]
