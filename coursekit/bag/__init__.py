"""Bags: folders of recorded messages, written and read as by rosbag2 of ROS 2 Humble. Files only: no graph, no clock."""
