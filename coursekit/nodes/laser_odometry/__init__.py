"""rf2o_laser_odometry: the motion of a robot, from its laser alone."""
