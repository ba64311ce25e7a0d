"""The gateway: a program for the robot's own Python, between its middleware and notebooks.

It is bundled into one file with the folder `wire`, so it imports nothing else of coursekit. It uses the installed
rclpy, with any rmw: every remote node becomes a ROS node here, under its own name.
"""
