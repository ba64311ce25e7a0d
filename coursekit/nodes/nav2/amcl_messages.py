"""Convert amcl's output to messages, and its input to numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav2_msgs.msg import Particle, ParticleCloud
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import LaserScan

from coursekit.geometry.plane import Pose2D
from coursekit.nav.particle_filter import Estimate, ParticleFilter
from coursekit.nodes.scanning.planar import plane, put
from coursekit.slam.scan import Laser

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time as TimeMsg

POSE_QOS = QoSProfile(depth=1, reliability=ReliabilityPolicy.RELIABLE, durability=DurabilityPolicy.TRANSIENT_LOCAL)
SHOWN = 2000
"""The maximum number of particles in a message."""
_PLANE = np.ix_((0, 1, 5), (0, 1, 5))


def pose_message(estimate: Estimate, frame: str, stamp: TimeMsg) -> PoseWithCovarianceStamped:
    """Return the pose estimate as a message."""
    msg = PoseWithCovarianceStamped()
    msg.header.frame_id, msg.header.stamp = frame, stamp
    put(Pose2D.of(estimate.pose), msg.pose.pose.position, msg.pose.pose.orientation)
    covariance = np.zeros((6, 6))
    covariance[_PLANE] = estimate.covariance
    msg.pose.covariance = covariance.ravel()
    return msg


def cloud_message(particles: ParticleFilter, frame: str, stamp: TimeMsg) -> ParticleCloud:
    """Return the particles as a message, evenly sampled if there are many."""
    msg = ParticleCloud()
    msg.header.frame_id, msg.header.stamp = frame, stamp
    step = -(-len(particles.particles) // SHOWN)
    for row, weight in zip(particles.particles[::step].tolist(), particles.weights[::step].tolist(), strict=True):
        particle = Particle(weight=weight * step)
        put(Pose2D(*row), particle.pose.position, particle.pose.orientation)
        msg.particles.append(particle)
    return msg


def pose_of(msg: PoseWithCovarianceStamped) -> tuple[Pose2D, np.ndarray]:
    """Return a 2D pose and its covariance (3, 3). ValueError for invalid numbers."""
    pose = plane(msg.pose.pose.position, msg.pose.pose.orientation)
    covariance = np.asarray(msg.pose.covariance, dtype=float).reshape(6, 6)[_PLANE]
    if not np.isfinite([*pose]).all() or not np.isfinite(covariance).all():
        raise ValueError("Received initialpose message is malformed. Rejecting.")
    return pose, covariance


def beam_ends(scan: LaserScan, laser: Laser, beams: int) -> np.ndarray:
    """Return the (m, 2) end points of evenly chosen beams in the robot's frame [m], without those that hit nothing."""
    ranges = np.asarray(scan.ranges, dtype=np.float64)
    step = max((len(ranges) - 1) // max(beams - 1, 1), 1)
    chosen = np.arange(0, len(ranges), step)
    ranges, angles = ranges[chosen], laser.angles(len(ranges))[chosen]
    with np.errstate(invalid="ignore"):
        good = np.isfinite(ranges) & (ranges > laser.range_min) & (ranges < laser.range_max)
    ranges, angles = ranges[good], angles[good]
    ends = np.column_stack([ranges * np.cos(angles), ranges * np.sin(angles)])
    return laser.offset.transform(ends)
