"""coursekit: a ROS 2 course as notebooks that needs no ROS install."""
