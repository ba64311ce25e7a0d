"""Sets the folder of the nodes' log files."""

from __future__ import annotations

import os
from typing import Any

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions


@expose_action("set_ros_log_dir")
class SetROSLogDir(Action):
    """Sets ROS_LOG_DIR for the following nodes in the same group."""

    def __init__(self, new_log_dir: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__log_dir = normalize_to_list_of_substitutions(new_log_dir)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<set_ros_log_dir new_log_dir=/>`, also with `log_dir`."""
        _, kwargs = super().parse(entity, parser)
        folder = entity.get_attr("new_log_dir", optional=True)
        kwargs["new_log_dir"] = parser.parse_substitution(folder or entity.get_attr("log_dir"))
        return cls, kwargs

    @property
    def log_dir(self) -> list[Substitution]:
        """The folder, as substitutions."""
        return self.__log_dir

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Set the variable; a relative folder is relative to the previous one."""
        before = context.environment.get("ROS_LOG_DIR", os.path.expanduser("~/.ros/log"))
        context.environment["ROS_LOG_DIR"] = os.path.join(before, perform_substitutions(context, self.__log_dir))
        return None


SetRosLogDir = SetROSLogDir
