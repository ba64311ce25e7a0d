"""Substitutions that make a parameter file of another, and one that looks into it."""

from .has_node_params import HasNodeParams
from .replace_string import ReplaceString
from .rewritten_yaml import RewrittenYaml

__all__ = ["HasNodeParams", "ReplaceString", "RewrittenYaml"]
