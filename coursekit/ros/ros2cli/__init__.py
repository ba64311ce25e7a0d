"""ROS 2's command line for programs and tests."""
