"""Markers that users move, and their menus.

In ROS 2: the Python module of the package interactive_markers.
"""

from .interactive_marker_server import InteractiveMarkerServer
from .menu_handler import MenuHandler

__all__ = ["InteractiveMarkerServer", "MenuHandler"]
