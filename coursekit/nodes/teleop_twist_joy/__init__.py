"""teleop_twist_joy: driving with a gamepad."""
