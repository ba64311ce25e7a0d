import pytest
from rcl_interfaces.msg import (
    ParameterType,
    ParameterValue,
)
from rclpy.parameter import (
    Parameter,
    get_parameter_value,
    parameter_value_to_python,
)

Type = Parameter.Type


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
