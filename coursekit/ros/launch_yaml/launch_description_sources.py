"""The source of YAML launch files, under the module name that launch files import."""

from launch.launch_description_sources import YAMLLaunchDescriptionSource

__all__ = ["YAMLLaunchDescriptionSource"]
