import pytest
from rclpy import exceptions
from rclpy.parameter import Parameter


@pytest.mark.parametrize(
    ("error", "args"),
    [
        (
            exceptions.NotInitializedException("cannot create node"),
            ("rclpy.init() has not been called", "cannot create node"),
        ),
        (exceptions.ParameterNotDeclaredException("p"), ("Invalid access to undeclared parameter(s)", "p")),
        (
            exceptions.ParameterNotDeclaredException(["p"]),
            ("Invalid access to undeclared parameter(s)", ["p"]),
        ),
        (exceptions.ParameterAlreadyDeclaredException(["p"]), ("Parameter(s) already declared", ["p"])),
        (exceptions.ParameterImmutableException("p"), ("Attempted to modify read-only parameter", "p")),
        (exceptions.ParameterUninitializedException("p"), ("The parameter 'p' is not initialized", "p")),
        (exceptions.InvalidParameterException("p"), ("Invalid parameter name", "p")),
        (exceptions.ROSInterruptException(), ("rclpy.shutdown() has been called",)),
        (exceptions.NoTypeSupportImportedException(), ("no type_support imported",)),
    ],
)
def test_errors_carry_humbles_arguments(error, args):
    assert error.args == args


def test_a_wrong_type_is_told_with_value_and_types():
    error = exceptions.InvalidParameterTypeException(Parameter("p", value=1), "STRING")
    assert "Trying to set parameter 'p' to '1' of type 'INTEGER', expecting type 'STRING'" in str(error)


def test_a_bad_value_is_told_with_its_reason():
    error = exceptions.InvalidParameterValueException("p", 1, "too small")
    assert "Invalid parameter value (1) for parameter. Reason: too small" in str(error)


def test_a_bad_name_keeps_its_parts():
    error = exceptions.InvalidTopicNameException("a b", "no spaces", 1)
    assert (error.name_type, error.invalid_name, error.error_msg, error.invalid_index) == (
        "topic name",
        "a b",
        "no spaces",
        1,
    )
