"""Teleoperation with the keyboard: the node of teleop_twist_keyboard."""
