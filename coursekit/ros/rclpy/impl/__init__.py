"""The part that real rclpy implements in C++."""
