"""RViz: its configuration, and the node that a launch file starts. Its content is drawn by coursekit.view and lab."""
