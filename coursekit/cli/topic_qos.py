"""QoS options of `ros2 topic echo` and `pub`, and the profile compatible with the present publishers."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING, Any

from rclpy.qos import DurabilityPolicy, QoSPresetProfiles, QoSProfile, ReliabilityPolicy
from ros2topic.api import POLICIES, profile_configure_short_keys

if TYPE_CHECKING:
    from argparse import ArgumentParser, Namespace


def add_arguments(parser: ArgumentParser, default_profile: str) -> None:
    """Add `--qos-profile`, `--qos-depth` and one option for each policy."""
    parser.add_argument(
        "--qos-profile",
        choices=QoSPresetProfiles.short_keys(),
        help=f"Quality of service preset profile (default: {default_profile})",
    )
    parser.add_argument("--qos-depth", metavar="N", type=int, help="Queue size setting")
    for name, policy in POLICIES:
        parser.add_argument(f"--qos-{name}", choices=policy.short_keys(), help=f"Quality of service {name} setting")
    parser.add_argument("--qos-liveliness-lease-duration-seconds", type=float, help="Lease duration")


def chosen(args: Namespace, base: QoSProfile) -> QoSProfile:
    """Return `base` or the given preset, with the given single settings."""
    if args.qos_profile:
        base = QoSPresetProfiles.get_from_short_key(args.qos_profile)
    profile = copy.deepcopy(base)
    words = {name: getattr(args, f"qos_{name}") for name, _ in POLICIES}
    lease = args.qos_liveliness_lease_duration_seconds
    profile_configure_short_keys(profile, depth=args.qos_depth, liveliness_lease_duration_s=lease, **words)
    return profile


def is_chosen(args: Namespace) -> bool:
    """Whether any QoS option was given."""
    names = ["profile", "depth", *(name for name, _ in POLICIES)]
    return any(getattr(args, f"qos_{name}") is not None for name in names)


def fitting(publishers: list[Any]) -> tuple[QoSProfile, list[str]]:
    """Return the profile compatible with all of these publishers, and remarks to print."""
    profile = QoSProfile(depth=10)
    remarks = []
    for policy, strict, loose in (
        ("reliability", ReliabilityPolicy.RELIABLE, ReliabilityPolicy.BEST_EFFORT),
        ("durability", DurabilityPolicy.TRANSIENT_LOCAL, DurabilityPolicy.VOLATILE),
    ):
        strict_ones = sum(getattr(publisher.qos_profile, policy) == strict for publisher in publishers)
        setattr(profile, policy, strict if publishers and strict_ones == len(publishers) else loose)
        if 0 < strict_ones < len(publishers):
            kind = f"QoS{type(strict).__name__}"
            remarks.append(
                f"Some, but not all, publishers are offering {kind}.{strict.name}. Falling back to "
                f"{kind}.{loose.name} as it will connect to all publishers"
            )
    return profile, remarks
