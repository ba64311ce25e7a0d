"""robot_localization: where a robot is, from several sensors together."""
