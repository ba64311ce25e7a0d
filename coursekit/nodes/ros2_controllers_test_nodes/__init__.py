"""ros2_controllers_test_nodes: programs that send a controller its goals in turn."""
