"""All tuning parameters of SLAM. No value depends on a building, a robot or a log."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class SlamParameters:
    """The parameters, in metres, radians, seconds.

    >>> SlamParameters(resolution=0.1).resolution
    0.1
    """

    def __post_init__(self) -> None:
        """Reject values that would cause a division by zero."""
        for name in (
            "point_spacing", "cell", "field_sigma", "field_reach", "angle_step", "range_sigma", "loop_cell",
            "loop_angle_step", "resolution", "blind_sigma", "submap_keyframes", "search_distance", "search_angle",
        ):  # fmt: skip
            if not 0 < getattr(self, name) < math.inf:
                raise ValueError(f"SlamParameters: {name} must be above 0, not {getattr(self, name)}")

    # scans
    range_min: float = 0.05
    """Shorter ranges are the robot itself or dust."""
    match_range: float = 30.0
    """Longer ranges are not matched."""
    point_spacing: float = 0.05
    """Minimum distance of points for matching."""
    fill_widest: float = 0.6
    """Gaps in a straight wall up to this width are filled."""
    normal_reach: float = 0.12
    """Radius of the neighbourhood for a wall's normal (larger at a distance: it must contain several beams)."""
    clear_no_return: float = 0.0
    """How far a beam without return clears the map; 0: not at all (glass and black surfaces return nothing either)."""

    # submaps and matching
    matching: bool = True
    """False: use the odometry as it is and search for no loops, to judge the odometry."""
    cell: float = 0.05
    """Cell of the likelihood field."""
    field_sigma: float = 0.06
    """Blur of the likelihood field."""
    field_reach: float = 0.3
    """Radius within which a point influences cells."""
    merge_distance: float = 0.03
    """Points of one surface within this distance are merged."""
    submap_keyframes: int = 30
    """A submap is finished after this many keyframes; the next one begins at half."""
    search_distance: float = 0.3
    search_angle: float = math.radians(20)
    angle_step: float = math.radians(1)
    poor_match: float = 0.85
    """A score below this part of the usual one widens the search and puts the odometry in doubt;"""
    clearly_better: float = 0.1
    """a match far from the odometry must score this much more."""
    guess_weight: float = 0.01
    """Score lost by a match for each squared sigma of its distance from the guess,"""
    guess_limit: float = 0.15
    """and the maximum loss."""
    minimum_score: float = 0.45
    """Mean likelihood below which a match is rejected and the search is widened."""
    blind_sigma: float = 0.3
    """Standard deviation of a guess without odometry [m], [rad]."""
    odometry_jump: float = 5.0
    """Odometry that jumps this far between two scans, and per second between them, was reset: it is ignored."""
    odometry_distance_sigma: tuple[float, float] = (0.02, 0.1)
    """Standard deviation of odometry: a constant, plus this part of the distance."""
    odometry_angle_sigma: tuple[float, float] = (0.02, 0.1)
    range_sigma: float = 0.03
    """Noise of a hit across its wall, including the roughness of walls."""

    # keyframes
    keyframe_distance: float = 0.3
    keyframe_angle: float = math.radians(15)

    # loops
    loop_cell: float = 0.1
    loop_score: float = 0.55
    """Mean likelihood that a loop must beat."""
    loop_inliers: float = 0.6
    """Part of a scan's points that must be on the walls of the submap."""
    loop_rival: float = 0.85
    """A loop is ambiguous when a pose beside it scores this part of its score: corridors look alike all along."""
    loop_least_way: float = 8.0
    """Keyframes connected by a shorter path are not a loop."""
    loop_drift: float = 0.05
    """The search window grows by this part of the path length since the place was seen."""
    loop_distance: float = 8.0
    loop_angle: float = math.radians(60)
    loop_angle_step: float = math.radians(1.2)
    loop_view: float = 3.0
    """A submap is searched when one of its keyframes may be within this distance."""
    loop_candidates: int = 2
    """Submaps searched for each keyframe."""
    loop_fields: int = 12
    """Number of submaps whose search fields are kept in memory."""
    loop_tension: float = 0.1
    """The graph is optimized at once when a loop is off by this much,"""
    loop_batch: int = 20
    """otherwise after this many loops."""
    loop_patience: int = 15
    """A loop that no other one confirms is dropped after this many keyframes."""

    # the map
    resolution: float = 0.05
    hit_odds: float = 0.85
    miss_odds: float = -0.4
    odds_limit: float = 4.0
