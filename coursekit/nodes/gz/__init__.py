"""The newer Gazebo's names: its world, its topics beside those of ROS, and the bridges between the two."""
