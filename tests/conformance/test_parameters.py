import pytest
from rcl_interfaces.msg import (
    ParameterDescriptor,
    ParameterValue,
    SetParametersResult,
)
from rclpy.exceptions import (
    InvalidParameterException,
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.parameter import (
    Parameter,
)

Type = Parameter.Type


@pytest.fixture
def node(world):
    return world.node("n", namespace="/ns", spin=False)


def test_a_declared_parameter_has_its_value(node):
    declared = node.declare_parameter("speed", 2)
    assert (declared.name, declared.value, declared.type_) == ("speed", 2, Type.INTEGER)
    assert node.get_parameter("speed").value == 2
    assert node.has_parameter("speed")


def test_use_sim_time_is_always_declared(node):
    assert node.get_parameter("use_sim_time").value is False


def test_an_undeclared_parameter_is_refused(node):
    assert not node.has_parameter("speed")
    with pytest.raises(ParameterNotDeclaredException):
        node.get_parameter("speed")
    with pytest.raises(ParameterNotDeclaredException):
        node.set_parameters([Parameter("speed", value=1)])
    with pytest.raises(ParameterNotDeclaredException):
        node.describe_parameter("speed")
    with pytest.raises(ParameterNotDeclaredException):
        node.undeclare_parameter("speed")


def test_declaring_twice_is_refused(node):
    node.declare_parameter("speed", 1)
    with pytest.raises(ParameterAlreadyDeclaredException):
        node.declare_parameter("speed", 1)


def test_a_parameter_without_value_or_type_warns(node):
    with pytest.warns(UserWarning):
        assert node.declare_parameter("bare").type_ == Type.NOT_SET


def test_a_parameter_declared_by_type_waits_for_its_value(node):
    node.declare_parameter("speed", Type.INTEGER)
    with pytest.raises(ParameterUninitializedException):
        node.get_parameter("speed")
    assert node.set_parameters([Parameter("speed", value=3)])[0].successful
    assert node.get_parameter("speed").value == 3


@pytest.mark.parametrize("name", [1, None])
def test_a_name_is_text(node, name):
    with pytest.raises(TypeError):
        node.declare_parameter(name, 1)


def test_an_empty_name_is_refused(node):
    with pytest.raises(InvalidParameterException):
        node.declare_parameter("", 1)


def test_a_static_type_stays(node):
    node.declare_parameter("speed", 1)
    result = node.set_parameters([Parameter("speed", value="fast")])[0]
    assert not result.successful
    assert "Wrong parameter type" in result.reason
    assert node.get_parameter("speed").value == 1


def test_dynamic_typing_lets_the_type_change(node):
    node.declare_parameter("any", 1, ParameterDescriptor(dynamic_typing=True))
    assert node.set_parameters([Parameter("any", value="text")])[0].successful
    assert node.get_parameter("any").value == "text"


def test_a_static_parameter_is_not_unset(node):
    node.declare_parameter("speed", 1)
    result = node.set_parameters([Parameter("speed", Type.NOT_SET, None)])[0]
    assert (result.successful, result.reason) == (False, "Static parameter cannot be undeclared")


def test_a_read_only_parameter_is_not_changed(node):
    node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True))
    result = node.set_parameters([Parameter("fixed", value=2)])[0]
    assert not result.successful
    assert "read-only" in result.reason
    with pytest.raises(ParameterImmutableException):
        node.undeclare_parameter("fixed")
    with pytest.raises(ParameterImmutableException):
        node.set_descriptor("fixed", ParameterDescriptor())


def test_undeclaring_forgets(node):
    node.declare_parameter("speed", 1, ParameterDescriptor(dynamic_typing=True))
    node.undeclare_parameter("speed")
    assert not node.has_parameter("speed")


def test_a_callback_may_refuse(node):
    def refuse(parameters):
        bad = any(p.name == "speed" and p.value > 5 for p in parameters)
        return SetParametersResult(successful=not bad, reason="too fast" if bad else "")

    node.declare_parameter("speed", 1)
    node.add_on_set_parameters_callback(refuse)
    result = node.set_parameters([Parameter("speed", value=9)])[0]
    assert (result.successful, result.reason) == (False, "too fast")
    assert node.get_parameter("speed").value == 1
    node.remove_on_set_parameters_callback(refuse)
    assert node.set_parameters([Parameter("speed", value=9)])[0].successful


def test_a_callback_may_refuse_a_declaration(node):
    node.add_on_set_parameters_callback(lambda parameters: SetParametersResult(successful=False, reason="no"))
    with pytest.raises(InvalidParameterValueException, match="no"):
        node.declare_parameter("speed", 1)


@pytest.mark.parametrize("answer", [None, True, 1])
def test_a_callback_that_gives_no_result_back_refuses(node, answer):
    node.declare_parameter("speed", 1)
    node.add_on_set_parameters_callback(lambda parameters: answer)
    with pytest.warns(UserWarning, match="Callback returned an invalid type"):
        result = node.set_parameters([Parameter("speed", value=9)])[0]
    assert (result.successful, result.reason) == (False, "Callback returned an invalid type")
    assert node.get_parameter("speed").value == 1


def test_what_cannot_be_called_is_no_callback(node):
    with pytest.raises(TypeError, match="must be callable"):
        node.add_on_set_parameters_callback("judge")


def test_atomically_means_all_or_none(node):
    node.declare_parameters("", [("a", 1), ("b", 2)])
    result = node.set_parameters_atomically([Parameter("a", value=5), Parameter("b", value="text")])
    assert not result.successful
    assert [p.value for p in node.get_parameters(["a", "b"])] == [1, 2]


def test_one_by_one_means_each_for_itself(node):
    node.declare_parameters("", [("a", 1), ("b", 2)])
    results = node.set_parameters([Parameter("a", value=5), Parameter("b", value="text")])
    assert [result.successful for result in results] == [True, False]
    assert [p.value for p in node.get_parameters(["a", "b"])] == [5, 2]


def test_declaring_many_joins_the_namespace(node):
    node.declare_parameters("arm", [("length", 1.5), ("name", "left")])
    assert node.get_parameter("arm.length").value == 1.5
    by_prefix = node.get_parameters_by_prefix("arm")
    assert {name: parameter.value for name, parameter in by_prefix.items()} == {"length": 1.5, "name": "left"}


def test_get_parameter_or_gives_the_alternative(node):
    alternative = Parameter("speed", value=7)
    assert node.get_parameter_or("speed", alternative).value == 7
    assert node.get_parameter_or("speed").type_ == Type.NOT_SET


def test_types_are_told(node):
    node.declare_parameters("", [("a", 1), ("b", "x")])
    assert node.get_parameter_type("a") == Type.INTEGER
    assert node.get_parameter_types(["a", "b"]) == [Type.INTEGER, Type.STRING]


def test_changes_are_told_on_parameter_events(world):
    from rcl_interfaces.msg import ParameterEvent

    node, events = world.node("n"), []
    node.create_subscription(ParameterEvent, "/parameter_events", events.append, 10)
    world.spin_until(lambda: node.count_publishers("/parameter_events") > 0)
    world.spin_for(0.3)
    node.declare_parameter("speed", 1)
    node.set_parameters([Parameter("speed", value=2)])
    world.spin_until(lambda: any(e.changed_parameters for e in events))
    assert any(p.name == "speed" for e in events for p in e.new_parameters)
    assert [p.value.integer_value for e in events for p in e.changed_parameters] == [2]
    assert events[-1].node == "/n"


def test_what_is_no_parameter_is_refused_also_where_all_may_be_set(world):
    node = world.node(allow_undeclared_parameters=True)
    with pytest.raises(TypeError):
        node.set_parameters([42])


def test_a_dynamic_parameter_that_loses_its_value_is_undeclared(node):
    node.declare_parameter("loose", "value", ParameterDescriptor(dynamic_typing=True))
    assert node.set_parameters([Parameter("loose", Type.NOT_SET, None)])[0].successful
    assert not node.has_parameter("loose")


def test_a_parameter_value_stands_for_an_override(world):
    overrides = [Parameter(name, Parameter.Type.INTEGER, 7) for name in ("given", "typed", "wrong")]
    node = world.node(parameter_overrides=overrides)
    assert node.declare_parameter("given", ParameterValue(), ParameterDescriptor(dynamic_typing=True)).value == 7
    assert node.declare_parameter("typed", ParameterValue(type=Parameter.Type.INTEGER.value, integer_value=3)).value == 7
    with pytest.raises(InvalidParameterTypeException):
        node.declare_parameter("wrong", ParameterValue(type=Parameter.Type.STRING.value, string_value="a"))
    with pytest.raises(ValueError, match="Cannot declare a Parameter from a ParameterValue"):
        node.declare_parameter("absent", ParameterValue(), ParameterDescriptor(dynamic_typing=True))
    with pytest.raises(ValueError, match="statically typed parameter with default value of type PARAMETER_NOT_SET"):
        node.declare_parameter("absent", ParameterValue())


def test_setting_several_goes_up_to_the_first_undeclared_one(node):
    node.declare_parameters("", [("a", 1), ("b", 2)])
    wanted = [Parameter(name, value=9) for name in ("a", "unknown", "b")]
    with pytest.raises(ParameterNotDeclaredException):
        node.set_parameters(wanted)
    assert [node.get_parameter(name).value for name in ("a", "b")] == [9, 2]
