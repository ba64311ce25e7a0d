"""What `ros2 run` offers to Python programs, in `ros2run.api`."""
