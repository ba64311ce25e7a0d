"""What is known of an endpoint: only values of the right type, and words for what is not known."""

import pytest
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from rclpy.topic_endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum


def test_fields_may_be_given_or_set():
    values = {
        "node_name": "talker",
        "node_namespace": "/",
        "topic_type": "std_msgs/msg/String",
        "endpoint_type": TopicEndpointTypeEnum.PUBLISHER,
        "endpoint_gid": [1, 2],
        "qos_profile": QoSProfile(depth=3),
    }
    for name, value in values.items():
        info = TopicEndpointInfo()
        setattr(info, name, value)
        assert info == TopicEndpointInfo(**{name: value}) != TopicEndpointInfo()
        assert getattr(info, name) == getattr(info, f"_{name}") == value


def test_a_number_and_a_dictionary_will_do():
    info = TopicEndpointInfo(endpoint_type=2, qos_profile={"depth": 4})
    assert info.endpoint_type is TopicEndpointTypeEnum.SUBSCRIPTION and info.qos_profile.depth == 4


@pytest.mark.parametrize("wrong", [{"node_name": 1}, {"endpoint_gid": "12"}, {"qos_profile": 10}, {"colour": "red"}])
def test_other_values_are_refused(wrong):
    with pytest.raises(AssertionError):
        TopicEndpointInfo(**wrong)


def test_it_is_told_line_by_line():
    unknown = str(TopicEndpointInfo()).splitlines()
    assert unknown[3:8] == [
        "Endpoint type: INVALID",
        "GID: ",
        "QoS profile:",
        "  Reliability: UNKNOWN",
        "  History (Depth): UNKNOWN",
    ]
    assert "  History (Depth): KEEP_LAST (5)" in str(TopicEndpointInfo(qos_profile=qos_profile_sensor_data))
