"""The folder of this launch file, under the module name that programs import."""

from .this_launch_file import ThisLaunchFileDir

__all__ = ["ThisLaunchFileDir"]
