"""The newer Gazebo's server and the bridge."""

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    """Return both, with all their arguments."""
    files = (("ros_gz_sim", "gz_server.launch.py"), ("ros_gz_bridge", "ros_gz_bridge.launch.py"))
    sources = [PathJoinSubstitution([FindPackageShare(package), "launch", file]) for package, file in files]
    return LaunchDescription([IncludeLaunchDescription(PythonLaunchDescriptionSource(source)) for source in sources])
