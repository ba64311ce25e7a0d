"""What drives a robot over a network: stopped when its driver is gone, and never carried out late."""


import pytest
from geometry_msgs.msg import Twist

from coursekit.core.qos import Qos
from coursekit.net.remote import RemotePublisher
from coursekit.net.wire.attachment import Attachment
from coursekit.net.wire.moving import Punctual
from coursekit.net.wire.token import read_token


def velocity(publisher, forward, number, stamp):
    from coursekit.interfaces import cdr

    twist = Twist()
    twist.linear.x = forward
    publisher.receive(cdr.serialize(twist), Attachment(number, stamp, bytes(16)))


@pytest.fixture
def driven(side):
    """A robot here, and a publisher of velocities there."""
    here = side()
    subscription = here.graph.add_node("base", "/").subscription("/cmd_vel", Twist, Qos(depth=50))
    text = "@ros2_lv/0/ffee/1/2/MP/%/%/teleop/%cmd_vel/geometry_msgs::msg::dds_::Twist_/X/::,10:,:,:,,"
    here.link.visitors.came(text)
    publisher = here.graph.publishers["/cmd_vel"][0]
    assert isinstance(publisher, RemotePublisher) and read_token(text).name == "/cmd_vel"
    yield subscription, publisher, lambda: here.link.visitors.left(text)


def speeds(subscription):
    speeds_heard = []
    while (entry := subscription.take()) is not None:
        speeds_heard.append(entry[0].linear.x)
    return speeds_heard


def test_a_robot_is_stopped_when_who_drives_it_is_gone(driven):
    subscription, publisher, go = driven
    velocity(publisher, 0.5, 1, 0)
    go()
    assert speeds(subscription) == [0.5, 0.0]


def test_a_robot_that_stands_gets_no_stop(driven):
    subscription, publisher, go = driven
    velocity(publisher, 0.5, 1, 0)
    velocity(publisher, 0.0, 2, 1)
    go()
    assert speeds(subscription) == [0.5, 0.0]


def test_velocities_that_waited_in_a_queue_are_not_carried_out(driven):
    subscription, publisher, _ = driven
    now = publisher.graph.clock.now()
    velocity(publisher, 0.1, 1, now)
    for number in range(2, 10):  # sent long before, here only now
        velocity(publisher, 0.9, number, now - 5_000_000_000)
    velocity(publisher, 0.2, 10, publisher.graph.clock.now())
    assert speeds(subscription) == [0.1, 0.2]


def test_another_computers_clock_may_be_wrong_and_may_be_set():
    second, check = 1_000_000_000, Punctual()
    hour = 3600 * second
    assert not any(check.is_late(k * second // 10 + hour, k * second // 10) for k in range(20))
    late = [check.is_late(k * second // 10, k * second // 10) for k in range(20, 80)]
    assert late[0] and not late[-1]
