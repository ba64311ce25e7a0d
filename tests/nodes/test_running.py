"""Nodes of the underlay while they start."""

import time

from coursekit.nodes.gazebo.gzserver import simulate
from coursekit.nodes.running import run as run_node


def _slow():
    time.sleep(100.0)


def test_ctrl_c_ends_a_node_that_is_still_made_without_a_word(session):
    """As C++ does: a launch that fails interrupts what has just begun."""
    for main in (lambda: run_node(_slow), _simulated):
        process = session.start(main, name="slow")
        session.clock.sleep(0.5)
        process.interrupt()
        assert process.wait(2.0) == 0 and process.output == ""


def _simulated():
    import rclpy

    rclpy.init()
    return simulate(_slow, ())
