"""Drivers of cameras: nodes that publish what a device or a file shows."""
