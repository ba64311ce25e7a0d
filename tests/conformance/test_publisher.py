import pytest
from rclpy.exceptions import InvalidHandle, InvalidTopicNameException
from rclpy.qos import QoSProfile
from std_msgs.msg import String
from std_srvs.srv import Trigger


def test_the_topic_name_is_resolved(world):
    node = world.node("n", namespace="/ns")
    assert node.create_publisher(String, "chatter", 10).topic_name == "/ns/chatter"
    assert node.create_publisher(String, "/chatter", 10).topic_name == "/chatter"
    assert node.create_publisher(String, "~/chatter", 10).topic_name == "/ns/n/chatter"


@pytest.mark.parametrize("depth", [0, 1, 10])
@pytest.mark.filterwarnings("ignore:A zero depth")
def test_a_depth_is_a_profile(world, depth):
    world.node().create_publisher(String, "chatter", depth)


def test_a_negative_depth_is_refused(world):
    with pytest.raises(ValueError, match="must be greater than or equal to zero"):
        world.node().create_publisher(String, "chatter", -1)


@pytest.mark.parametrize("qos", ["foo", None, 1.5])
def test_what_is_no_profile_is_refused(world, qos):
    with pytest.raises(TypeError, match="Expected QoSProfile or int"):
        world.node().create_publisher(String, "chatter", qos)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("chatter?", "must not contain characters"),
        ("/chatter/42_is", "must not start with a number"),
        ("chatter/", "must not end with a forward slash"),
        ("", "must not be empty"),
    ],
)
def test_a_bad_topic_name_is_refused(world, name, reason):
    with pytest.raises(InvalidTopicNameException, match=reason):
        world.node().create_publisher(String, name, 10)


def test_an_unknown_substitution_is_refused(world):
    with pytest.raises(ValueError, match="unknown substitution"):
        world.node().create_publisher(String, "chatter/{bad}", 10)


def test_a_service_is_no_message(world):
    with pytest.raises(RuntimeError, match="might be a service or action"):
        world.node().create_publisher(Trigger, "chatter", 10)


@pytest.mark.parametrize("kind", [int, str, object])
def test_a_class_without_type_support_is_refused(world, kind):
    with pytest.raises(AttributeError, match="ROS 1 message type"):
        world.node().create_publisher(kind, "chatter", 10)


@pytest.mark.parametrize("message", ["text", 1, None])
def test_another_type_is_not_published(world, message):
    publisher = world.node().create_publisher(String, "chatter", 10)
    with pytest.raises(TypeError, match="Expected <class"):
        publisher.publish(message)


def test_publishing_after_destroy_is_refused(world):
    node = world.node()
    publisher = node.create_publisher(String, "chatter", 10)
    assert node.destroy_publisher(publisher)
    with pytest.raises(InvalidHandle):
        publisher.publish(String())


def test_a_publisher_is_destroyed_once(world):
    node = world.node()
    publisher = node.create_publisher(String, "chatter", 10)
    assert node.destroy_publisher(publisher)
    assert not node.destroy_publisher(publisher)


def test_publishers_are_listed(world):
    node = world.node()
    before = len(list(node.publishers))
    publisher = node.create_publisher(String, "chatter", 10)
    assert publisher in list(node.publishers)
    assert len(list(node.publishers)) == before + 1


def test_subscriptions_are_counted(world):
    node = world.node()
    publisher = node.create_publisher(String, "chatter", 10)
    assert publisher.get_subscription_count() == 0
    subscription = node.create_subscription(String, "chatter", lambda m: None, 10)
    world.matched(publisher)
    node.destroy_subscription(subscription)
    world.spin_until(lambda: publisher.get_subscription_count() == 0)


def test_waiting_for_acknowledgements_ends(world):
    publisher = world.node().create_publisher(String, "chatter", QoSProfile(depth=10))
    publisher.publish(String())
    assert publisher.wait_for_all_acked()


def test_a_publisher_of_another_node_is_not_destroyed(world):
    one, two = world.node("one"), world.node("two")
    publisher = one.create_publisher(String, "chatter", 10)
    assert not two.destroy_publisher(publisher)
    publisher.publish(String())
