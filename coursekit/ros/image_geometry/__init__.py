"""Between pixels and rays: cameras as CameraInfo describes them.

In ROS 2: the Python module of the package image_geometry.
"""

from .cameramodels import PinholeCameraModel, StereoCameraModel

__all__ = ["PinholeCameraModel", "StereoCameraModel"]
