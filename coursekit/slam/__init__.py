"""SLAM with plain numbers in and out: laser scans and odometry become a trajectory and a map. No ROS here."""
