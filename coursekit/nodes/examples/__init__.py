"""The packages examples_rclpy_* and examples_rclcpp_*: the smallest nodes of each kind."""
