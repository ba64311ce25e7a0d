"""A publisher of joint states, with its joints as dictionaries. In ROS 2: joint_state_publisher.joint_state_publisher."""

from __future__ import annotations

from collections.abc import Iterator, MutableMapping
from typing import Any

from coursekit.nodes.robots import joint_state_publisher as node
from coursekit.nodes.robots.joint_model import FreeJoint
from coursekit.urdf import UrdfError

__all__ = ["JointStatePublisher", "main"]

NAMES = {"min": "least", "max": "greatest", "zero": "zero"}
PUBLISHED = ("position", "velocity", "effort")


class _AsDictionary(MutableMapping[str, Any]):
    """A free joint with the keys of ROS 2's dictionary; written values are published next."""

    def __init__(self, joint: FreeJoint) -> None:
        self._joint = joint

    def __getitem__(self, key: str) -> Any:
        if key not in list(self):
            raise KeyError(key)
        return getattr(self._joint, NAMES.get(key, key))

    def __setitem__(self, key: str, value: Any) -> None:
        if key not in (*NAMES, *PUBLISHED, "continuous", "forward"):
            raise KeyError(key)
        setattr(self._joint, NAMES.get(key, key), value)

    def __delitem__(self, key: str) -> None:
        self[key] = None if key in PUBLISHED else False

    def __iter__(self) -> Iterator[str]:
        yield from NAMES
        yield from (key for key in PUBLISHED if getattr(self._joint, key) is not None)
        yield from ("continuous",) if self._joint.continuous else ()

    def __len__(self) -> int:
        return sum(1 for _ in self)


class JointStatePublisher(node.JointStatePublisher):
    """Publishes joint states; `urdf_file` is a description, or None for the topic robot_description.

    Raises:
        ValueError: when the description cannot be used, with the message of ROS 2's node.
    """

    def __init__(self, urdf_file: Any = None) -> None:
        try:
            super().__init__(None if urdf_file is None else str(urdf_file))
        except UrdfError as error:
            raise ValueError(error.what) from error

    @property
    def joint_list(self) -> list[str]:
        """All joints that move, in the order of the description."""
        return self.model.names

    @property
    def free_joints(self) -> dict[str, MutableMapping[str, Any]]:
        """Joints with a position of their own, by name: `min`, `max`, `zero` (rad or m), and the published values."""
        return {name: _AsDictionary(joint) for name, joint in self.model.free.items()}

    @property
    def dependent_joints(self) -> dict[str, dict[str, Any]]:
        """Joints that follow another, by name: `parent`, `factor`, `offset`."""
        return {name: dict(vars(follower)) for name, follower in self.model.followers.items()}


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return node.run(JointStatePublisher, args)
