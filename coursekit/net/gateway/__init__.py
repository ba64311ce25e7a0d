"""The gateway: a program for the robot's own Python, between its middleware and notebooks.

It is written to one file with the folder `wire`, so it imports nothing else of coursekit. It uses the rclpy that is
there, whatever its rmw: every node of the other side becomes a node of ROS here, with its own name.
"""
