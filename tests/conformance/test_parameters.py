import pytest
from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    ParameterType,
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
    get_parameter_value,
    parameter_dict_from_yaml_file,
    parameter_value_to_python,
)

Type = Parameter.Type


@pytest.fixture
def node(world):
    return world.node("n", namespace="/ns", spin=False)


@pytest.mark.parametrize(
    ("value", "kind"),
    [
        (None, Type.NOT_SET),
        (True, Type.BOOL),
        (1, Type.INTEGER),
        (1.5, Type.DOUBLE),
        ("a", Type.STRING),
        ([], Type.BYTE_ARRAY),
        ([b"a"], Type.BYTE_ARRAY),
        ([True], Type.BOOL_ARRAY),
        ([1, 2], Type.INTEGER_ARRAY),
        ((1, 2), Type.INTEGER_ARRAY),
        ([1.5], Type.DOUBLE_ARRAY),
        (["a", ""], Type.STRING_ARRAY),
    ],
)
def test_a_type_is_found_from_the_value(value, kind):
    assert Type.from_parameter_value(value) == kind
    assert Parameter("p", value=value).type_ == kind


@pytest.mark.parametrize("value", [{}, b"a", [1, "a"], [1, 2.0], object()])
def test_a_value_of_no_parameter_type_is_refused(value):
    with pytest.raises(TypeError):
        Parameter("p", value=value)


def test_type_and_value_must_agree():
    with pytest.raises(ValueError, match="do not agree"):
        Parameter("p", Type.INTEGER, "text")
    with pytest.raises(TypeError, match="type must be an instance of"):
        Parameter("p", "INTEGER", 1)


@pytest.mark.parametrize("value", [True, 1, 1.5, "a", [True], [1, 2], [1.5], ["a"], [b"a"]])
def test_a_parameter_survives_its_message(value):
    message = Parameter("p", value=value).to_parameter_msg()
    assert message.name == "p"
    assert parameter_value_to_python(message.value) == value
    again = Parameter.from_parameter_msg(message)
    assert again.type_ == Parameter("p", value=value).type_
    assert list(again.value) == value if isinstance(value, list) else again.value == value


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("1", ParameterType.PARAMETER_INTEGER),
        ("1.5", ParameterType.PARAMETER_DOUBLE),
        ("yes", ParameterType.PARAMETER_BOOL),
        ("abc", ParameterType.PARAMETER_STRING),
        ("'1'", ParameterType.PARAMETER_STRING),
        ("[1, 2]", ParameterType.PARAMETER_INTEGER_ARRAY),
        ("[1, a]", ParameterType.PARAMETER_STRING),
        ("[a, b]", ParameterType.PARAMETER_STRING_ARRAY),
    ],
)
def test_a_word_of_the_command_line_is_typed(text, kind):
    assert get_parameter_value(text).type == kind


def test_an_unknown_type_number_is_refused():
    with pytest.raises(RuntimeError, match="unexpected parameter type"):
        parameter_value_to_python(ParameterValue(type=12))


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


@pytest.mark.parametrize(
    ("value", "fits"), [(0, True), (2, True), (10, True), (1, False), (11, False), (-1, False)]
)
def test_an_integer_range_with_steps(node, value, fits):
    limits = IntegerRange(from_value=0, to_value=10, step=2)
    node.declare_parameter("n", 4, ParameterDescriptor(integer_range=[limits]))
    assert node.set_parameters([Parameter("n", value=value)])[0].successful is fits


@pytest.mark.parametrize(
    ("value", "fits"), [(0.0, True), (0.5, True), (9.9, True), (0.25, False), (10.0, False), (9.5, True)]
)
def test_a_floating_point_range_with_steps(node, value, fits):
    limits = FloatingPointRange(from_value=0.0, to_value=9.9, step=0.5)
    node.declare_parameter("x", 1.0, ParameterDescriptor(floating_point_range=[limits]))
    assert node.set_parameters([Parameter("x", value=value)])[0].successful is fits


def test_a_value_outside_of_its_range_is_not_declared(node):
    limits = IntegerRange(from_value=0, to_value=10, step=1)
    with pytest.raises(InvalidParameterValueException):
        node.declare_parameter("n", 11, ParameterDescriptor(integer_range=[limits]))


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


def test_descriptors_are_kept(node):
    node.declare_parameter("speed", 1, ParameterDescriptor(description="metres per second"))
    described = node.describe_parameter("speed")
    assert (described.name, described.description) == ("speed", "metres per second")
    assert described.type == ParameterType.PARAMETER_INTEGER


def test_overrides_win_over_defaults(world):
    node = world.node(spin=False, parameter_overrides=[Parameter("speed", value=9)])
    assert node.declare_parameter("speed", 1).value == 9
    assert node.declare_parameter("other", 1).value == 1


def test_an_override_may_be_ignored(world):
    node = world.node(spin=False, parameter_overrides=[Parameter("speed", value=9)])
    assert node.declare_parameter("speed", 1, ignore_override=True).value == 1


def test_an_override_of_another_type_is_refused(world):
    node = world.node(spin=False, parameter_overrides=[Parameter("speed", value="fast")])
    with pytest.raises(InvalidParameterTypeException):
        node.declare_parameter("speed", 1)


def test_overrides_may_declare(world):
    node = world.node(
        spin=False,
        parameter_overrides=[Parameter("speed", value=9)],
        automatically_declare_parameters_from_overrides=True,
    )
    assert node.get_parameter("speed").value == 9


def test_undeclared_parameters_may_be_allowed(world):
    node = world.node(spin=False, allow_undeclared_parameters=True)
    assert node.get_parameter("speed").type_ == Type.NOT_SET
    assert node.set_parameters([Parameter("speed", value=1)])[0].successful
    assert node.get_parameter("speed").value == 1


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1", 1),
        ("1.0e3", 1000.0),
        ("yes", True),
        ("off", False),
        ("'1'", "1"),
        ("abc", "abc"),
        ("0x1F", 31),
        ("[1, 2]", [1, 2]),
        ("[1.5, .inf]", [1.5, float("inf")]),
        ("[a, b]", ["a", "b"]),
        ("1.0.0", "1.0.0"),
        ("null", "null"),
        ("017", 15),
        ("1_000", "1_000"),
        ("tRue", "tRue"),
        ("[yes, no]", [True, False]),
    ],
)
def test_the_command_line_types_values(world, text, value):
    node = world.node(
        spin=False,
        cli_args=["--ros-args", "-p", f"p:={text}"],
        automatically_declare_parameters_from_overrides=True,
    )
    found = node.get_parameter("p").value
    assert (list(found) if isinstance(value, list) else found) == value


@pytest.mark.parametrize(
    ("key", "applies"),
    [
        ("/ns/n", True),
        ("ns/n", True),
        ("n", False),
        ("/**", True),
        ("/*", False),
        ("/*/n", True),
        ("/*/*", True),
        ("/**/n", True),
        ("/ns/*", True),
        ("/ns/**", True),
        ("'**'", True),
        ("/other/n", False),
        ("/n", False),
    ],
)
def test_a_file_names_nodes(world, tmp_path, key, applies):
    file = tmp_path / "p.yaml"
    file.write_text(f"{key}:\n  ros__parameters:\n    p: 1\n")
    node = world.node(
        "n",
        namespace="/ns",
        spin=False,
        cli_args=["--ros-args", "--params-file", str(file)],
        automatically_declare_parameters_from_overrides=True,
    )
    assert node.has_parameter("p") is applies


def test_repeated_keys_of_a_file_accumulate(world, tmp_path):
    file = tmp_path / "p.yaml"
    parts = [("/**", "a: 1"), ("/n", "{a: 2, b: 2}"), ("/**", "{a: 5, c: {d: x}}")]
    file.write_text("".join(f"{key}:\n  ros__parameters:\n    {values}\n" for key, values in parts))
    node = world.node(
        "n",
        spin=False,
        cli_args=["--ros-args", "--params-file", str(file)],
        automatically_declare_parameters_from_overrides=True,
    )
    assert [node.get_parameter(name).value for name in ("a", "b", "c.d")] == [2, 2, "x"]


def test_file_and_command_line_apply_in_order(world, tmp_path):
    file = tmp_path / "p.yaml"
    file.write_text("/**:\n  ros__parameters:\n    a: 1\n")
    words = ["--params-file", str(file)]
    for args, value in ([*words, "-p", "a:=2"], 2), (["-p", "a:=2", *words], 1):
        node = world.node(spin=False, cli_args=["--ros-args", *args])
        assert node.declare_parameter("a", 0).value == value


def test_a_file_can_be_read_without_a_node(tmp_path):
    file = tmp_path / "p.yaml"
    file.write_text(
        "/n:\n  ros__parameters:\n    a: 1\n    b: {c: [1.5, 2.5]}\n/m:\n  ros__parameters: {z: 1}\n"
    )
    read = parameter_dict_from_yaml_file(str(file), False, ["/n"])
    assert {name: parameter_value_to_python(each.value) for name, each in read.items()} == {
        "a": 1,
        "b.c": [1.5, 2.5],
    }
    with pytest.raises(RuntimeError):
        parameter_dict_from_yaml_file(str(file), False, ["/absent"])


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
