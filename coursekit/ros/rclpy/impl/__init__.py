"""What stands where real rclpy has its C++ part."""
