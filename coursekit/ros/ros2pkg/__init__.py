"""What `ros2 pkg` offers to Python programs, in `ros2pkg.api`."""
