"""Conversion between pixels and rays, with camera models from CameraInfo.

In ROS 2: the Python module of the package image_geometry.
"""

from .cameramodels import PinholeCameraModel, StereoCameraModel

__all__ = ["PinholeCameraModel", "StereoCameraModel"]
