"""The gateway: a program for the robot's own Python, which stands between its middleware and notebooks.

It is written to one file with the folder `wire`, so it imports nothing else of coursekit. It stands on the rclpy that is
there, whatever its rmw: every node of the other side becomes a node of ROS here, with its own name.
"""
