"""ros2_control: hardware from a description, controllers that move it, and the controller manager."""
