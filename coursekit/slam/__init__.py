"""SLAM as numbers in, numbers out: laser scans and odometry become a trajectory and a map. No ROS here."""
