"""ros2_control: hardware that a description names, controllers that move it, and the manager of both."""
