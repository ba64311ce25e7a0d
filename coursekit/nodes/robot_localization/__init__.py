"""robot_localization: the estimation of a robot's pose from several sensors."""
