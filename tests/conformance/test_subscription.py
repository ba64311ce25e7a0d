import numpy
import pytest
from rclpy.exceptions import InvalidTopicNameException
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import Float32, Int64, String
from test_msgs.msg import Arrays, BasicTypes


def test_a_message_arrives(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", heard.append, 10)
    world.matched(publisher)
    publisher.publish(String(data="hello"))
    world.spin_until(lambda: heard)
    assert heard == [String(data="hello")]


def test_messages_arrive_in_order(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(Int64, "count", 100)
    node.create_subscription(Int64, "count", lambda m: heard.append(m.data), 100)
    world.matched(publisher)
    for number in range(50):
        publisher.publish(Int64(data=number))
    world.spin_until(lambda: len(heard) == 50)
    assert heard == list(range(50))


def test_the_subscriber_gets_a_copy(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(Arrays, "arrays", 10)
    node.create_subscription(Arrays, "arrays", heard.append, 10)
    world.matched(publisher)
    message = Arrays()
    message.string_values[0] = "before"
    message.int32_values[0] = 1
    publisher.publish(message)
    message.string_values[0] = "after"
    message.int32_values[0] = 2
    world.spin_until(lambda: heard)
    assert heard[0].string_values[0] == "before"
    assert heard[0].int32_values[0] == 1


def test_a_float32_comes_in_with_the_digits_that_it_has(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(Float32, "chatter", 10)
    node.create_subscription(Float32, "chatter", heard.append, 10)
    world.matched(publisher)
    sent = Float32(data=0.1)
    publisher.publish(sent)
    world.spin_until(lambda: heard)
    assert (sent.data, heard[0].data) == (0.1, 0.10000000149011612)


def test_numbers_come_in_as_pythons_own(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(BasicTypes, "basic", 10)
    node.create_subscription(BasicTypes, "basic", heard.append, 10)
    world.matched(publisher)
    publisher.publish(BasicTypes(float64_value=numpy.float64(0.5), float32_value=numpy.float64(0.5), int32_value=True))
    world.spin_until(lambda: heard)
    kinds = [type(value) for value in (heard[0].float64_value, heard[0].float32_value, heard[0].int32_value)]
    assert kinds == [float, float, int]


def test_two_subscribers_get_messages_of_their_own(world):
    node, one, two = world.node(), [], []
    publisher = node.create_publisher(Arrays, "arrays", 10)
    node.create_subscription(Arrays, "arrays", one.append, 10)
    node.create_subscription(Arrays, "arrays", two.append, 10)
    world.matched(publisher, 2)
    publisher.publish(Arrays())
    world.spin_until(lambda: one and two)
    one[0].int32_values[0] = 7
    assert two[0].int32_values[0] == 0


def test_a_raw_subscription_gets_bytes(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", heard.append, 10, raw=True)
    world.matched(publisher)
    publisher.publish(String(data="hello"))
    world.spin_until(lambda: heard)
    assert isinstance(heard[0], bytes)
    assert deserialize_message(heard[0], String) == String(data="hello")


def test_bytes_are_published_as_they_are(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", heard.append, 10)
    world.matched(publisher)
    publisher.publish(serialize_message(String(data="raw")))
    world.spin_until(lambda: heard)
    assert heard == [String(data="raw")]


def test_keep_last_drops_the_oldest(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(Int64, "count", 100)
    node.create_subscription(Int64, "count", lambda m: heard.append(m.data), 3)
    world.matched(publisher)
    for number in range(10):
        publisher.publish(Int64(data=number))
    publisher.wait_for_all_acked()
    world.spin_until(lambda: 9 in heard)
    assert heard == [7, 8, 9]


def test_keep_all_drops_nothing(world):
    node, heard = world.node(), []
    keep_all = QoSProfile(history=HistoryPolicy.KEEP_ALL)
    publisher = node.create_publisher(Int64, "count", keep_all)
    node.create_subscription(Int64, "count", lambda m: heard.append(m.data), keep_all)
    world.matched(publisher)
    for number in range(200):
        publisher.publish(Int64(data=number))
    world.spin_until(lambda: len(heard) == 200)
    assert heard == list(range(200))


def test_a_late_joiner_gets_what_transient_local_kept(world):
    node, heard = world.node(), []
    qos = QoSProfile(depth=2, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = node.create_publisher(Int64, "latched", qos)
    for number in range(5):
        publisher.publish(Int64(data=number))
    node.create_subscription(Int64, "latched", lambda m: heard.append(m.data), qos)
    world.spin_until(lambda: len(heard) == 2)
    assert heard == [3, 4]


def test_a_volatile_late_joiner_gets_nothing_old(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(Int64, "fleeting", 10)
    publisher.publish(Int64(data=1))
    node.create_subscription(Int64, "fleeting", lambda m: heard.append(m.data), 10)
    world.matched(publisher)
    publisher.publish(Int64(data=2))
    world.spin_until(lambda: heard)
    assert heard == [2]


def test_best_effort_does_not_serve_reliable(world):
    node, heard = world.node(), []
    best_effort = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
    publisher = node.create_publisher(Int64, "scan", best_effort)
    node.create_subscription(Int64, "scan", heard.append, 1)
    fine = node.create_subscription(Int64, "scan", heard.append, best_effort)
    world.matched(publisher)
    assert publisher.get_subscription_count() == 1
    assert fine.topic_name == "/scan"


def test_a_destroyed_subscription_hears_nothing(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(Int64, "count", 10)
    first = node.create_subscription(Int64, "count", lambda m: heard.append("first"), 10)
    node.create_subscription(Int64, "count", lambda m: heard.append("second"), 10)
    world.matched(publisher, 2)
    assert node.destroy_subscription(first)
    assert not node.destroy_subscription(first)
    publisher.publish(Int64())
    world.spin_until(lambda: heard)
    assert heard == ["second"]


@pytest.mark.parametrize("name", ["a b", "a/", "1a"])
def test_a_bad_topic_name_is_refused(world, name):
    with pytest.raises(InvalidTopicNameException):
        world.node().create_subscription(String, name, lambda m: None, 10)


def test_the_callback_may_take_the_message_info(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(Int64, "count", 10)

    def with_info(message, info):
        heard.append((message.data, info))

    node.create_subscription(Int64, "count", with_info, 10)
    world.matched(publisher)
    publisher.publish(Int64(data=1))
    world.spin_until(lambda: heard)
    assert heard[0][0] == 1


def test_a_coroutine_callback_is_awaited(world):
    node, heard = world.node(), []
    publisher = node.create_publisher(Int64, "count", 10)

    async def callback(message):
        heard.append(message.data)

    node.create_subscription(Int64, "count", callback, 10)
    world.matched(publisher)
    publisher.publish(Int64(data=3))
    world.spin_until(lambda: heard)
    assert heard == [3]
