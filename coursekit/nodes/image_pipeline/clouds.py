"""Clouds of points from depth images, as depth_image_proc lays them out."""

from __future__ import annotations

from typing import Any

import numpy as np
from cv_bridge import CvBridge
from image_geometry import PinholeCameraModel
from sensor_msgs.msg import CameraInfo, Image, PointCloud2, PointField

MILLIMETRES, METRES = "16UC1", "32FC1"
_PLAIN = np.dtype({"names": ["x", "y", "z"], "formats": ["<f4"] * 3, "offsets": [0, 4, 8], "itemsize": 16})
_COLORED = np.dtype(
    {"names": ["x", "y", "z", "rgb"], "formats": ["<f4", "<f4", "<f4", "<u4"], "offsets": [0, 4, 8, 16], "itemsize": 32}
)


def metres_of(depth: Image) -> Any:
    """Return a depth image in metres, NaN where nothing was measured; ValueError for another encoding.

    >>> depth = CvBridge().cv2_to_imgmsg(np.array([[1500, 0]], np.uint16), "16UC1")
    >>> metres_of(depth).round(2).tolist()
    [[1.5, nan]]
    """
    if depth.encoding not in (MILLIMETRES, METRES):
        raise ValueError(f"Depth image has unsupported encoding [{depth.encoding}]")
    raw = np.asarray(CvBridge().imgmsg_to_cv2(depth))
    metres = raw.astype(np.float32) * (1e-3 if depth.encoding == MILLIMETRES else 1.0)
    nothing = raw == 0 if depth.encoding == MILLIMETRES else ~np.isfinite(raw)
    return np.where(nothing, np.float32(np.nan), metres)


def cloud_of(depth: Image, info: CameraInfo, colors: Any = None) -> PointCloud2:
    """Return a cloud with a point for each pixel, in the camera's optical frame; ValueError for an encoding or a lens.

    `colors` are red, green and blue of each pixel.
    """
    model = PinholeCameraModel()
    model.fromCameraInfo(info)
    if not (model.fx() > 0 and model.fy() > 0):
        raise ValueError(f"the camera's focal lengths are {model.fx():g} and {model.fy():g}: check its camera_info")
    z = metres_of(depth)
    points = np.zeros(z.shape, _PLAIN if colors is None else _COLORED)
    rows, columns = np.indices(z.shape)
    points["x"], points["y"] = (columns - model.cx()) * z / model.fx(), (rows - model.cy()) * z / model.fy()
    points["z"] = z
    if colors is not None:
        red, green, blue = (colors[..., channel].astype(np.uint32) for channel in range(3))
        points["rgb"] = (red << 16) | (green << 8) | blue
    return _message(depth, points)


def _message(depth: Image, points: Any) -> PointCloud2:
    kind = points.dtype
    fields = [
        PointField(name=name, offset=kind.fields[name][1], datatype=PointField.FLOAT32, count=1) for name in kind.names
    ]
    return PointCloud2(
        header=depth.header, height=depth.height, width=depth.width, fields=fields, is_bigendian=False, is_dense=False,
        point_step=kind.itemsize, row_step=kind.itemsize * depth.width, data=points.tobytes(),
    )  # fmt: skip
