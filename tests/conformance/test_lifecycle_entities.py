import pytest
from rclpy.lifecycle import (
    LifecycleNode,
    LifecycleState,
    ManagedEntity,
    SimpleManagedEntity,
    TransitionCallbackReturn,
)
from std_msgs.msg import String

SUCCESS, FAILURE, ERROR = (
    TransitionCallbackReturn.SUCCESS,
    TransitionCallbackReturn.FAILURE,
    TransitionCallbackReturn.ERROR,
)


def test_managed_entities_follow(world):
    calls = []

    class Entity(ManagedEntity):
        def on_configure(self, state):
            calls.append(("configure", state))
            return SUCCESS

        def on_activate(self, state):
            calls.append(("activate", state))
            return SUCCESS

    node = world.node("lc", node_class=LifecycleNode, spin=False)
    node.add_managed_entity(Entity())
    assert node.trigger_configure() == SUCCESS
    assert node.trigger_activate() == SUCCESS
    assert calls == [
        ("configure", LifecycleState("unconfigured", 1)),
        ("activate", LifecycleState("inactive", 2)),
    ]


def test_a_managed_entity_may_fail(world):
    class Entity(ManagedEntity):
        def on_configure(self, state):
            return FAILURE

    node = world.node("lc", node_class=LifecycleNode, spin=False)
    node.add_managed_entity(Entity())
    assert node.trigger_configure() == FAILURE


def test_only_managed_entities_are_managed(world):
    with pytest.raises(TypeError):
        world.node("lc", node_class=LifecycleNode, spin=False).add_managed_entity(object())


def test_a_simple_entity_works_while_active():
    class Worker(SimpleManagedEntity):
        @SimpleManagedEntity.when_enabled
        def work(self):
            done.append(True)

    done, worker, state = [], Worker(), LifecycleState("inactive", 2)
    worker.work()
    assert done == []
    worker.on_activate(state)
    assert worker.is_activated
    worker.work()
    assert done == [True]
    worker.on_deactivate(state)
    worker.work()
    assert done == [True]


def test_a_lifecycle_publisher_is_silent_while_inactive(world):
    node, heard = world.node("lc", node_class=LifecycleNode), []
    publisher = node.create_lifecycle_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda m: heard.append(m.data), 10)
    world.matched(publisher)
    publisher.publish(String(data="too early"))
    node.trigger_configure()
    node.trigger_activate()
    assert publisher.is_activated
    publisher.publish(String(data="now"))
    world.spin_until(lambda: heard)
    node.trigger_deactivate()
    publisher.publish(String(data="too late"))
    world.spin_for(0.1)
    assert heard == ["now"]
    assert node.destroy_lifecycle_publisher(publisher)
