"""Stores parameters for other nodes: any may be set without declaration."""

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run


class ParameterBlackboard(CppNode):
    """A node that accepts every parameter."""

    def __init__(self) -> None:
        super().__init__(
            "parameter_blackboard",
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
        )
        self.get_logger().info(
            f"Parameter blackboard node named '{self.get_fully_qualified_name()}' ready, and serving "
            f"'{len(list(self.services))}' services already!"
        )


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(ParameterBlackboard, args)
