import threading
import time

import pytest
from rclpy.qos import QoSProfile
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import String


@pytest.mark.parametrize("qos", [1, QoSProfile(depth=5)])
def test_a_message_is_waited_for(world, qos):
    talker, listener = world.node("talker"), world.node("listener", spin=False)
    publisher = talker.create_publisher(String, "chatter", 10)
    stop = threading.Event()

    def talk():
        while not stop.wait(0.02):
            publisher.publish(String(data="hello"))

    thread = threading.Thread(target=talk, daemon=True)
    thread.start()
    found, message = wait_for_message(String, listener, "chatter", qos_profile=qos, time_to_wait=8)
    stop.set()
    thread.join(timeout=5)
    assert found
    assert message == String(data="hello")


def test_silence_ends_after_the_time_given(world):
    before = time.monotonic()
    found, message = wait_for_message(String, world.node("listener", spin=False), "silent", time_to_wait=0.2)
    assert (found, message) == (False, None)
    assert 0.1 < time.monotonic() - before < 5
