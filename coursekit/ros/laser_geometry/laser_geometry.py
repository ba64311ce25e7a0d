"""Conversion of a LaserScan to a PointCloud2."""

from __future__ import annotations

from enum import IntEnum

import numpy as np
from sensor_msgs.msg import LaserScan, PointCloud2, PointField

_TYPES = {PointField.FLOAT32: np.dtype("<f4"), PointField.INT32: np.dtype("<i4")}


class LaserProjection:
    """Converts the beams of a scan to points.

    >>> scan = LaserScan(angle_min=0.0, angle_increment=1.0, range_max=10.0, ranges=[2.0, 20.0])
    >>> LaserProjection().projectLaser(scan).width  # what is too far is left out
    1
    """

    LASER_SCAN_INVALID = -1.0
    LASER_SCAN_MIN_RANGE = -2.0
    LASER_SCAN_MAX_RANGE = -3.0

    class ChannelOption(IntEnum):
        """The values of a point besides its position; add them up."""

        NONE = 0x00
        INTENSITY = 0x01
        INDEX = 0x02
        DISTANCE = 0x04
        TIMESTAMP = 0x08
        VIEWPOINT = 0x10
        DEFAULT = 0x03

    def projectLaser(
        self, scan_in: LaserScan, range_cutoff: float = -1.0, channel_options: int = ChannelOption.DEFAULT
    ) -> PointCloud2:
        """The points of a scan in its own frame, without those beyond `range_cutoff` [m] (negative: range_max)."""
        ranges = np.asarray(scan_in.ranges, np.float64)
        farthest = range_cutoff if range_cutoff >= 0 else scan_in.range_max
        index = np.flatnonzero((ranges < farthest) & (ranges >= scan_in.range_min))
        kept, angles = ranges[index], scan_in.angle_min + index * scan_in.angle_increment
        columns = {"x": kept * np.cos(angles), "y": kept * np.sin(angles), "z": np.zeros(len(kept))}
        columns |= self._channels(scan_in, index, kept, channel_options)
        kinds = {name: PointField.INT32 if name == "index" else PointField.FLOAT32 for name in columns}
        points = np.zeros(len(kept), [(name, _TYPES[kind]) for name, kind in kinds.items()])
        for name, values in columns.items():
            points[name] = values
        return _cloud(scan_in, points, kinds)

    def _channels(self, scan: LaserScan, index: np.ndarray, kept: np.ndarray, options: int) -> dict[str, np.ndarray]:
        """The requested values besides the position, in the order in which they are stored."""
        option, channels = self.ChannelOption, {}
        if options & option.INTENSITY and len(scan.intensities) >= len(scan.ranges) > 0:
            channels["intensity"] = np.asarray(scan.intensities, np.float64)[index]
        if options & option.INDEX:
            channels["index"] = index
        if options & option.DISTANCE:
            channels["distances"] = kept
        if options & option.TIMESTAMP:
            channels["stamps"] = index * scan.time_increment
        if options & option.VIEWPOINT:
            channels |= {name: np.zeros(len(kept)) for name in ("vp_x", "vp_y", "vp_z")}
        return channels


def _cloud(scan: LaserScan, points: np.ndarray, kinds: dict[str, int]) -> PointCloud2:
    offsets = {name: points.dtype.fields[name][1] for name in kinds} if points.dtype.fields else {}
    fields = [PointField(name=name, offset=offsets[name], datatype=kind, count=1) for name, kind in kinds.items()]
    return PointCloud2(
        header=scan.header,
        height=1,
        width=len(points),
        fields=fields,
        is_bigendian=False,
        point_step=points.itemsize,
        row_step=points.nbytes,
        data=points.tobytes(),
        is_dense=False,
    )
