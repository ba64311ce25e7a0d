"""Which ROS this is stands in the scripts of every kind of shell that can say it; one that cannot spoils no build."""

import pytest
from colcon_core.shell import ShellExtensionPoint

from coursekit.packages import colcon_distribution
from coursekit.packages.colcon_distribution import Distribution


class Writes(ShellExtensionPoint):
    """A shell with files that set a variable, as cmd's and dsv's."""

    def create_hook_set_value(self, env_hook_name, prefix_path, pkg_name, name, value):
        return prefix_path / f"{env_hook_name}={value}"


class Cannot(ShellExtensionPoint):
    """A shell without them, as colcon-powershell's, which is there on Windows."""


@pytest.fixture
def shells(monkeypatch):
    """The shells that colcon has, by their rank."""
    there: dict[int, dict[str, ShellExtensionPoint]] = {}
    monkeypatch.setattr(colcon_distribution, "get_shell_extensions", lambda: there)
    return there


def test_a_shell_that_cannot_set_a_variable_spoils_no_build(shells, tmp_path):
    shells.update({300: {"powershell": Cannot()}, 200: {"bat": Writes()}})
    hooks = Distribution().create_environment_hooks(tmp_path, "talks")
    assert [hook.name for hook in hooks] == ["ros_distro=humble", "ros_version=2", "ros_python_version=3"]


def test_a_shell_that_uses_the_scripts_of_others_is_not_asked(shells, tmp_path):
    shells.update({100: {"bash": Writes()}})
    assert Distribution().create_environment_hooks(tmp_path, "talks") == []
