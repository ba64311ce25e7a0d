"""Substitutions that derive a parameter file from another, and one that inspects a parameter file."""

from .has_node_params import HasNodeParams
from .replace_string import ReplaceString
from .rewritten_yaml import RewrittenYaml

__all__ = ["HasNodeParams", "ReplaceString", "RewrittenYaml"]
