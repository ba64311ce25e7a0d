"""The part that real rclpy has in C++."""
