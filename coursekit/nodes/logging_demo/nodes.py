"""A node that logs in many ways, and one that sets logger levels on request."""

from __future__ import annotations

import rclpy
from logging_demo.srv import ConfigLogger
from rclpy.logging import LoggingSeverity, get_logging_severity_from_string, set_logger_level
from std_msgs.msg import String

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run, spin_to_the_end


class LoggerConfig(CppNode):
    """Serves config_logger, which sets the level of a logger in this process."""

    def __init__(self) -> None:
        super().__init__("logger_config")
        self._service = self.create_service(ConfigLogger, "config_logger", self._configure)

    def _configure(self, request: ConfigLogger.Request, response: ConfigLogger.Response) -> ConfigLogger.Response:
        name, level = request.logger_name, request.level
        self.get_logger().info(f"Incoming request: logger '{name}', severity '{level}'")
        try:
            set_logger_level(name, get_logging_severity_from_string(level))
            response.success = True
        except RuntimeError:
            self.get_logger().error(f"Unknown severity '{level}'")
        return response


class LoggerUsage(CppNode):
    """Counts and logs: once, always, and, from the eleventh time on, what only DEBUG shows."""

    def __init__(self) -> None:
        super().__init__("logger_usage_demo")
        self._count = 0
        self._publisher = self.create_publisher(String, "logging_demo_count", 10)
        self._timer = self.create_timer(0.5, self._on_timer)
        self._once = self.create_timer(5.5, self._show_debug)

    def _show_debug(self) -> None:
        self._once.cancel()
        self.get_logger().info("Setting severity threshold to DEBUG")
        self.get_logger().set_level(LoggingSeverity.DEBUG)

    def _on_timer(self) -> None:
        log = self.get_logger()
        log.info("Timer callback called (this will only log once)", once=True)
        msg = String(data=f"Current count: {self._count}")
        log.info(f"Publishing: '{msg.data}'")
        self._publisher.publish(msg)
        if log.is_enabled_for(LoggingSeverity.DEBUG) and self._divides_twelve():  # only evaluated if it would be shown
            log.debug("Count divides into 12 (function evaluated to true)")
        if self._count % 2 == 0:
            log.debug("Count is even (expression evaluated to true)")
        self._count += 1
        if self._count > 15:
            log.warning("Reseting count to 0")
            self._count = 0

    def _divides_twelve(self) -> bool:
        if self._count == 0:
            self.get_logger().error("Modulo divisor cannot be 0")
            return False
        return 12 % self._count == 0


def main(args: list[str] | None = None) -> int:
    """Run both nodes in one process, so that one can set the other's level."""
    rclpy.init(args=args)
    return spin_to_the_end(LoggerConfig(), LoggerUsage())


def config(args: list[str] | None = None) -> int:
    """Run only the service, as a component."""
    return run(LoggerConfig, args)


def usage(args: list[str] | None = None) -> int:
    """Run only the counting node, as a component."""
    return run(LoggerUsage, args)
