"""Classes are found by name and follow their definitions."""

import os
import sys

import pytest

from coursekit.interfaces import (
    InterfaceError,
    UnknownInterface,
    definition_text,
    find,
    find_definition,
    interface_of,
    load,
)


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A folder share/my_pkg in a sourced prefix; returns a function that writes a definition."""
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    (tmp_path / "share" / "my_pkg").mkdir(parents=True)
    (tmp_path / "share" / "my_pkg" / "package.xml").write_text("<package/>")

    def write(name, text):
        path = tmp_path / "share" / "my_pkg" / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        status = path.stat()
        write.times += 1
        os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns + write.times))
        return path

    write.times = 0
    return write


def test_a_class_is_made_once():
    assert load("std_msgs/String") is load("std_msgs/msg/String")


def test_a_changed_definition_gives_a_new_class_and_new_classes_above_it(package):
    package("msg/Inner.msg", "int8 a")
    package("msg/Outer.msg", "Inner inner")
    outer = load("my_pkg/Outer")
    assert outer().inner.a == 0 and load("my_pkg/Outer") is outer
    package("msg/Inner.msg", "int8 a\nint8 b")
    assert load("my_pkg/Outer") is not outer
    assert load("my_pkg/Outer")().inner.b == 0


def test_an_unknown_field_type_names_the_line(package):
    path = package("msg/Outer.msg", "int8 a\nInner inner")
    with pytest.raises(InterfaceError) as caught:
        load("my_pkg/Outer")
    assert (
        caught.value.line == 2 and caught.value.file == str(path) and "my_pkg/msg/Inner" in str(caught.value)
    )


def test_a_message_cannot_contain_itself(package):
    package("msg/A.msg", "B b")
    package("msg/B.msg", "A[] a")
    with pytest.raises(InterfaceError, match="contains itself"):
        load("my_pkg/A")


def test_a_message_may_bear_the_name_of_one_it_holds(package):
    package("msg/Pose.msg", "geometry_msgs/Pose pose")
    assert load("my_pkg/Pose")().pose.orientation.w == 1.0


def test_a_sourced_package_hides_one_of_the_underlay(package, tmp_path):
    (tmp_path / "share" / "std_msgs" / "msg").mkdir(parents=True)
    (tmp_path / "share" / "std_msgs" / "msg" / "String.msg").write_text("string other\n")
    assert find_definition("std_msgs/String").is_relative_to(tmp_path)


def test_an_unknown_name_gets_hints():
    with pytest.raises(UnknownInterface, match=r"did you mean std_msgs/msg/String"):
        load("std_msgs/msg/Strin")
    with pytest.raises(UnknownInterface):
        load("String")


def test_definitions_can_be_read():
    assert definition_text("geometry_msgs/msg/Twist").endswith("Vector3  linear\nVector3  angular\n")
    assert interface_of("std_srvs/srv/Trigger").response.fields[1].name == "message"


def test_requests_can_be_loaded_by_name():
    service = load("std_srvs/srv/Trigger")
    assert load("std_srvs/srv/Trigger_Request") is service.Request
    assert (
        load("test_msgs/action/Fibonacci_SendGoal_Request")
        is load("test_msgs/action/Fibonacci").Impl.SendGoalService.Request
    )


def test_a_package_on_the_python_path_is_found_without_sourcing(tmp_path, monkeypatch):
    site = tmp_path / "lib" / "site-packages"
    for folder in ("share/lonely_pkg/msg", "lib/site-packages/lonely_pkg/msg"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "share/lonely_pkg/package.xml").write_text("<package/>")
    (tmp_path / "share/lonely_pkg/msg/One.msg").write_text("int8 a 1\n")
    face = "from coursekit.interfaces.face import expose\n"
    face += "__getattr__, __dir__, __all__ = expose(__name__, __file__)\n"
    (site / "lonely_pkg" / "__init__.py").write_text("")
    (site / "lonely_pkg" / "msg" / "__init__.py").write_text(face)
    monkeypatch.syspath_prepend(str(site))
    monkeypatch.setattr(find, "_remembered", [])
    from lonely_pkg.msg import One

    assert One().a == 1
    sys.modules.pop("lonely_pkg.msg")
