import pytest
from geometry_msgs.msg import Twist
from sensor_msgs.msg import LaserScan

from coursekit.lab.form import filled, schema


def test_each_field_has_the_control_of_its_type():
    controls = {field["name"]: field["control"] for field in schema(LaserScan)}
    assert controls["header"] == "group"
    assert controls["range_max"] == "number"
    assert controls["ranges"] == "list"


def test_nested_fields_are_filled():
    assert filled(Twist(), {"angular": {"z": "1.5"}}).angular.z == 1.5


def test_a_nested_field_that_does_not_exist_is_named_with_its_path():
    with pytest.raises(ValueError, match=r"no field 'linear.w'. There are: x, y, z"):
        filled(Twist(), {"linear": {"w": 1}})


def test_lists_are_typed_as_in_yaml():
    assert list(filled(LaserScan(), {"ranges": "[1.0, 2.0]"}).ranges) == [1.0, 2.0]
    with pytest.raises(ValueError, match="ranges: '7' is not a list"):
        filled(LaserScan(), {"ranges": "7"})


def test_every_message_has_a_form_whose_values_fill_it():
    for field in schema(Twist):
        for inner in field["fields"]:
            assert float(inner["value"]) == 0.0
