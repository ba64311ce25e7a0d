"""tf2_py under the name that its tests use."""

from tf2_py._tf2_py import *  # noqa: F403
