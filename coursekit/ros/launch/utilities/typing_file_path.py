"""The type of a file path."""

from __future__ import annotations

import os
from typing import Union

FilePath = Union[str, bytes, "os.PathLike[str]"]
