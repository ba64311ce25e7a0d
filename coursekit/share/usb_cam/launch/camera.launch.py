"""A camera under the names camera1/image_raw and so on, with the parameters of config/params_1.yaml."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    """Return the driver of one camera."""
    file = Path(get_package_share_directory("usb_cam")) / "config" / "params_1.yaml"
    return LaunchDescription(
        [
            Node(
                package="usb_cam",
                executable="usb_cam_node_exe",
                name="camera1",
                output="screen",
                parameters=[str(file)],
                remappings=[
                    ("image_raw", "camera1/image_raw"),
                    ("image_raw/compressed", "camera1/image_compressed"),
                    ("camera_info", "camera1/camera_info"),
                ],
            ),
        ]
    )
