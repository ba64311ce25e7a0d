"""Columns with names become plain ones, and plain ones get names: programs for Humble import both from here."""

import numpy as np
from sensor_msgs_py.numpy_compat import structured_to_unstructured, unstructured_to_structured

NAMED = np.dtype([("x", "f4"), ("y", "f4")])


def test_columns_lose_and_get_names():
    plain = structured_to_unstructured(np.array([(1, 2), (3, 4)], NAMED))
    assert plain.tolist() == [[1, 2], [3, 4]]
    assert unstructured_to_structured(plain, NAMED)["y"].tolist() == [2, 4]
