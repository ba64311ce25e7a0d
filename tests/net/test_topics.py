"""Messages between graphs: what is published in one is heard in the others once, and only if somebody listens."""

from geometry_msgs.msg import Twist
from std_msgs.msg import Int32, String

from coursekit.core.qos import BEST_EFFORT, KEEP_ALL, TRANSIENT_LOCAL, Qos
from coursekit.core.status import INCOMPATIBLE
from coursekit.interfaces import cdr
from coursekit.net.wire.attachment import Attachment

from .sides import Inbox

LATCHED = Qos(depth=3, durability=TRANSIENT_LOCAL)


def talker(side, name="talker", qos=Qos(depth=50), topic="/chatter", kind=String):
    return side.graph.add_node(name, "/").publisher(topic, kind, qos)


def listener(side, name="listener", qos=Qos(depth=50), topic="/chatter", kind=String):
    return side.graph.add_node(name, "/").subscription(topic, kind, qos)


def matched(side, end, count=1):
    """Wait until a publisher has so many listeners, and its messages are carried to those of other sides."""
    side.until(lambda: len(end.targets) == count)
    side.link.settle()


def heard_by(side, subscription, publishers=1):
    """Wait until so many publishers reach a subscription, and their messages are fetched."""
    group = side.graph.publishers
    side.until(
        lambda: sum(subscription in publisher.targets for publisher in group.get(subscription.name, ())) == publishers
    )
    side.link.settle()


def test_each_side_sees_the_others_nodes_and_topics_and_says_that_they_are_remote(side):
    here = side()
    talker(here)
    two = side()
    two.until(lambda: two.graph.publishers.get("/chatter"))
    assert two.names() == ["/talker"] and two.graph.topics() == [("/chatter", ["std_msgs/msg/String"])]
    assert two.graph.nodes[0].remote == side.address and not here.graph.nodes[0].remote


def test_a_message_is_heard_once_by_each_of_three(side):
    sides = [side() for _ in range(3)]
    inboxes = [Inbox(listener(each_side, f"listener{number}")) for number, each_side in enumerate(sides)]
    publisher = talker(sides[0])
    matched(sides[0], publisher, 3)
    for each_side, inbox in zip(sides, inboxes, strict=True):
        heard_by(each_side, inbox.source)
    for number in range(20):
        publisher.publish(String(data=str(number)))
    for inbox in inboxes:
        assert [inbox.take()[0].data for _ in range(20)] == [str(number) for number in range(20)]
        assert inbox.source.take() is None
    assert [each_side.said for each_side in sides] == [[], [], []]


def test_nothing_is_serialized_or_sent_where_nobody_listens(side, monkeypatch):
    one, two = side(), side()
    publisher = talker(one)
    two.until(lambda: two.graph.publishers.get("/chatter"))
    one.link.settle()
    monkeypatch.setattr(cdr, "serialize", None)
    publisher.publish(String(data="to nobody"))
    assert publisher.tap is None and one.link.announcer.senders[0].traffic.total == 0


def test_sending_ends_when_the_last_listener_leaves(side):
    one, two = side(), side()
    publisher, subscription = talker(one), listener(two)
    matched(one, publisher)
    assert publisher.tap is not None
    subscription.close()
    one.until(lambda: not publisher.targets)
    one.link.settle()
    assert publisher.tap is None


def test_who_comes_late_hears_what_was_latched_and_only_the_last_of_it(side):
    here = side()
    publisher = talker(here, qos=LATCHED)
    for number in range(5):
        publisher.publish(String(data=str(number)))
    two = side()
    inbox = Inbox(listener(two, qos=Qos(depth=10, durability=TRANSIENT_LOCAL)))
    assert [inbox.take()[0].data for _ in range(3)] == ["2", "3", "4"]
    three = side()
    later = Inbox(listener(three, qos=Qos(depth=10, durability=TRANSIENT_LOCAL)))
    assert [later.take()[0].data for _ in range(3)] == ["2", "3", "4"]
    publisher.publish(String(data="5"))
    assert inbox.take()[0].data == later.take()[0].data == "5"
    assert inbox.source.take() is None and later.source.take() is None


def test_a_second_listener_of_the_same_side_hears_what_was_latched_too(side):
    one, two = side(), side()
    talker(one, qos=LATCHED).publish(String(data="map"))
    first = Inbox(listener(two, "first", LATCHED))
    assert first.take()[0].data == "map"
    second = Inbox(listener(two, "second", LATCHED))
    assert second.take()[0].data == "map"
    assert first.source.take() is None and second.source.take() is None


def test_a_quality_that_does_not_fit_is_counted_on_both_sides_and_nothing_is_carried(side):
    one, two = side(), side()
    publisher, subscription = talker(one, qos=Qos(reliability=BEST_EFFORT)), listener(two)
    one.until(lambda: publisher.status(INCOMPATIBLE).total == 1)
    two.until(lambda: subscription.status(INCOMPATIBLE).total == 1)
    one.link.settle()
    assert not publisher.targets and publisher.tap is None


def test_another_type_on_the_same_topic_is_seen_and_not_heard(side):
    one, two = side(), side()
    talker(one, kind=Int32)
    subscription = listener(two)
    two.until(lambda: two.graph.publishers.get("/chatter"))
    assert two.graph.topics() == [("/chatter", ["std_msgs/msg/Int32", "std_msgs/msg/String"])]
    assert not two.graph.publishers["/chatter"][0].targets and subscription.take() is None


def test_the_clock_of_a_simulation_stays_inside(side):
    one, two = side(), side()
    talker(one, topic="/clock")
    talker(one, "other", topic="/chatter")
    two.until(lambda: two.graph.publishers.get("/chatter"))
    assert "/clock" not in two.graph.publishers
    two.link.visitors.came("@ros2_lv/0/ff/1/2/MP/%/%/robot/%clock/rosgraph_msgs::msg::dds_::Clock_/X/::,:,:,:,,")
    assert "/clock" not in two.graph.publishers


def test_domains_keep_groups_apart(side):
    one, two, three = side(domain_id=1), side(domain_id=2), side(domain_id=1)
    talker(one)
    three.until(lambda: three.names() == ["/talker"])
    two.link.settle()
    assert two.names() == []


def test_who_only_listens_hears_and_sends_nothing(side):
    one, two = side(), side(listen_only=True)
    publisher, inbox = talker(one), Inbox(listener(two))
    talker(two, "quiet", topic="/cmd_vel", kind=Twist)
    matched(one, publisher)
    heard_by(two, inbox.source)
    publisher.publish(String(data="hello"))
    assert inbox.take()[0].data == "hello"
    assert "/cmd_vel" not in one.graph.publishers


def test_a_listener_with_another_hash_is_sent_to_and_nobody_hears_twice(side):
    """As a robot with a later distribution does: it subscribes to a key that ends with the type's hash."""
    one, two = side(), side()
    publisher, inbox = talker(one, qos=Qos(depth=50, history=KEEP_ALL)), Inbox(listener(two))
    matched(one, publisher)
    heard_by(two, inbox.source)
    later = two.link.place.session
    got = later.declare_subscriber("0/chatter/std_msgs::msg::dds_::String_/RIHS01_abc")
    zid = str(later.info.zid())[:-1] + "0"
    token = later.liveliness().declare_token(
        f"@ros2_lv/0/{zid}/1/2/MS/%/%/jazzy/%chatter/std_msgs::msg::dds_::String_/RIHS01_abc/::,10:,:,:,,"
    )
    matched(one, publisher, 2)
    publisher.publish(String(data="both"))
    publisher.publish(String(data="again"))
    assert cdr.deserialize(got.recv().payload.to_bytes(), String).data == "both"
    assert [inbox.take()[0].data for _ in range(2)] == ["both", "again"] and inbox.source.take() is None
    token.undeclare()


def test_bytes_that_are_no_message_are_told_once_and_do_no_harm(side):
    one, two = side(), side()
    publisher, inbox = talker(one), Inbox(listener(two))
    matched(one, publisher)
    heard_by(two, inbox.source)
    stranger = one.link.place.session.declare_publisher("0/chatter/std_msgs::msg::dds_::String_/X")
    for data in (b"", b"\x00\x01\x00\x00\xff\xff\xff\xff", bytes(3)):
        stranger.put(data, attachment=b"junk")
    stranger.put(bytes(8), attachment=Attachment(1, 1, bytes(16)).data())
    publisher.publish(String(data="sound"))
    assert inbox.take()[0].data == "sound"
    assert "%colcon build" in two.until_told("cannot be read") and len(two.said) == 1


def test_what_is_published_in_the_moment_in_which_a_listener_is_known_arrives(side):
    one, two = side(), side()
    publisher = one.graph.add_node("talker", "/").publisher("/chatter", String, Qos())
    two.until(lambda: "/chatter" in two.graph.publishers)
    said = []

    def say():
        if publisher.targets and not said:
            said.append(publisher.publish(String(data="first")))

    one.graph.watch(say)
    inbox = Inbox(two.graph.add_node("listener", "/").subscription("/chatter", String, Qos()))
    assert inbox.take()[0].data == "first"


def test_a_publisher_that_is_new_where_a_listener_is_known_speaks_at_once_and_in_order(side):
    one, two = side(), side()
    inbox = Inbox(two.graph.add_node("listener", "/").subscription("/chatter", String, Qos(depth=100)))
    one.until(lambda: "/chatter" in one.graph.subscriptions)
    publisher = one.graph.add_node("talker", "/").publisher("/chatter", String, Qos(depth=100))
    assert publisher.targets
    for number in range(50):
        publisher.publish(String(data=str(number)))
    assert [inbox.take()[0].data for _ in range(50)] == [str(number) for number in range(50)]


def test_a_velocity_does_not_wait_for_the_link(side):
    one, two = side(), side()
    inbox = Inbox(two.graph.add_node("base", "/").subscription("/cmd_vel", Twist, Qos()))
    one.until(lambda: "/cmd_vel" in one.graph.subscriptions)
    publisher = one.graph.add_node("teleop", "/").publisher("/cmd_vel", Twist, Qos())
    assert publisher.targets and publisher.tap is None
    one.link.settle()
    two.link.settle()
    publisher.publish(Twist())
    inbox.take()
    assert inbox.source.take() is None


def test_who_only_listens_keeps_nothing_for_others(side):
    one, two = side(), side(listen_only=True)
    one.graph.add_node("listener", "/").subscription("/chatter", String, Qos())
    two.until(lambda: "/chatter" in two.graph.subscriptions)
    publisher = two.graph.add_node("talker", "/").publisher("/chatter", String, Qos())
    assert publisher.targets and publisher.tap is None
