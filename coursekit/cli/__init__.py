"""The commands `ros2` and `coursekit`: one parser for the shell, notebooks and terminals."""
