"""Compiled rclcpp programs as processes of the session: rclpy carries out their requests."""
