"""`ros2 pkg` for Python programs: `ros2pkg.api`."""
