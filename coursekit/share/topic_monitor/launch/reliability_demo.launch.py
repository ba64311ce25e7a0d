"""A publisher that may lose messages, and one that may not."""

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.substitutions import ExecutableInPackage

EXECUTABLE = ExecutableInPackage(package="topic_monitor", executable="data_publisher")
PUBLISHERS = [["sensor", "--best-effort"], ["critical"]]


def generate_launch_description():
    """Return one publisher for each."""
    return LaunchDescription([ExecuteProcess(cmd=[EXECUTABLE, *words], output="screen") for words in PUBLISHERS])
