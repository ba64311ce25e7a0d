"""From a camera's image_raw to image_rect and image_rect_color, in a container of its own or in one that is there."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import LaunchConfigurationEquals, LaunchConfigurationNotEquals
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes
from launch_ros.descriptions import ComposableNode

STEPS = (
    ("debayer_node", "DebayerNode", []),
    ("rectify_mono_node", "RectifyNode", [("image", "image_mono")]),
    ("rectify_color_node", "RectifyNode", [("image", "image_color"), ("image_rect", "image_rect_color")]),
)
"""Name, class and remappings of each node."""


def generate_launch_description():
    """Return the arguments, and the nodes in the container that the argument `container` names, else in a new one."""
    namespace, container = LaunchConfiguration("namespace"), LaunchConfiguration("container")
    nodes = [
        ComposableNode(package="image_proc", plugin=f"image_proc::{kind}", name=name, namespace=namespace, remappings=names)
        for name, kind, names in STEPS
    ]
    alone = ComposableNodeContainer(
        package="rclcpp_components",
        executable="component_container",
        name="image_proc_container",
        namespace=namespace,
        composable_node_descriptions=nodes,
        output="screen",
        condition=LaunchConfigurationEquals("container", ""),
    )
    inside = LoadComposableNodes(
        target_container=container,
        composable_node_descriptions=nodes,
        condition=LaunchConfigurationNotEquals("container", ""),
    )
    return LaunchDescription(
        [
            DeclareLaunchArgument("namespace", default_value="", description="Namespace of the camera's topics"),
            DeclareLaunchArgument("container", default_value="", description="Container that is there; empty: a new one"),
            alone,
            inside,
        ]
    )
