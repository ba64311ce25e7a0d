"""Sets, lists, gets, loads and deletes the parameters of another node."""

import os
from typing import Any

import rclpy
from ament_index_python import get_package_share_directory
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_dict_from_yaml_file, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient
from rclpy.task import Future

TARGET = "parameter_blackboard"
WANTED = [
    Parameter("int_parameter", Parameter.Type.INTEGER, 10),
    Parameter("bool_parameter", Parameter.Type.BOOL, False),
    Parameter("string_parameter", Parameter.Type.STRING, "Fee Fi Fo Fum"),
]
NAMES = [parameter.name for parameter in WANTED]
UNWANTED = ["other_int_parameter", "other_string_parameter", "string_parameter"]


class Asker:
    """Sends one request after the other and logs the responses."""

    def __init__(self, node: Node, client: AsyncParameterClient) -> None:
        self.node, self.client, self.logger = node, client, node.get_logger()

    def _answer(self, future: Future, doing: str) -> Any:
        rclpy.spin_until_future_complete(self.node, future)
        if future.result() is None:
            self.logger.error(f"Error {doing} parameters: {future.exception()}")
        return future.result()

    def set(self) -> None:
        """Set three parameters."""
        self.logger.info("Setting parameters:")
        if answer := self._answer(self.client.set_parameters(WANTED), "setting"):
            for name, result in zip(NAMES, answer.results, strict=True):
                self.logger.info(f"    {name}:")
                self.logger.info(f"        successful: {result.successful}")

    def list(self) -> None:
        """List the parameters."""
        self.logger.info("Listing Parameters:")
        if answer := self._answer(self.client.list_parameters(NAMES, 10), "listing"):
            for name in answer.result.names:
                self.logger.info(f"    - {name}")

    def get(self) -> None:
        """Read the parameters back."""
        self.logger.info("Getting parameters:")
        if answer := self._answer(self.client.get_parameters(NAMES), "getting"):
            for name, value in zip(NAMES, answer.values, strict=True):
                self.logger.info(f"    - {name}: {parameter_value_to_python(value)}")

    def load(self) -> None:
        """Set the parameters of this package's params.yaml."""
        self.logger.info("Loading parameters: ")
        path = os.path.join(get_package_share_directory("demo_nodes_py"), "params.yaml")
        if answer := self._answer(self.client.load_parameter_file(path), "loading"):
            loaded = parameter_dict_from_yaml_file(path, False, target_nodes=[TARGET])
            for (name, parameter), result in zip(loaded.items(), answer.results, strict=True):
                self.logger.info(f"    {name}:")
                self.logger.info(f"        successful: {result.successful}")
                self.logger.info(f"        value: {parameter_value_to_python(parameter.value)}")

    def delete(self) -> None:
        """Delete some parameters; one declared with a type stays."""
        self.logger.info("Deleting parameters: ")
        if answer := self._answer(self.client.delete_parameters(UNWANTED), "deleting"):
            for name, result in zip(UNWANTED, answer.results, strict=True):
                self.logger.info(f"    {name}:")
                self.logger.info(f"        successful: {result.successful}")
                self.logger.info(f"        reason: {result.reason}")


def main(args: Any = None) -> None:
    """Send all requests to the parameter blackboard, once."""
    rclpy.init(args=args)
    node = rclpy.create_node("async_param_client")
    client = AsyncParameterClient(node, TARGET)
    if not client.wait_for_services(3.0):
        raise RuntimeError(
            f"{TARGET} is not available, start parameter blackboard with "
            f"`ros2 run demo_nodes_cpp {TARGET}` before running this demo"
        )
    asker = Asker(node, client)
    for step in (asker.set, asker.list, asker.get, asker.load, asker.delete):
        step()
    rclpy.shutdown()
