"""Bags: folders of recorded messages, as rosbag2 of ROS 2 Humble writes and reads them. Files only: no graph, no clock."""
