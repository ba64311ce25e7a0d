"""The source of XML launch files, under the module name that launch files import."""

from launch.launch_description_sources import XMLLaunchDescriptionSource

__all__ = ["XMLLaunchDescriptionSource"]
