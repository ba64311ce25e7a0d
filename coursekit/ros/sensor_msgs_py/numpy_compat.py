"""Arrays with named columns as plain ones, and back: NumPy has them since 1.16, older ones did not."""

from numpy.lib.recfunctions import structured_to_unstructured, unstructured_to_structured

__all__ = ["structured_to_unstructured", "unstructured_to_structured"]
