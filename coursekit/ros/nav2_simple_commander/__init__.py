"""Navigation in a few lines of Python. In ROS 2: nav2_simple_commander."""
