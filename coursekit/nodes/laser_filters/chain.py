"""`ros2 run laser_filters scan_to_scan_filter_chain`: filters /scan to /scan_filtered."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, TransformException, TransformListener

from coursekit.geometry.pose import matrix
from coursekit.nodes.laser_filters.kinds import KINDS
from coursekit.nodes.nav2.parameters import no_such_plugin
from coursekit.nodes.running import run


class FilterChain(Node):
    """Applies filter1, filter2 and so on, as given by the parameters. ValueError for invalid ones."""

    def __init__(self) -> None:
        super().__init__(
            "scan_to_scan_filter_chain",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
        )
        self._buffer = Buffer(node=self)
        self._listener = TransformListener(self._buffer, self)
        self._chain = self._read()
        self._out = self.create_publisher(LaserScan, "scan_filtered", 1000)
        self.create_subscription(LaserScan, "scan", self._hear, qos_profile_sensor_data)

    def _read(self) -> list[tuple[str, Any, dict[str, Any]]]:
        chain: list[tuple[str, Any, dict[str, Any]]] = []
        while self.has_parameter(f"filter{len(chain) + 1}.name"):
            chain.append(self._filter(f"filter{len(chain) + 1}"))
        return chain

    def _filter(self, prefix: str) -> tuple[str, Any, dict[str, Any]]:
        values = {name: parameter.value for name, parameter in self.get_parameters_by_prefix(prefix).items()}
        full, name = str(values.get("type", "")), str(values["name"])
        kind = full.removeprefix("laser_filters/")
        if kind not in KINDS:
            known = (f"laser_filters/{short}" for short in KINDS)
            base = "filters::FilterBase<sensor_msgs::msg::LaserScan>"
            raise ValueError(no_such_plugin(f"filter {name} of type '{full}'", full, base, known))
        work, wanted = KINDS[kind]
        given = {key: values.get(f"params.{key}", default) for key, default in wanted.items()}
        missing = [key for key, value in given.items() if isinstance(value, type)]
        if missing:
            raise ValueError(f"{kind} '{name}' was not given {', '.join(missing)}: set {prefix}.params.{missing[0]}")
        return name, work, given

    def _matrix(self, target: str, source: str, stamp: Any) -> Any:
        """Return the 4x4 matrix between two frames at a time, or the latest one if that time is not available yet."""
        try:
            transform = self._buffer.lookup_transform_core(target, source, Time.from_msg(stamp)).transform
        except TransformException:
            transform = self._buffer.lookup_transform_core(target, source, Time()).transform
        t, q = transform.translation, transform.rotation
        return np.array(matrix((t.x, t.y, t.z, q.x, q.y, q.z, q.w)))

    def _hear(self, msg: LaserScan) -> None:
        scan = copy.deepcopy(msg)
        for name, work, given in self._chain:
            try:
                work(scan, given, self._matrix)
            except TransformException as fault:
                self.get_logger().error(f"Filtering the scan from time {msg.header.stamp.sec} failed in '{name}': {fault}",
                                        throttle_duration_sec=1.0)  # fmt: skip
                return
        self._out.publish(scan)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(FilterChain, args, refuses=(ValueError,))
