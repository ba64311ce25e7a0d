"""The filters of a chain, with the names and the parameters of laser_filters."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from rclpy.time import Time
from sensor_msgs.msg import LaserScan

from coursekit.nav.scans import filters
from coursekit.nav.scans.making import Array, floats, points_of

Frames = Callable[[str, str, Any], Any]
"""Frames(target, source, stamp): the 4x4 matrix between two frames."""


def _ranges(scan: LaserScan) -> Array:
    return np.asarray(scan.ranges, float)


def range_filter(scan: LaserScan, given: dict[str, Any], frames: Frames) -> None:
    """LaserScanRangeFilter"""
    low, high = given["lower_threshold"], given["upper_threshold"]
    if given["use_message_range_limits"]:
        low, high = scan.range_min, scan.range_max
    replacements = given["lower_replacement_value"], given["upper_replacement_value"]
    scan.ranges = floats(filters.within(_ranges(scan), low, high, *replacements))


def angular_bounds(scan: LaserScan, given: dict[str, Any], frames: Frames) -> None:
    """LaserScanAngularBoundsFilter"""
    angles = scan.angle_min + np.arange(len(scan.ranges)) * scan.angle_increment
    kept = np.flatnonzero((angles >= given["lower_angle"]) & (angles <= given["upper_angle"]))
    if not len(kept):
        scan.ranges, scan.intensities = [], []
        return
    first, last = int(kept[0]), int(kept[-1])
    late = round(first * scan.time_increment * 1e9)
    scan.header.stamp = Time(nanoseconds=Time.from_msg(scan.header.stamp).nanoseconds + late).to_msg()
    scan.angle_min, scan.angle_max = float(angles[first]), float(angles[last])
    scan.ranges = scan.ranges[first : last + 1]
    scan.intensities = scan.intensities[first : last + 1]


def angular_bounds_in_place(scan: LaserScan, given: dict[str, Any], frames: Frames) -> None:
    """LaserScanAngularBoundsFilterInPlace: removes obstacles between the angles."""
    angles = scan.angle_min + np.arange(len(scan.ranges)) * scan.angle_increment
    between = (angles > given["lower_angle"]) & (angles < given["upper_angle"])
    scan.ranges = floats(np.where(between, scan.range_max + 1.0, _ranges(scan)))


def box(scan: LaserScan, given: dict[str, Any], frames: Frames) -> None:
    """LaserScanBoxFilter: removes points in a box in the robot's frame, which are the robot itself."""
    ranges = _ranges(scan)
    with np.errstate(invalid="ignore"):
        points = points_of(ranges, scan.angle_min, scan.angle_increment)
        seat = frames(given["box_frame"], scan.header.frame_id, scan.header.stamp)
        moved = points @ seat[:3, :3].T + seat[:3, 3]
        low, high = (np.array([given[f"{end}_{axis}"] for axis in "xyz"]) for end in ("min", "max"))
        inside = filters.in_box(moved, low, high)
    scan.ranges = floats(filters.without(ranges, inside ^ given["invert"]))


def speckle(scan: LaserScan, given: dict[str, Any], frames: Frames) -> None:
    """LaserScanSpeckleFilter"""
    ranges, how = _ranges(scan), (given["filter_window"], given["max_range_difference"], given["max_range"])
    if given["filter_type"] == 0:
        filtered = filters.speckles_by_distance(ranges, *how)
    else:
        filtered = filters.speckles_by_neighbours(ranges, *how, scan.angle_increment)
    scan.ranges = floats(filtered)


def shadows(scan: LaserScan, given: dict[str, Any], frames: Frames) -> None:
    """ScanShadowsFilter"""
    angles = math.radians(given["min_angle"]), math.radians(given["max_angle"])
    how = angles, given["neighbors"], given["window"], given["remove_shadow_start_point"]
    scan.ranges = floats(filters.veils(_ranges(scan), scan.angle_increment, *how))


_BOX = {f"{end}_{axis}": float for end in ("min", "max") for axis in "xyz"}
KINDS: dict[str, tuple[Callable[[LaserScan, dict[str, Any], Frames], None], dict[str, Any]]] = {
    "LaserScanRangeFilter": (range_filter, {
        "use_message_range_limits": False, "lower_threshold": 0.0, "upper_threshold": 100000.0,
        "lower_replacement_value": math.nan, "upper_replacement_value": math.nan}),
    "LaserScanAngularBoundsFilter": (angular_bounds, {"lower_angle": float, "upper_angle": float}),
    "LaserScanAngularBoundsFilterInPlace": (angular_bounds_in_place, {"lower_angle": float, "upper_angle": float}),
    "LaserScanBoxFilter": (box, {"box_frame": str, "invert": False} | _BOX),
    "LaserScanSpeckleFilter": (speckle, {
        "filter_type": int, "max_range": float, "max_range_difference": float, "filter_window": int}),
    "ScanShadowsFilter": (shadows, {
        "min_angle": float, "max_angle": float, "neighbors": int, "window": int, "remove_shadow_start_point": False}),
}  # fmt: skip
"""Each filter's function, and its parameters with their defaults; a type means that the parameter is required."""
