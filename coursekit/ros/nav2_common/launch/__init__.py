"""Substitutions that derive a parameter file from another or inspect one, and the poses of several robots."""

from .has_node_params import HasNodeParams
from .parse_multirobot_pose import ParseMultiRobotPose
from .replace_string import ReplaceString
from .rewritten_yaml import RewrittenYaml

__all__ = ["HasNodeParams", "ParseMultiRobotPose", "ReplaceString", "RewrittenYaml"]
