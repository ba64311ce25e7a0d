"""`ros2` commands know the interfaces of the workspace that they are started in, as they are at that moment."""

import pytest

from coursekit.cli.parser import run
from coursekit.interfaces import find
from coursekit.processes.session import Session

FACE = "from coursekit.interfaces.face import expose\n__getattr__, __dir__, __all__ = expose(__name__, __file__)\n"


@pytest.fixture
def install(tmp_path, monkeypatch):
    """An install folder with the message own_things/msg/Box, and a way to change it."""
    monkeypatch.setattr(find, "_remembered", [])  # other tests do not search here
    share = tmp_path / "share"
    for kind, text in (("packages", ""), ("rosidl_interfaces", "msg/Box.msg\n")):
        (share / "ament_index/resource_index" / kind).mkdir(parents=True)
        (share / "ament_index/resource_index" / kind / "own_things").write_text(text)
    (share / "own_things/msg").mkdir(parents=True)
    (share / "own_things/package.xml").write_text("<package><name>own_things</name></package>")
    site = tmp_path / "site"
    (site / "own_things/msg").mkdir(parents=True)
    (site / "own_things/__init__.py").touch()
    (site / "own_things/msg/__init__.py").write_text(FACE)
    (site / "share").symlink_to(share)
    env = {"AMENT_PREFIX_PATH": str(tmp_path), "PYTHONPATH": str(site)}
    return (share / "own_things/msg/Box.msg").write_text, env


def outcome(session, env, *argv):
    process = session.start(lambda: run(argv), name="ros2", argv=list(argv), env=env)
    assert process.wait(10) == 0, process.output
    return process.output


def test_a_type_of_the_workspace_is_known_and_read_again_after_a_build(install):
    define, env = install
    with Session(virtual=True).use() as session:
        define("int32 weight\n")
        assert "weight: 0" in outcome(session, env, "interface", "proto", "own_things/msg/Box")
        define("string label\nint32 weight\n")
        assert "label: ''" in outcome(session, env, "interface", "proto", "own_things/msg/Box")

