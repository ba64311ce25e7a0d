"""Programs under the names of C++ packages have in their nodes what rclcpp gives to each node."""

import pytest

ROBOT = ("--ros-args", "-p", "robot_description:=<robot name='r'><link name='l'/></robot>")
BURGER = ("--ros-args", "-p", "burger_mode:=true")
PROGRAMS = [
    *(("demo_nodes_cpp", name) for name in ("talker", "listener", "listener_best_effort", "add_two_ints_server")),
    *(("demo_nodes_cpp", name) for name in ("talker_serialized_message", "listener_serialized_message", "reuse_timer")),
    *(
        ("demo_nodes_cpp", name)
        for name in ("talker_loaned_message", "content_filtering_subscriber", "even_parameters_node")
    ),
    ("demo_nodes_cpp", "parameter_event_handler"),
    *(("composition", name) for name in ("manual_composition", "linktime_composition", "talker_component")),
    *(("intra_process_demo", name) for name in ("two_node_pipeline", "cyclic_pipeline")),
    *(("examples_rclcpp_minimal_publisher", name) for name in ("publisher_lambda", "publisher_wait_for_all_acked")),
    ("examples_rclcpp_minimal_subscriber", "subscriber_lambda"),
    ("examples_rclcpp_minimal_service", "service_main"),
    ("examples_rclcpp_minimal_timer", "timer_lambda"),
    ("quality_of_service_demo_cpp", "deadline", "600"),
    *(("quality_of_service_demo_cpp", f"message_lost_{name}") for name in ("talker", "listener")),
    *(("quality_of_service_demo_cpp", f"qos_overrides_{name}") for name in ("talker", "listener")),
    ("image_tools", "cam2image", *BURGER),
    ("logging_demo", "logging_demo_main"),
    ("lifecycle", "lifecycle_listener"),
    ("action_tutorials_cpp", "fibonacci_action_server"),
    ("dummy_map_server", "dummy_map_server"),
    *(("dummy_sensors", f"dummy_{name}") for name in ("laser", "joint_states")),
    *(("turtle_tf2_cpp", f"turtle_tf2_{name}") for name in ("broadcaster", "listener", "message_filter")),
    ("turtle_tf2_cpp", "static_turtle_tf2_broadcaster", "snail", "0", "0", "1", "0", "0", "0"),
    ("robot_state_publisher", "robot_state_publisher", *ROBOT),
    ("teleop_twist_joy", "teleop_node"),
    ("joy", "joy_node"),
]


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda words: "-".join(words[:2]))
def test_each_node_has_the_qos_of_its_parameter_events(session, run, ros2, program):
    run(*program)
    session.clock.sleep(0.3)
    nodes = ros2("node", "list").split()
    assert nodes
    for node in nodes:
        assert "  qos_overrides./parameter_events.publisher.depth\n" in ros2("param", "list", node), node
        subscribers = ros2("node", "info", node).partition("Subscribers:")[2].partition("Publishers:")[0]
        assert "/parameter_events: rcl_interfaces/msg/ParameterEvent" in subscribers, node
