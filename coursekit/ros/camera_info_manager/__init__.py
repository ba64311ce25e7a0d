"""A camera's calibration, stored in a file and available as CameraInfo.

In ROS 2: the Python module of the package camera_info_manager_py.
"""

from .camera_info_manager import (
    CameraInfoError,
    CameraInfoManager,
    CameraInfoMissingError,
    default_camera_info_url,
    loadCalibrationFile,
    resolveURL,
    saveCalibrationFile,
)

__all__ = [
    "CameraInfoError",
    "CameraInfoManager",
    "CameraInfoMissingError",
    "default_camera_info_url",
    "loadCalibrationFile",
    "resolveURL",
    "saveCalibrationFile",
]
