"""The view of the world, opened by a cell or by `gzclient`, whose window appears below the cell that started it.

The drawing code is loaded on first use: physics and their compiler would take a third of a kernel's start.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.nodes.gazebo.gzclient import windows

from .node_windows import NodeWindows

if TYPE_CHECKING:
    from .world_panel import WorldView


def world_view(height: int = 420) -> WorldView:
    """Show the true state of the simulated world in 3D: pause, step and reset it, drag robots and objects, add boxes.

    It shows the newest simulator of this notebook. From code: `world_view().pause()`, `.step(0.5)`, `.speed(2)`,
    `.move("box_1", 1.0, 0.5)`, `.add_box(1.0, 0.0)`.

    >>> %ros2 launch gazebo_ros gazebo.launch.py world:=robot_world &
    [gazebo.launch.py: running]
    >>> wait(1)
    >>> world = world_view()
    >>> world.add_box(1.0, 0.0)
    'box_1'
    >>> world.move("box_1", 2.0, 0.0)

    In ROS 2: `gzclient`, Gazebo's window.
    """
    from .world_panel import WorldView

    return WorldView(height)


_windows = NodeWindows(windows, lambda _window: world_view())


def show_world_windows() -> None:
    """Show the windows of gzclient in this notebook."""
    _windows.watch()


__all__ = ["show_world_windows", "world_view"]
