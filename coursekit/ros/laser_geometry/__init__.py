"""Conversion of laser scans to point clouds.

In ROS 2: the Python module of the package laser_geometry.
"""

from .laser_geometry import LaserProjection

__all__ = ["LaserProjection"]
