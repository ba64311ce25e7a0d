"""CameraInfoManager and the files it reads and writes."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import yaml
from ament_index_python.packages import PackageNotFoundError, get_package_share_directory
from rclpy.node import Node
from sensor_msgs.msg import CameraInfo
from sensor_msgs.srv import SetCameraInfo

from coursekit.files import read_text, write_whole
from coursekit.systems.uris import path_of

default_camera_info_url = "file://${ROS_HOME}/camera_info/${NAME}.yaml"
"""The URL of a calibration for which no URL is given."""
_MATRICES = {"camera_matrix": ("k", 3, 3), "rectification_matrix": ("r", 3, 3), "projection_matrix": ("p", 3, 4)}


UNREADABLE = (ValueError, RecursionError, yaml.YAMLError, LookupError, TypeError, AttributeError, AssertionError)
"""The errors raised by a text without a valid calibration."""


class CameraInfoError(Exception):
    """The base class of calibration errors."""


class CameraInfoMissingError(CameraInfoError):
    """No calibration has been loaded yet: call `loadCameraInfo` first."""


def resolveURL(url: str, cname: str) -> str:
    """A URL with ${NAME} and ${ROS_HOME} filled in.

    >>> resolveURL("file:///calibrations/${NAME}.yaml", "left")
    'file:///calibrations/left.yaml'
    """
    home = os.environ.get("ROS_HOME", str(Path.home() / ".ros"))
    return url.replace("${NAME}", cname).replace("${ROS_HOME}", home)


def _file_of(url: str) -> Path:
    """The file of a file:// or package:// URL; raises CameraInfoError for any other URL."""
    if url.startswith("package://"):
        package, _, rest = url.removeprefix("package://").partition("/")
        try:
            return Path(get_package_share_directory(package)) / rest
        except PackageNotFoundError as fault:
            raise CameraInfoError(f"{url}: {fault}") from fault
    if url.startswith("file://"):
        return path_of(url)
    raise CameraInfoError(f"Invalid camera info URL: '{url}': give file:///PATH or package://PACKAGE/PATH")


def loadCalibrationFile(filename: str, cname: str) -> CameraInfo:
    """The calibration in a file; an empty one if there is no file. Raises CameraInfoError if it cannot be parsed."""
    path = Path(filename)
    if not path.is_file():
        return CameraInfo()
    try:
        return calibration_of(read_text(path))[1]
    except (OSError, *UNREADABLE) as fault:
        raise CameraInfoError(f"{filename} holds no calibration of '{cname}': {type(fault).__name__}: {fault}") from fault


def calibration_of(text: str) -> tuple[str, CameraInfo]:
    """The camera's name and the calibration in a calibrator's YAML; raises one of UNREADABLE if it holds none."""
    told = yaml.safe_load(text)
    return (str(told.get("camera_name", "")), _info_of(told)) if told else ("", CameraInfo())


def _info_of(told: dict[str, Any]) -> CameraInfo:
    info = CameraInfo(width=int(told["image_width"]), height=int(told["image_height"]))
    info.distortion_model = str(told["distortion_model"])
    info.d = [float(number) for number in told["distortion_coefficients"]["data"]]
    for name, (field, _, _) in _MATRICES.items():
        setattr(info, field, [float(number) for number in told[name]["data"]])
    return info


def calibration_text(ci: CameraInfo, cname: str) -> str:
    """A calibration as YAML, in the format of the calibrator."""
    told: dict[str, Any] = {"image_width": ci.width, "image_height": ci.height, "camera_name": cname}
    told["distortion_model"] = ci.distortion_model
    told["distortion_coefficients"] = {"data": [float(number) for number in ci.d], "rows": 1, "cols": len(ci.d)}
    for name, (field, rows, columns) in _MATRICES.items():
        told[name] = {"data": [float(number) for number in getattr(ci, field)], "rows": rows, "cols": columns}
    return yaml.safe_dump(told, sort_keys=False)  # type: ignore[no-any-return]


def saveCalibrationFile(ci: CameraInfo, filename: str, cname: str) -> bool:
    """Write a calibration to a file. Return whether that succeeded."""
    try:
        Path(filename).parent.mkdir(parents=True, exist_ok=True)
        write_whole(filename, calibration_text(ci, cname))
    except OSError:
        return False
    return True


class CameraInfoManager:
    """Loads a camera's calibration from its URL and lets calibrators set it with the service set_camera_info."""

    def __init__(self, node: Node, cname: str = "camera", url: str = "", namespace: str = "") -> None:
        self.node, self.cname, self.url = node, cname, url
        self.camera_info: CameraInfo | None = None
        name = f"{namespace.rstrip('/')}/set_camera_info" if namespace else "set_camera_info"
        self.svc = node.create_service(SetCameraInfo, name, self._set)

    def _place(self) -> Path:
        return _file_of(resolveURL(self.url or default_camera_info_url, self.cname))

    def loadCameraInfo(self) -> None:
        """Read the calibration again. If it cannot be read, log an error and use an empty one."""
        try:
            self.camera_info = loadCalibrationFile(str(self._place()), self.cname)
        except CameraInfoError as fault:
            self.node.get_logger().error(str(fault))
            self.camera_info = CameraInfo()

    def getCameraInfo(self) -> CameraInfo:
        """The calibration; raises CameraInfoMissingError if none has been loaded."""
        if self.camera_info is None:
            raise CameraInfoMissingError("Calibration missing, loadCameraInfo() needed")
        return self.camera_info

    def isCalibrated(self) -> bool:
        """Whether the calibration holds values."""
        return bool(self.getCameraInfo().k[0])

    def getCameraName(self) -> str:
        """The camera's name."""
        return self.cname

    def setCameraName(self, cname: str) -> bool:
        """Set the name. Return False if it is empty or contains characters other than letters, digits and _."""
        if not cname or not all(letter.isalnum() or letter == "_" for letter in cname):
            return False
        if cname != self.cname:
            self.cname, self.camera_info = cname, None
        return True

    def getURL(self) -> str:
        """The URL of the calibration."""
        return self.url

    def setURL(self, url: str) -> bool:
        """Set the URL. Return False if it is invalid."""
        if url:
            try:
                _file_of(resolveURL(url, self.cname))
            except CameraInfoError:
                return False
        if url != self.url:
            self.url, self.camera_info = url, None
        return True

    def _set(self, request: Any, response: Any) -> Any:
        self.camera_info = request.camera_info
        try:
            response.success = saveCalibrationFile(request.camera_info, str(self._place()), self.cname)
            response.status_message = "" if response.success else "Error storing camera calibration."
        except CameraInfoError as fault:
            response.success, response.status_message = False, str(fault)
        return response
