"""Broadcasters: controllers that only read states and publish them."""

from __future__ import annotations

import math

from control_msgs.msg import DynamicJointState, InterfaceValue
from geometry_msgs.msg import WrenchStamped
from sensor_msgs.msg import Imu, JointState, Range

from .controller import ControlError, Controller, stamp

TOLD = ("position", "velocity", "effort")


class JointStateBroadcaster(Controller):
    """joint_state_broadcaster/JointStateBroadcaster."""

    def configure(self) -> None:
        """Read parameters: all available states, unless `joints` and `interfaces` select some."""
        self._chosen: list[str] | None = None
        self._joints, self._kinds = self.parameter("joints", []), self.parameter("interfaces", [])
        self._extra = self.parameter("extra_joints", [])
        own = "~/" if self.parameter("use_local_topics", False) else ""
        self._names = {kind: self.parameter(f"map_interface_to_joint_state.{kind}", kind) or kind for kind in TOLD}
        self._out = self.node.create_publisher(JointState, f"{own}joint_states", 10)
        self._dynamic = self.node.create_publisher(DynamicJointState, f"{own}dynamic_joint_states", 10)
        if not (self._joints and self._kinds):
            self.log.info("'joints' or 'interfaces' parameter is empty. All available state interfaces will be published")

    def state_names(self) -> list[str]:
        """Return the states to publish."""
        if self._chosen is not None:
            return self._chosen
        if not (self._joints and self._kinds):
            return self.interfaces.available_states()
        return [f"{joint}/{kind}" for joint in self._joints for kind in self._kinds]

    def activate(self) -> None:
        """Group the states by joint; what becomes available later is not among them."""
        self._table: dict[str, list[str]] = {}
        self._chosen = self.state_names()
        for name in self._chosen:
            joint, _, kind = name.partition("/")
            self._table.setdefault(joint, []).append(kind)
        self._told = [joint for joint, kinds in self._table.items() if set(kinds) & set(self._names.values())]

    def deactivate(self) -> None:
        """Choose anew at the next start."""
        self._chosen = None

    def update(self, now_ns: int, dt: float) -> None:
        """Publish the states."""
        msg, state = JointState(name=[*self._told, *self._extra]), self.interfaces.state
        msg.header.stamp = stamp(now_ns)
        fields = [[state(f"{joint}/{self._names[kind]}") for joint in self._told] for kind in TOLD]
        rest = [0.0] * len(self._extra)
        msg.position, msg.velocity, msg.effort = ([*field, *rest] for field in fields)
        self._out.publish(msg)
        if not self._dynamic.get_subscription_count():
            return
        every = DynamicJointState(joint_names=list(self._table))
        every.header.stamp = msg.header.stamp
        for joint, kinds in self._table.items():
            every.interface_values.append(
                InterfaceValue(interface_names=kinds, values=[state(f"{joint}/{kind}") for kind in kinds])
            )
        self._dynamic.publish(every)


class ImuBroadcaster(Controller):
    """imu_sensor_broadcaster/IMUSensorBroadcaster."""

    PARTS = tuple(
        [f"orientation.{axis}" for axis in "xyzw"]
        + [f"{kind}.{axis}" for kind in ("angular_velocity", "linear_acceleration") for axis in "xyz"]
    )

    def configure(self) -> None:
        """Read the sensor's name and frame."""
        self._sensor, self._frame = self.parameter("sensor_name", ""), self.parameter("frame_id", "")
        if not self._sensor or not self._frame:
            raise ControlError(f"'{'frame_id' if self._sensor else 'sensor_name'}' parameter cannot be empty")
        self._out = self.node.create_publisher(Imu, "~/imu", 10)

    def state_names(self) -> list[str]:
        """Return its ten states."""
        return [f"{self._sensor}/{part}" for part in self.PARTS]

    def update(self, now_ns: int, dt: float) -> None:
        """Publish the states."""
        msg = Imu()
        msg.header.stamp, msg.header.frame_id = stamp(now_ns), self._frame
        for part in self.PARTS:
            field, _, axis = part.partition(".")
            setattr(getattr(msg, field), axis, self.interfaces.state(f"{self._sensor}/{part}"))
        self._out.publish(msg)


class WrenchBroadcaster(Controller):
    """force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster."""

    def configure(self) -> None:
        """Read the sensor's name (or its states) and frame."""
        sensor, self._frame = self.parameter("sensor_name", ""), self.parameter("frame_id", "")
        self._names = {
            (kind, axis): self.parameter(f"interface_names.{kind}.{axis}", f"{sensor}/{kind}.{axis}" if sensor else "")
            for kind in ("force", "torque") for axis in "xyz"
        }  # fmt: skip
        if not any(self._names.values()):
            raise ControlError("'sensor_name' or at least one 'interface_names.[force|torque].[x|y|z]' has to be specified.")
        if not self._frame:
            raise ControlError("'frame_id' parameter has to be provided.")
        self._out = self.node.create_publisher(WrenchStamped, "~/wrench", 10)

    def state_names(self) -> list[str]:
        """Return its states."""
        return [name for name in self._names.values() if name]

    def update(self, now_ns: int, dt: float) -> None:
        """Publish the states."""
        msg = WrenchStamped()
        msg.header.stamp, msg.header.frame_id = stamp(now_ns), self._frame
        for (kind, axis), name in self._names.items():
            setattr(getattr(msg.wrench, kind), axis, self.interfaces.state(name) if name else math.nan)
        self._out.publish(msg)


class RangeBroadcaster(Controller):
    """range_sensor_broadcaster/RangeSensorBroadcaster."""

    def configure(self) -> None:
        """Read the sensor's name, frame and field of view."""
        self._sensor, self._frame = self.parameter("sensor_name", ""), self.parameter("frame_id", "")
        if not self._sensor:
            raise ControlError("'sensor_name' parameter has to be specified.")
        if not self._frame:
            raise ControlError("'frame_id' parameter has to be provided.")
        self._kind = int(self.parameter("radiation_type", 0))
        sizes = (("field_of_view", 0.52), ("min_range", 0.52), ("max_range", 4.0))
        self._sizes = {name: float(self.parameter(name, usual)) for name, usual in sizes}
        self._out = self.node.create_publisher(Range, "~/range", 10)

    def state_names(self) -> list[str]:
        """Return its state."""
        return [f"{self._sensor}/range"]

    def update(self, now_ns: int, dt: float) -> None:
        """Publish the state."""
        msg = Range(radiation_type=self._kind, range=self.interfaces.state(f"{self._sensor}/range"))
        for name, size in self._sizes.items():
            setattr(msg, name, size)
        msg.header.stamp, msg.header.frame_id = stamp(now_ns), self._frame
        self._out.publish(msg)


__all__ = ["ImuBroadcaster", "JointStateBroadcaster", "RangeBroadcaster", "WrenchBroadcaster"]
