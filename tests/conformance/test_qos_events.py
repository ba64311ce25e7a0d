import pytest
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSPolicyKind, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

BEST_EFFORT = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.mark.parametrize(
    ("offer", "wish", "policy"),
    [(BEST_EFFORT, QoSProfile(depth=1), "RELIABILITY"), (QoSProfile(depth=1), LATCHED, "DURABILITY")],
)
def test_a_subscription_hears_of_an_offer_that_does_not_fit(world, offer, wish, policy):
    node, events = world.node(), []
    node.create_publisher(String, "chatter", offer)
    callbacks = SubscriptionEventCallbacks(incompatible_qos=events.append)
    node.create_subscription(String, "chatter", lambda m: None, wish, event_callbacks=callbacks)
    world.spin_until(lambda: events)
    assert events[0].total_count == 1
    assert QoSPolicyKind(int(events[0].last_policy_kind)).name == policy


def test_a_publisher_hears_of_a_request_that_does_not_fit(world):
    node, events = world.node(), []
    callbacks = PublisherEventCallbacks(incompatible_qos=events.append)
    node.create_publisher(String, "chatter", BEST_EFFORT, event_callbacks=callbacks)
    node.create_subscription(String, "chatter", lambda m: None, 1)
    world.spin_until(lambda: events)
    assert QoSPolicyKind(int(events[0].last_policy_kind)) == QoSPolicyKind.RELIABILITY


def test_the_default_is_a_warning_on_both_sides(world, capfd):
    node = world.node()
    node.create_publisher(String, "chatter", QoSProfile(depth=1))
    node.create_subscription(String, "chatter", lambda m: None, LATCHED)
    world.spin_for(0.5)
    shown = capfd.readouterr().err
    assert (
        "New subscription discovered on topic 'chatter', requesting incompatible QoS. "
        "No messages will be sent to it. Last incompatible policy: DURABILITY" in shown
    )
    assert (
        "New publisher discovered on topic 'chatter', offering incompatible QoS. "
        "No messages will be received from it. Last incompatible policy: DURABILITY" in shown
    )


def test_the_default_can_be_declined(world, capfd):
    node = world.node()
    pub = PublisherEventCallbacks(use_default_callbacks=False)
    sub = SubscriptionEventCallbacks(use_default_callbacks=False)
    node.create_publisher(String, "chatter", QoSProfile(depth=1), event_callbacks=pub)
    node.create_subscription(String, "chatter", lambda m: None, LATCHED, event_callbacks=sub)
    world.spin_for(0.5)
    assert "incompatible QoS" not in capfd.readouterr().err


def test_a_missed_deadline_is_told_to_both(world):
    node, offered, requested = world.node(), [], []
    qos = QoSProfile(depth=1, deadline=Duration(seconds=0.1))
    publisher = node.create_publisher(
        String, "pulse", qos, event_callbacks=PublisherEventCallbacks(deadline=offered.append)
    )
    node.create_subscription(
        String,
        "pulse",
        lambda m: None,
        qos,
        event_callbacks=SubscriptionEventCallbacks(deadline=requested.append),
    )
    world.matched(publisher)
    publisher.publish(String())
    world.spin_until(lambda: offered and requested)
    assert offered[0].total_count >= 1
    assert requested[0].total_count >= 1


def test_liveliness_is_lost_and_told(world):
    node, lost, changed = world.node(), [], []
    qos = QoSProfile(
        depth=1,
        liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
        liveliness_lease_duration=Duration(seconds=0.2),
    )
    publisher = node.create_publisher(
        String, "pulse", qos, event_callbacks=PublisherEventCallbacks(liveliness=lost.append)
    )
    node.create_subscription(
        String,
        "pulse",
        lambda m: None,
        qos,
        event_callbacks=SubscriptionEventCallbacks(liveliness=changed.append),
    )
    world.matched(publisher)
    publisher.assert_liveliness()
    world.spin_until(lambda: any(event.alive_count == 1 for event in changed))
    world.spin_until(lambda: lost and any(event.alive_count == 0 for event in changed))
    assert lost[0].total_count == 1


def test_fitting_profiles_are_no_event(world):
    node, events = world.node(), []
    publisher = node.create_publisher(
        String, "chatter", 1, event_callbacks=PublisherEventCallbacks(incompatible_qos=events.append)
    )
    node.create_subscription(String, "chatter", lambda m: None, BEST_EFFORT)
    world.matched(publisher)
    world.spin_for(0.1)
    assert events == []


def test_expired_messages_are_not_given_to_late_joiners(world):
    node, heard = world.node(), []
    qos = QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=0.2))
    publisher = node.create_publisher(String, "fresh", qos)
    publisher.publish(String(data="old"))
    world.spin_for(0.6)
    publisher.publish(String(data="new"))
    node.create_subscription(String, "fresh", lambda m: heard.append(m.data), qos)
    world.spin_until(lambda: heard)
    assert heard == ["new"]


def test_the_older_module_has_the_same_names():
    from rclpy import qos_event

    assert qos_event.SubscriptionEventCallbacks is SubscriptionEventCallbacks
    assert qos_event.PublisherEventCallbacks is PublisherEventCallbacks
