"""Driving by keys: the node of teleop_twist_keyboard."""
