import pytest
from rclpy.exceptions import (
    InvalidParameterTypeException,
)
from rclpy.parameter import (
    Parameter,
    parameter_dict_from_yaml_file,
    parameter_value_to_python,
)

Type = Parameter.Type


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
    stored = node.get_parameter("p").value
    assert (list(stored) if isinstance(value, list) else stored) == value


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
