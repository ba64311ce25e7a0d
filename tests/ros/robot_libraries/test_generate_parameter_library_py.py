"""generate_parameter_library_py: what the module of a YAML file of parameters does on a node."""

from __future__ import annotations

import math
import sys
from types import ModuleType

import pytest
import rclpy
from generate_parameter_library_py import setup_helper
from generate_parameter_library_py.generate_python_module import python_module, run
from rclpy.exceptions import InvalidParameterValueException, ParameterUninitializedException
from rclpy.parameter import Parameter

from coursekit.cpp.parameter_library import read_parameters
from coursekit.processes.session import Session

YAML = """
arm:
  rate: {type: double, default_value: 50.0, description: "How often, in 'Hz'", validation: {gt<>: [0.0], lt_eq<>: [1000.0]}}
  joints: {type: string_array, default_value: [hip, knee], validation: {unique<>: null, "custom_validators::short": [8]}}
  mode: {type: string, default_value: slow, read_only: true, additional_constraints: "slow or fast"}
  load: {type: double, default_value: .NAN}
  count: {type: int, default_value: 3, validation: {gt_eq<>: [1]}}
  tag: {type: string_fixed_4, default_value: tag}
  filter: {type: none, description: "read by another library"}
  pid:
    rate: {type: double, default_value: 0.5}
    __map_joints:
      p: {type: double, default_value: 2.5, validation: {gt_eq<>: [0.5]}}
      limit: {high: {type: int, default_value: 7}}
  legs:
    names: {type: string_array, default_value: [left]}
    __map_names: {length: {type: double, default_value: 1.0}}
"""
CHECKS = ModuleType("arm_checks")
CHECKS.short = lambda param, length: "too long" if any(len(name) > length for name in param.value) else ""


@pytest.fixture
def arm(tmp_path, monkeypatch):
    """The class of a module that has been written."""
    monkeypatch.setitem(sys.modules, "arm_checks", CHECKS)
    file, module = tmp_path / "arm.yaml", tmp_path / "made" / "arm_parameters.py"
    file.write_text(YAML, encoding="utf-8")
    run(str(module), str(file), "arm_checks")
    namespace: dict = {"__name__": "arm_parameters"}
    exec(compile(module.read_text(encoding="utf-8"), str(module), "exec"), namespace)
    return namespace["arm"]


@pytest.fixture
def node():
    with Session(virtual=True).use():
        rclpy.init()
        yield rclpy.create_node("arm")
        rclpy.shutdown()


def test_defaults_are_declared_and_told(arm, node):
    params = arm.ParamListener(node).get_params()
    assert (params.rate, params.joints, params.mode, params.tag) == (50.0, ["hip", "knee"], "slow", "tag")
    assert params.pid.rate == 0.5
    assert math.isnan(params.load) and not hasattr(params, "filter") and not node.has_parameter("filter")
    assert node.get_parameter("pid.hip.p").value == 2.5 and params.pid.get_entry("knee").limit.high == 7
    assert params.legs.get_entry("left").length == node.get_parameter("legs.left.length").value == 1.0
    told = node.describe_parameter("rate")
    assert told.description == "How often, in 'Hz'" and told.floating_point_range[0].to_value == 1000.0
    told = node.describe_parameter("mode")
    assert told.read_only and told.additional_constraints == "slow or fast"
    limits = node.describe_parameter("count").integer_range[0]
    assert (limits.from_value, limits.to_value) == (1, 2**31 - 1)


def test_values_that_are_set_are_checked_and_taken(arm, node):
    listener, heard = arm.ParamListener(node), []
    listener.set_user_callback(lambda params: heard.append(params.rate))
    before = listener.get_params()
    assert node.set_parameters([Parameter("rate", value=20.0)])[0].successful
    assert listener.is_old(before) and listener.get_params().rate == 20.0 and before.rate == 50.0
    [result] = node.set_parameters([Parameter("joints", value=["hip", "hip"])])
    assert not result.successful and result.reason == "Parameter 'joints' must only contain unique values"
    [result] = node.set_parameters([Parameter("joints", value=["shoulder blade"])])
    assert result.reason == "too long" and listener.get_params().joints == ["hip", "knee"]
    [result] = node.set_parameters([Parameter("pid.hip.p", value=0.1)])
    assert not result.successful and result.reason == "Parameter pid.hip.p out of range Min: 0.5, Max: inf, value: 0.1"
    listener.clear_user_callback()
    node.set_parameters([Parameter("pid.knee.p", value=4.0)])
    assert listener.get_params().pid.get_entry("knee").p == 4.0 and heard == [20.0]


def test_new_names_get_entries_when_it_is_refreshed(arm, node):
    listener = arm.ParamListener(node)
    node.set_parameters([Parameter("joints", value=["ankle"])])
    assert not node.has_parameter("pid.ankle.p")
    listener.refresh_dynamic_parameters()
    assert node.get_parameter("pid.ankle.p").value == 2.5 and listener.get_params().pid.get_entry("ankle").p == 2.5


def test_a_prefix_stands_before_the_names_and_a_dictionary_is_taken(arm, node):
    listener = arm.ParamListener(node, "left.")
    assert node.get_parameter("left.pid.hip.p").value == 2.5 and not node.has_parameter("rate")
    listener.set_params_from_dict({"left": {"rate": 5.0, "pid": {"hip": {"p": 9.0}}}})
    params = listener.get_params()
    assert (params.rate, params.pid.get_entry("hip").p) == (5.0, 9.0)


def test_a_value_that_is_given_and_wrong_is_refused(arm, node):
    node.declare_parameter("tag", "a long tag")
    with pytest.raises(InvalidParameterValueException, match="initialization for parameter tag: Length of parameter 'tag'"):
        arm.ParamListener(node)


def test_a_parameter_without_a_value_has_to_be_given(node, tmp_path):
    file = tmp_path / "arm.yaml"
    file.write_text("arm: {name: {type: string}}", encoding="utf-8")
    namespace: dict = {}
    exec(python_module(read_parameters(file)), namespace)
    with pytest.raises(ParameterUninitializedException):
        namespace["arm"].ParamListener(node)


@pytest.mark.parametrize(
    "text, told",
    [("a::b: {x: {type: int}}", "cannot be a name in Python"), ("a: {x.y: {type: int}}", "cannot be a name in Python"),
     ("a: {x: {type: int, validation: {'f(1); gt': [1]}}}", "cannot be the name of a check"),
     ("a: {x: {type: int, validation: {odd: null}}}", "there is no check 'odd' in Python; there are: bounds, element"),
     ("a: {class: {type: int}}", "'class' cannot be a name in Python"), ("a: {x: {type: float}}", "Invalid parameter type")],
)  # fmt: skip
def test_a_wrong_file_ends_the_build_with_what_is_wrong(text, told, tmp_path):
    file = tmp_path / "arm.yaml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(SystemExit, match=told):
        run(str(tmp_path / "arm_parameters.py"), str(file))
    assert not (tmp_path / "arm_parameters.py").exists()


@pytest.mark.parametrize("module", ["a..b", "class.checks", "a, os", "1a"])
def test_a_module_with_checks_has_a_name_that_can_be_imported(module, tmp_path):
    file = tmp_path / "arm.yaml"
    file.write_text("arm: {x: {type: int}}", encoding="utf-8")
    with pytest.raises(SystemExit, match="cannot be a name in Python"):
        run(str(tmp_path / "arm_parameters.py"), str(file), module)


def test_setup_py_that_does_not_build_writes_nothing(monkeypatch):
    monkeypatch.setattr(sys, "argv", ["setup.py", "--help-commands"])
    setup_helper.generate_parameter_module("arm_parameters", "no such file.yaml")
