"""Each module of rclpy lends the names that Humble's has because it uses them, and no other."""

import importlib

import pytest
from rclpy._lent import _LENT


@pytest.mark.parametrize("module", _LENT)
def test_every_name_of_a_table_is_there(module: str) -> None:
    for name in _LENT[module].split():
        assert getattr(importlib.import_module(module), name) is not None


@pytest.mark.parametrize(("module", "name"), [("rclpy.publisher", "SingleThreadedExecutor"), ("rclpy.service", "Rate")])
def test_what_a_robot_would_refuse_is_refused(module: str, name: str) -> None:
    with pytest.raises(AttributeError, match=f"module '{module}' has no attribute '{name}'"):
        getattr(importlib.import_module(module), name)
