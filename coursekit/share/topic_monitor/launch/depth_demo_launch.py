"""Publishers of small and large messages that keep one message or fifty."""

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.substitutions import ExecutableInPackage

EXECUTABLE = ExecutableInPackage(package="topic_monitor", executable="data_publisher")
PUBLISHERS = [
    [f"{size}_depth_{depth}", "--depth", str(depth), "--payload-size", payload]
    for size, payload in (("small", "0"), ("large", "100000"))
    for depth in (1, 50)
]


def generate_launch_description():
    """Return one publisher for each."""
    return LaunchDescription([ExecuteProcess(cmd=[EXECUTABLE, *words], output="screen") for words in PUBLISHERS])
