"""What programs and tests import of ROS 2's command line."""
