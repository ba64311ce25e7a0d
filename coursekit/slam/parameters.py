"""All that can be tuned in SLAM, in one place. No value depends on a building, a robot or a log."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class SlamParameters:
    """Metres, radians, seconds.

    >>> SlamParameters(resolution=0.1).resolution
    0.1
    """

    def __post_init__(self) -> None:
        """Refuse what would divide by zero."""
        for name in (
            "point_spacing", "cell", "field_sigma", "field_reach", "angle_step", "range_sigma", "loop_cell",
            "loop_angle_step", "resolution", "blind_sigma", "submap_keyframes", "search_distance", "search_angle",
        ):  # fmt: skip
            if not 0 < getattr(self, name) < math.inf:
                raise ValueError(f"SlamParameters: {name} must be above 0, not {getattr(self, name)}")

    # scans
    range_min: float = 0.05
    """Nearer returns are the robot itself or dust."""
    match_range: float = 30.0
    """Farther returns are not matched."""
    point_spacing: float = 0.05
    """Points for matching are at least this far apart."""
    fill_widest: float = 0.6
    """Gaps on a straight wall up to this wide are filled."""
    normal_reach: float = 0.12
    """A wall's direction comes from the points this near (farther away from more: some beams must be among them)."""
    clear_no_return: float = 0.0
    """How far a beam without return clears the map; 0: it says nothing (glass and black surfaces give none either)."""

    # submaps and matching
    matching: bool = True
    """False: the odometry is believed as it is, and no loop is sought; to see what it is worth."""
    cell: float = 0.05
    """Cell of the likelihood field."""
    field_sigma: float = 0.06
    """Blur of the likelihood field."""
    field_reach: float = 0.3
    """A point influences cells this near."""
    merge_distance: float = 0.03
    """Points of one surface this near become one."""
    submap_keyframes: int = 30
    """A submap is finished after this many; the next one begins at half."""
    search_distance: float = 0.3
    search_angle: float = math.radians(20)
    angle_step: float = math.radians(1)
    poor_match: float = 0.85
    """A score below this part of the usual one makes the search wider and the odometry doubtful;"""
    clearly_better: float = 0.1
    """a match far from the odometry must score this much more."""
    guess_weight: float = 0.01
    """Score that a match loses for each squared sigma that it is away from the guess,"""
    guess_limit: float = 0.15
    """and the most that it loses."""
    minimum_score: float = 0.45
    """Mean likelihood below which a match is not believed and the search is widened."""
    blind_sigma: float = 0.3
    """Without odometry a guess errs by this much [m], [rad]."""
    odometry_jump: float = 5.0
    """Odometry that moves this far between two scans, and in each second between them, has been reset: it tells nothing."""
    odometry_distance_sigma: tuple[float, float] = (0.02, 0.1)
    """Odometry errs by this much, plus this part of the way."""
    odometry_angle_sigma: tuple[float, float] = (0.02, 0.1)
    range_sigma: float = 0.03
    """Noise of a hit across its wall, roughness of walls included."""

    # keyframes
    keyframe_distance: float = 0.3
    keyframe_angle: float = math.radians(15)

    # loops
    loop_cell: float = 0.1
    loop_score: float = 0.55
    """Mean likelihood that a loop must beat."""
    loop_inliers: float = 0.6
    """Part of a scan's points that must lie on the walls of the submap."""
    loop_rival: float = 0.85
    """A loop is not told apart when a pose beside it scores this part of what it scores: corridors look alike all along."""
    loop_least_way: float = 8.0
    """Places that are joined by a shorter way are no loop."""
    loop_drift: float = 0.05
    """The search grows by this much of the way since the place was seen."""
    loop_distance: float = 8.0
    loop_angle: float = math.radians(60)
    loop_angle_step: float = math.radians(1.2)
    loop_view: float = 3.0
    """A submap is searched when one of its keyframes may be this near."""
    loop_candidates: int = 2
    """Submaps searched for each keyframe."""
    loop_fields: int = 12
    """Submaps whose search fields are kept in memory."""
    loop_tension: float = 0.1
    """The graph is optimized at once when a loop is off by this much,"""
    loop_batch: int = 20
    """and else after so many loops."""
    loop_patience: int = 15
    """A loop that no other confirms is dropped after this many keyframes."""

    # the map
    resolution: float = 0.05
    hit_odds: float = 0.85
    miss_odds: float = -0.4
    odds_limit: float = 4.0
