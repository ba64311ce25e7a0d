"""Scan-to-scan tracking: odometry, then the best match in the current submap."""

from __future__ import annotations

import math

import numpy as np

from coursekit.geometry.plane import Array, Pose2D
from coursekit.slam.matcher import match
from coursekit.slam.odometry import Calibration
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.refine import Refined, precision_of, refine
from coursekit.slam.scan import Scan
from coursekit.slam.submap import Submap

LEARN_WITHIN = 2.0
"""The odometry's errors are learnt only from matches within so many sigmas of the guess."""


class Tracker:
    """Tracks the robot in the current submap; submaps overlap by half, so one with enough content is always available."""

    def __init__(self, params: SlamParameters) -> None:
        self.params = params
        self.submaps: list[Submap] = []
        """The one used for matching, and its successor."""
        self.finished: list[Submap] = []
        """Submaps just finished; the owner removes them."""
        self.pose = Pose2D()
        """The robot's pose in the frame of the first submap."""
        self.base = 0
        """The keyframe to which the next one will be connected."""
        self._base_pose = Pose2D()
        """Its pose in the frame of the first submap."""
        self._odometry: Pose2D | None = None
        self._stamp = 0.0
        self._speed = Pose2D()
        self._wheels, self._told = Calibration(), Pose2D()
        self._usual = 0.8
        """Running mean of the scores."""

    def start(self, submap: Submap, base: int, pose: Pose2D) -> None:
        """Start in a known submap: at `pose` in its frame, connected to one of its keyframes."""
        self.submaps, self.finished = [submap], []
        self.pose, self.base, self._base_pose = pose, base, submap.members[base]
        self._odometry, self._speed = None, Pose2D()

    def track(self, scan: Scan, odometry: Pose2D | None) -> tuple[Refined, float, bool]:
        """Track the robot to the next scan; return the match, its score, and whether it is accepted."""
        motion, known = self._motion(scan, odometry)
        guess = self.pose @ motion
        if not self.submaps:
            return Refined(guess, np.eye(3), 1.0, 0.0), 1.0, True
        if not self.params.matching:
            self.pose = guess
            return Refined(guess, np.eye(3), 1.0, 0.0), 1.0, True
        refined, score = self._match(scan, guess, self._sigmas(motion, known))
        accepted = score >= self.params.minimum_score
        if not accepted and known:
            refined = Refined(guess, refined.information * 0.0, refined.inliers, refined.spread)
        self._speed = self.pose.to(refined.pose)
        if accepted and known and self._plausible(guess.to(refined.pose), motion):
            self._wheels.learn(self._told, self._speed)
        self.pose = refined.pose
        return refined, score, accepted

    def _match(self, scan: Scan, guess: Pose2D, sigmas: tuple[float, float]) -> tuple[Refined, float]:
        """Return the best match near the guess; when it is much poorer than usual, a clearly better one farther away."""
        p, submap = self.params, self.submaps[0]
        wide = p.search_distance if sigmas[0] >= p.blind_sigma else min(3 * sigmas[0], 1.0)
        best, score = match(scan.points, submap, guess, max(p.search_distance, wide), p.search_angle, sigmas)
        if score < max(p.minimum_score, p.poor_match * self._usual):
            blind = (p.blind_sigma, p.blind_sigma)
            for other in (self.pose @ self._speed, guess):  # the odometry may be wrong
                far, better = match(
                    scan.points, submap, other, 3 * p.search_distance, 2 * p.search_angle, blind
                )
                if better > score + p.clearly_better:
                    best, score, guess, sigmas = far, better, far, blind
        self._usual += 0.05 * (score - self._usual)
        return refine(scan.points, submap, best, guess, precision_of(sigmas[0], *sigmas)), score

    def _motion(self, scan: Scan, odometry: Pose2D | None) -> tuple[Pose2D, bool]:
        """Return the motion since the last scan, from odometry or the previous velocity, and whether it is odometry."""
        before, self._odometry = self._odometry, odometry
        seconds, self._stamp = scan.stamp - self._stamp, scan.stamp
        if odometry is not None and before is not None:
            motion = before.to(odometry)
            farthest = self.params.odometry_jump * max(1.0, seconds)
            if all(map(math.isfinite, motion)) and math.hypot(motion.x, motion.y) < farthest:
                self._told = motion
                return (self._wheels.correct(motion) if self.params.matching else motion), True
            return Pose2D(), False
        return (self._speed if self.submaps else Pose2D()), False

    def _sigmas(self, motion: Pose2D, known: bool) -> tuple[float, float]:
        """Return the standard deviations of the guess [m], [rad]."""
        p = self.params
        if not known:
            return p.blind_sigma, p.blind_sigma
        (still, going), (straight, turning) = p.odometry_distance_sigma, p.odometry_angle_sigma
        return still + going * math.hypot(motion.x, motion.y), straight + turning * abs(motion.theta)

    def _plausible(self, off: Pose2D, motion: Pose2D) -> bool:
        """Whether a match is near enough to the guess to learn from: farther ones are a matter of chance."""
        distance, angle = self._sigmas(motion, True)
        return math.hypot(off.x, off.y) < LEARN_WITHIN * distance and abs(off.theta) < LEARN_WITHIN * angle

    def moved_enough(self) -> bool:
        """Whether a new keyframe is due.

        >>> tracker = Tracker(SlamParameters(keyframe_distance=0.5))
        >>> tracker.pose = Pose2D(0.4, 0.0, 0.0)
        >>> tracker.moved_enough()
        False
        >>> tracker.pose = Pose2D(0.6, 0.0, 0.0)
        >>> tracker.moved_enough()
        True
        """
        motion = self.from_keyframe()
        return (
            math.hypot(motion.x, motion.y) > self.params.keyframe_distance
            or abs(motion.theta) > self.params.keyframe_angle
        )

    def from_keyframe(self) -> Pose2D:
        """The motion since the last keyframe."""
        return self._base_pose.to(self.pose)

    def edge_precision(self, found: Refined) -> Array:
        """Return the precision of the motion since the last keyframe."""
        motion = self.from_keyframe()
        way, turn = math.hypot(motion.x, motion.y), abs(motion.theta)
        floor = np.diag([(0.01 + 0.02 * way) ** 2, (0.01 + 0.02 * way) ** 2, (0.003 + 0.02 * turn) ** 2])
        odometry = precision_of(0.02 + 0.2 * way, 0.02 + 0.2 * way, 0.02 + 0.2 * turn)
        return np.linalg.inv(np.linalg.inv(found.information * 0.1 + odometry) + floor)

    def insert(self, number: int, scan: Scan) -> None:
        """Insert a keyframe into the submaps; start and finish submaps as needed."""
        half = self.params.submap_keyframes // 2
        if not self.submaps:
            self.submaps.append(Submap(self.params, number))
            self.pose = Pose2D()
        elif len(self.submaps) == 1 and len(self.submaps[0].members) >= half:
            self.submaps.append(Submap(self.params, number))
        for submap in self.submaps:
            pose = Pose2D() if submap.anchor == number else self._in(submap)
            submap.members[number] = pose
            submap.insert(scan, pose)
        if len(self.submaps[0].members) >= self.params.submap_keyframes:
            self._leave()
        self.base, self._base_pose = number, self.pose

    def _in(self, submap: Submap) -> Pose2D:
        """The robot's pose in a submap's frame."""
        return self.submaps[0].members[submap.anchor].to(self.pose)

    def _leave(self) -> None:
        """Continue in the next submap."""
        self.pose = self._in(self.submaps[1])
        left = self.submaps.pop(0)
        left.finish()
        self.finished.append(left)
