"""Actions of launch tests."""

from .gtest import GTest
from .pytest import PyTest
from .ready import ReadyToTest

__all__ = ["GTest", "PyTest", "ReadyToTest"]
