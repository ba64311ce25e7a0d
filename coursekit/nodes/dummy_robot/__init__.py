"""The dummy robot: a made-up map, scan and joint states for RViz."""
