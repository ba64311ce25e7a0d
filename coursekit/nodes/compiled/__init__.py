"""Compiled rclcpp programs as processes of the session: what they ask is carried out here, by rclpy."""
