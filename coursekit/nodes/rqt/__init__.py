"""rqt's windows, which a notebook shows as equivalent panels. In ROS 2: rqt_graph, rqt_console, rqt."""
