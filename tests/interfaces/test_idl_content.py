"""rosidl_parser: what a text in IDL says."""

from pathlib import Path

import pytest
from rosidl_parser.definition import Action, BasicType, IdlLocator, Include, Message, Service
from rosidl_parser.parser import parse_idl_file, parse_idl_string
from rosidl_runtime_py import get_interface_path

from coursekit.interfaces.errors import InterfaceError

REACH = """
#include "geometry_msgs/msg/Point.idl"
module arm { module msg {
  typedef double double__2[2];
  module Reach_Constants { const uint8 NEAR = 3; };
  struct Reach { @default (value=1.5) double far; geometry_msgs::msg::Point at; double__2 pair; sequence<string, 4> names; };
}; };
"""


def test_a_message_has_members_constants_and_defaults():
    content = parse_idl_string(REACH)
    [message] = content.get_elements_of_type(Message)
    assert [include.locator for include in content.get_elements_of_type(Include)] == ["geometry_msgs/msg/Point.idl"]
    assert message.structure.namespaced_type.namespaced_name() == ("arm", "msg", "Reach")
    far, at, pair, names = message.structure.members
    assert (far.name, far.type, far.get_annotation_value("default")) == ("far", BasicType("double"), {"value": 1.5})
    assert at.type.namespaced_name() == ("geometry_msgs", "msg", "Point") and not at.has_annotation("default")
    assert (pair.type.size, names.type.maximum_size) == (2, 4)
    assert [(each.name, each.value) for each in message.constants] == [("NEAR", 3)]


def test_a_service_has_a_request_and_a_response():
    text = "module arm { module srv { struct Go_Request { double x; }; struct Go_Response { boolean ok; }; }; };"
    [service] = parse_idl_string(text).elements
    assert isinstance(service, Service) and service.namespaced_type.namespaced_name() == ("arm", "srv", "Go")
    assert service.request_message.structure.members[0].name == "x"
    assert service.response_message.structure.members[0].type == BasicType("boolean")


def test_an_action_has_what_carries_its_parts():
    path = Path(get_interface_path("test_msgs/action/Fibonacci.idl"))
    content = parse_idl_file(IdlLocator(path.parent, path.name)).content
    [action] = content.get_elements_of_type(Action)
    assert [member.name for member in action.send_goal_service.request_message.structure.members] == ["goal_id", "goal"]
    assert action.get_result_service.response_message.structure.namespaced_type.name == "Fibonacci_GetResult_Response"
    assert action.feedback_message.structure.namespaced_type.name == "Fibonacci_FeedbackMessage"
    assert "unique_identifier_msgs/msg/UUID.idl" in [include.locator for include in content.get_elements_of_type(Include)]


def test_other_text_is_refused():
    with pytest.raises(InterfaceError):
        parse_idl_string("struct {")
