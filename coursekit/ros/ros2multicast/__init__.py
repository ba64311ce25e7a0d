"""What programs and tests import of `ros2 multicast`."""
