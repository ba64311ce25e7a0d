"""The newer Gazebo: its worlds, its own topics alongside ROS topics, and the bridges between them."""
