"""turtle_tf2_py: its modules are imported, and its programs run, under the names that the tf2 pages use."""

import importlib

import pytest

from coursekit.processes.executables import find

MODULES = {
    "dynamic_frame_tf2_broadcaster": "DynamicFrameBroadcaster",
    "fixed_frame_tf2_broadcaster": "FixedFrameBroadcaster",
    "static_turtle_tf2_broadcaster": "StaticFramePublisher",
    "turtle_tf2_broadcaster": "FramePublisher",
    "turtle_tf2_listener": "FrameListener",
    "turtle_tf2_message_broadcaster": "PointPublisher",
}


@pytest.mark.parametrize("name", MODULES)
def test_each_program_is_a_module_with_its_node_and_main(name):
    module = importlib.import_module(f"turtle_tf2_py.{name}")
    assert callable(module.main) and isinstance(getattr(module, MODULES[name]), type)
    assert find("turtle_tf2_py", name).name == name


def test_a_static_frame_from_the_command_line_is_in_the_tree(session, run, ros2):
    process = run("turtle_tf2_py", "static_turtle_tf2_broadcaster", "mystaticturtle", "0", "0", "1", "0", "0", "0")
    session.clock.sleep(0.5)
    text = ros2("topic", "echo", "--once", "--qos-durability", "transient_local", "/tf_static")
    assert "frame_id: world\n" in text and "child_frame_id: mystaticturtle\n" in text and "z: 1.0\n" in text
    assert process.exit_code is None
