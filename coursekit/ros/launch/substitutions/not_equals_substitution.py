"""NotEqualsSubstitution under the module name that programs import."""

from .boolean_substitution import NotEqualsSubstitution

__all__ = ["NotEqualsSubstitution"]
