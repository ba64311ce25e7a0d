"""rosidl_runtime_py: messages as text and from dictionaries, interfaces by name."""

import pytest
import yaml
from geometry_msgs.msg import PoseStamped, Quaternion, Twist
from rosidl_runtime_py import (
    get_interface_path,
    get_interfaces,
    get_message_interfaces,
    get_message_slot_types,
    import_message_from_namespaced_type,
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
    set_message_fields,
)
from rosidl_runtime_py.utilities import get_action, get_interface, get_message, get_service
from sensor_msgs.msg import JointState, LaserScan
from std_msgs.msg import Header, String
from test_msgs.msg import Arrays, BasicTypes, BoundedSequences, Nested, UnboundedSequences

from tests.needs import slashed


def test_primitive_sequences_stand_in_block_style():
    text = message_to_yaml(LaserScan(ranges=[0.0, 1.5]))
    assert "ranges:\n- 0.0\n- 1.5\nintensities: []\n" in text
    assert text.startswith("header:\n  stamp:\n    sec: 0\n    nanosec: 0\n  frame_id: ''\nangle_min: 0.0\n")


def test_text_that_looks_like_a_number_is_quoted_and_unicode_is_not_escaped():
    assert message_to_yaml(String(data="123")) == "data: '123'\n"
    assert message_to_yaml(String(data="ハロー")) == "data: ハロー\n"


def test_long_values_are_truncated():
    scan = LaserScan(ranges=[float(i) for i in range(200)])
    lines = message_to_yaml(scan, truncate_length=128).splitlines()
    assert lines.count("- '...'") == 1 and lines[lines.index("- '...'") - 1] == "- 127.0"
    assert message_to_yaml(String(data="abcdef"), truncate_length=3) == "data: abc...\n"
    assert message_to_csv(String(data="abcdef"), truncate_length=3) == "abc..."


def test_arrays_can_be_left_out():
    text = message_to_yaml(Arrays(), no_arr=True)
    assert "int32_values: '<array type: int32[3]>'\n" in text
    text = message_to_yaml(UnboundedSequences(float64_values=[1.0] * 3), no_arr=True)
    assert "float64_values: '<sequence type: double, length: 3>'\n" in text
    assert "basic_types_values: '<sequence type: test_msgs/msg/BasicTypes, length: 0>'" in text
    assert "'<sequence type: boolean[3], length: 0>'" in message_to_yaml(BoundedSequences(), no_arr=True)


def test_strings_can_be_left_out():
    assert message_to_yaml(String(data="hello there fn"), no_str=True) == "data: '<string length: <14>>'\n"


def test_flow_style_writes_lists_in_one_line():
    assert "name: [a, b]\n" in message_to_yaml(JointState(name=["a", "b"]), flow_style=True)


def test_csv_has_no_names():
    pose = PoseStamped()
    assert message_to_csv(pose) == "0,0,,0.0,0.0,0.0,0.0,0.0,0.0,1.0"
    assert message_to_csv(LaserScan(ranges=[1.0, 2.0])).endswith(",1.0,2.0,")


def test_bytes_are_shown_as_characters():
    assert message_to_ordereddict(BasicTypes(byte_value=b"A"))["byte_value"] == "A"


def test_yaml_can_be_put_back():
    message = Nested(basic_types_value=BasicTypes(int32_value=7))
    values = yaml.safe_load(message_to_yaml(message))
    values["basic_types_value"].pop("byte_value")
    again = Nested()
    set_message_fields(again, values)
    assert again == message


def test_fields_are_set_and_converted():
    twist = Twist()
    assert set_message_fields(twist, {"linear": {"x": 2}, "angular": {"z": 1.8}}) == []
    assert (twist.linear.x, twist.angular.z) == (2.0, 1.8)
    message = UnboundedSequences()
    set_message_fields(message, {"int32_values": [1, 2], "basic_types_values": [{"int8_value": 3}]})
    assert message.int32_values.tolist() == [1, 2] and message.basic_types_values[0].int8_value == 3
    arrays = Arrays()
    set_message_fields(arrays, {"float64_values": [1, 2, 3]})
    assert arrays.float64_values.tolist() == [1.0, 2.0, 3.0]


@pytest.mark.parametrize(
    ("values", "error"),
    [({"x": "y"}, ValueError), ({"q": 1.0}, AttributeError), ("text", TypeError), (None, TypeError)],
)
def test_bad_values_are_refused(values, error):
    with pytest.raises(error):
        set_message_fields(Quaternion(), values)


def test_header_auto_and_time_now_are_left_for_later():
    pose = PoseStamped()
    setters = set_message_fields(pose, {"header": "auto"}, expand_header_auto=True)
    assert len(setters) == 1
    from builtin_interfaces.msg import Time

    setters[0](Time(sec=5))
    assert pose.header.stamp.sec == 5
    header = Header()
    set_message_fields(header, {"stamp": "now"}, expand_time_now=True)[0](Time(sec=6))
    assert header.stamp.sec == 6
    with pytest.raises(TypeError):
        set_message_fields(pose, {"header": "auto"})


def test_interfaces_are_listed_by_package():
    assert get_interfaces(["std_srvs"]) == {"std_srvs": ["srv/Empty", "srv/SetBool", "srv/Trigger"]}
    assert "msg/Twist" in get_message_interfaces()["geometry_msgs"]
    with pytest.raises(LookupError, match="Unknown package 'nope'"):
        get_interfaces(["nope"])


def test_definition_files_are_found():
    assert slashed(get_interface_path("std_msgs/msg/String")).endswith("share/std_msgs/msg/String.msg")
    with pytest.raises(LookupError, match="Could not find the interface"):
        get_interface_path("std_msgs/msg/Nope")
    with pytest.raises(ValueError, match="at least two parts"):
        get_interface_path("String")


def test_classes_are_found_by_name():
    assert get_message("std_msgs/String") is String is get_interface("std_msgs/msg/String")
    assert get_service("std_srvs/srv/Empty").__name__ == "Empty"
    assert get_action("test_msgs/action/Fibonacci").__name__ == "Fibonacci"
    with pytest.raises(ValueError, match="Expected the full name of a message, got 'std_srvs/srv/Empty'"):
        get_message("std_srvs/srv/Empty")
    with pytest.raises(ModuleNotFoundError):
        get_message("nope_msgs/msg/X")
    with pytest.raises(AttributeError):
        get_message("std_msgs/msg/Nope")


def test_the_package_itself_leads_from_a_field_to_its_class():
    assert import_message_from_namespaced_type(get_message_slot_types(PoseStamped())["header"]) is Header
