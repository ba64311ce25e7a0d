"""EqualsSubstitution under the module name that programs import."""

from .boolean_substitution import EqualsSubstitution

__all__ = ["EqualsSubstitution"]
