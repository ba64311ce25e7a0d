"""Conversion between point clouds and numpy arrays."""

from __future__ import annotations

import sys
from collections import namedtuple
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.lib.recfunctions import structured_to_unstructured, unstructured_to_structured
from sensor_msgs.msg import PointCloud2, PointField
from std_msgs.msg import Header

_DATATYPES: dict[int, np.dtype[Any]] = {
    PointField.INT8: np.dtype(np.int8),
    PointField.UINT8: np.dtype(np.uint8),
    PointField.INT16: np.dtype(np.int16),
    PointField.UINT16: np.dtype(np.uint16),
    PointField.INT32: np.dtype(np.int32),
    PointField.UINT32: np.dtype(np.uint32),
    PointField.FLOAT32: np.dtype(np.float32),
    PointField.FLOAT64: np.dtype(np.float64),
}
DUMMY_FIELD_PREFIX = "unnamed_field"


def dtype_from_fields(fields: Iterable[PointField], point_step: int | None = None) -> np.dtype[Any]:
    """Return the dtype of one point; a field of count n > 1 becomes name_0 ... name_(n-1)."""
    names, formats, offsets = [], [], []
    for index, field in enumerate(fields):
        kind, name = _DATATYPES[field.datatype], field.name or f"{DUMMY_FIELD_PREFIX}_{index}"
        assert field.count > 0, "Can't process fields with count = 0."
        for part in range(field.count):
            names.append(f"{name}_{part}" if field.count > 1 else name)
            formats.append(kind)
            offsets.append(field.offset + part * kind.itemsize)
    assert len(set(names)) == len(names), "Duplicate field names are not allowed!"
    layout: dict[str, Any] = {"names": names, "formats": formats, "offsets": offsets}
    if point_step is not None:
        layout["itemsize"] = point_step
    dtype: np.dtype[Any] = np.dtype(layout)  # type: ignore[call-overload]
    return dtype


def read_points(
    cloud: PointCloud2,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> np.ndarray[Any, Any]:
    """Return the points as a structured array, one record per point.

    `field_names` chooses fields, `skip_nans` drops points with a NaN, `uvs` chooses points by index.
    Raises AssertionError for anything but a PointCloud2 and for unknown fields.

    >>> from std_msgs.msg import Header
    >>> cloud = create_cloud_xyz32(Header(frame_id="lidar"), [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0)])
    >>> read_points(cloud, field_names=["x", "z"])["z"].tolist()
    [3.0, 6.0]
    """
    assert isinstance(cloud, PointCloud2), "Cloud is not a sensor_msgs.msg.PointCloud2"
    dtype = dtype_from_fields(cloud.fields, cloud.point_step)
    points: np.ndarray[Any, Any] = np.ndarray((cloud.width * cloud.height,), dtype=dtype, buffer=cloud.data)
    if field_names is not None:
        assert all(name in (dtype.names or ()) for name in field_names), (
            "Requests field is not in the fields of the PointCloud!"
        )
        points = points[list(field_names)]
    if bool(sys.byteorder != "little") != bool(cloud.is_bigendian):
        points = points.byteswap()
    if skip_nans and not cloud.is_dense:
        points = points[_without_nan(points)]
    if uvs is not None:
        points = points[uvs if isinstance(uvs, np.ndarray) else np.fromiter(uvs, int)]
    if reshape_organized_cloud and cloud.height > 1:
        points = points.reshape(cloud.width, cloud.height)
    return points


def _without_nan(points: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    keep = np.ones(len(points), dtype=bool)
    for name in points.dtype.names or ():
        keep &= ~np.isnan(points[name])
    return keep


def read_points_numpy(
    cloud: PointCloud2,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> np.ndarray[Any, Any]:
    """Return fields of one type as a plain array, one row per point; raises AssertionError for mixed types.

    >>> from std_msgs.msg import Header
    >>> cloud = create_cloud_xyz32(Header(frame_id="lidar"), [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0)])
    >>> read_points_numpy(cloud).shape
    (2, 3)
    """
    kinds = {field.datatype for field in cloud.fields if field_names is None or field.name in field_names}
    assert len(kinds) <= 1, (
        "All fields need to have the same datatype. Use `read_points()` otherwise."
    )
    points = read_points(cloud, field_names, skip_nans, uvs, reshape_organized_cloud)
    return structured_to_unstructured(points)


def read_points_list(
    cloud: PointCloud2,
    field_names: Sequence[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
) -> list[Any]:
    """Return the points as a list of named tuples."""
    points = read_points(cloud, field_names, skip_nans, uvs)
    point = namedtuple("Point", points.dtype.names or ())  # type: ignore[misc]
    return [point._make(values) for values in points.tolist()]


def create_cloud(
    header: Header,
    fields: Sequence[PointField],
    points: Any,
    step: int | None = None,
    point_step: int | None = None,
) -> PointCloud2:
    """Return a cloud of points: a structured array, or rows of values in the order of the fields.

    A two-dimensional array of records, or a three-dimensional array of values, gives an organized cloud.
    Raises AssertionError when the types do not match.
    """
    dtype = dtype_from_fields(fields, point_step if point_step is not None else step)
    if not (isinstance(points, np.ndarray) and points.dtype.names):
        rows = np.asarray(points, dtype=dtype[0])
        points = unstructured_to_structured(rows.reshape(*rows.shape[:-1], len(dtype.names or ())), dtype=dtype)
    assert points.dtype == dtype or points.dtype.names == dtype.names, (
        "PointFields and structured NumPy array dtype do not match for all fields!"
    )
    if points.dtype.itemsize > dtype.itemsize and points.dtype.fields == dtype.fields:
        assert step is None and point_step is None, "The step is not the size of the records in the array!"
        dtype = points.dtype  # records that are longer than their fields keep their length
    points = np.ascontiguousarray(points.astype(dtype))
    height, width = (1, len(points)) if points.ndim == 1 else points.shape[::-1]
    return PointCloud2(
        header=header,
        height=height,
        width=width,
        is_dense=False,
        is_bigendian=sys.byteorder != "little",
        fields=list(fields),
        point_step=dtype.itemsize,
        row_step=dtype.itemsize * width,
        data=points.tobytes(),
    )


def create_cloud_xyz32(header: Header, points: Any, step: int | None = None) -> PointCloud2:
    """Return a cloud of (x, y, z) points in single precision.

    >>> cloud = create_cloud_xyz32(Header(frame_id='map'), [(1.0, 2.0, 3.0)])
    >>> read_points_numpy(cloud)
    array([[1., 2., 3.]], dtype=float32)
    """
    names = ("x", "y", "z")
    fields = [
        PointField(name=n, offset=4 * i, datatype=PointField.FLOAT32, count=1) for i, n in enumerate(names)
    ]
    return create_cloud(header, fields, points, step)
