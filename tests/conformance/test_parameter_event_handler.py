import pytest
from rclpy.parameter import Parameter
from rclpy.parameter_event_handler import ParameterEventHandler


@pytest.fixture
def heard(world):
    """A node with a parameter, and a handler in another node that is connected to it."""
    node, listener = world.node("n", namespace="/ns"), world.node("listener", namespace="/ns")
    handler, ready = ParameterEventHandler(listener), []
    handle = handler.add_parameter_event_callback(ready.append)
    counter = iter(range(1000))

    def connected():
        node.declare_parameter(f"probe_{next(counter)}", 1)
        return any(event.node == "/ns/n" for event in ready)

    world.spin_until(connected)
    handler.remove_parameter_event_callback(handle)
    world.spin_for(0.1)
    yield world, node, handler
    handler.destroy()


@pytest.mark.parametrize("name", ["/ns/n", "n"])
def test_a_changed_parameter_calls_back(heard, name):
    world, node, handler = heard
    values = []
    handler.add_parameter_callback("speed", name, lambda p: values.append(p.value.integer_value))
    node.declare_parameter("speed", 1)
    node.declare_parameter("other", 7)
    node.set_parameters([Parameter("speed", value=2)])
    world.spin_until(lambda: len(values) == 2)
    assert values == [1, 2]


def test_another_node_does_not_call_back(heard):
    world, node, handler = heard
    values, events = [], []
    handler.add_parameter_callback("speed", "/ns/absent", values.append)
    handler.add_parameter_event_callback(events.append)
    node.declare_parameter("speed", 1)
    world.spin_until(lambda: events)
    assert values == []


def test_a_removed_callback_is_silent(heard):
    world, node, handler = heard
    values, events = [], []
    handle = handler.add_parameter_callback("speed", "n", values.append)
    handler.add_parameter_event_callback(events.append)
    handler.remove_parameter_callback(handle)
    node.declare_parameter("speed", 1)
    world.spin_until(lambda: events)
    assert values == []


def test_an_event_tells_its_parameters(heard):
    world, node, handler = heard
    events = []
    handler.add_parameter_event_callback(events.append)
    node.declare_parameter("speed", 3)
    world.spin_until(lambda: events)
    (parameter,) = handler.get_parameters_from_event(events[0])
    assert parameter.name == "speed"
    speed = handler.get_parameter_from_event(events[0], "speed", "/ns/n")
    assert speed.value.integer_value == 3
    assert handler.get_parameter_from_event(events[0], "absent", "/ns/n") is None
    assert handler.get_parameter_from_event(events[0], "speed", "/other") is None
