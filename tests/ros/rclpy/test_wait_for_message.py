"""Humble takes the time to wait as the fourth word, later distributions only by its name: programs of both run here."""

import pytest
import rclpy
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import String

from coursekit.processes.session import Session


@pytest.mark.parametrize(("words", "named"), [((0.5,), {}), ((), {"time_to_wait": 0.5, "qos_profile": 5})])
def test_the_time_to_wait_is_taken_by_its_place_and_by_its_name(words, named):
    with Session(virtual=True).use() as session:
        rclpy.init()
        before = session.clock.steady()
        assert wait_for_message(String, rclpy.create_node("ears"), "silent", *words, **named) == (False, None)
        assert session.clock.steady() - before == 500_000_000
        rclpy.shutdown()
