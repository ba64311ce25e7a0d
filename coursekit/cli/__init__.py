"""The commands `ros2` and `coursekit`: one parser, used by shell, notebook and terminals alike."""
