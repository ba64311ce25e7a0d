"""rqt's windows: a notebook shows the panel that does the same. In ROS 2: rqt_graph, rqt_console, rqt."""
