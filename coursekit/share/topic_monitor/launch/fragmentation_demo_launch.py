"""Publishers of messages of one byte to 150 kB."""

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.substitutions import ExecutableInPackage

EXECUTABLE = ExecutableInPackage(package="topic_monitor", executable="data_publisher")
PUBLISHERS = [
    [name, "--payload-size", size, "--period", "4"]
    for name, size in (("small", "1"), ("medium", "50000"), ("large", "100000"), ("xlarge", "150000"))
]


def generate_launch_description():
    """Return one publisher for each."""
    return LaunchDescription([ExecuteProcess(cmd=[EXECUTABLE, *words], output="screen") for words in PUBLISHERS])
