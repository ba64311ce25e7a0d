"""A node whose parameters can only be even integers."""

from __future__ import annotations

from rcl_interfaces.msg import SetParametersResult
from rclpy.parameter import Parameter

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run

_TOLD = (
    "This example node shows a parameter callback that rejects",
    "all parameter updates except for those that set an even integer.",
    "Try running 'ros2 param set /even_parameters_node myint 2' to",
    "successfully set a parameter.",
)


class EvenParameters(CppNode):
    """Accepts undeclared parameters, and rejects values that are not even."""

    def __init__(self) -> None:
        super().__init__("even_parameters_node", allow_undeclared_parameters=True)
        for line in _TOLD:
            self.get_logger().info(line)
        self.add_on_set_parameters_callback(self._judge_all)

    def _judge_all(self, parameters: list[Parameter]) -> SetParametersResult:
        refusals = [reason for reason in map(self._refusal, parameters) if reason]
        return SetParametersResult(successful=not refusals, reason=refusals[-1] if refusals else "")

    def _refusal(self, parameter: Parameter) -> str:
        name, log = parameter.name, self.get_logger()
        if parameter.type_ == Parameter.Type.NOT_SET:
            log.info(f"parameter '{name}' deleted successfully")
        elif parameter.type_ != Parameter.Type.INTEGER:
            log.info(
                "only integer parameters can be set\n"
                f"requested value for parameter '{name}' is not an even number, rejecting change..."
            )
            return "only integer parameters can be set"
        elif parameter.value % 2:
            value = f"Requested value '{parameter.value}' for parameter '{name}'"
            log.info(f"{value} is not an even number: rejecting change...")
            return "only even integers can be set"
        else:
            log.info(f"parameter '{name}' has changed and is now: {parameter.value}")
        return ""


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(EvenParameters, args)
