"""RViz: its configuration, and the node that a launch file starts. What it shows is drawn by coursekit.view and lab."""
