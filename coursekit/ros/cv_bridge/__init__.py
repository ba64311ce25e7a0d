"""Conversion between OpenCV's arrays and ROS's images. In ROS 2: vision_opencv's cv_bridge."""

from cv_bridge.boost.cv_bridge_boost import cvtColorForDisplay, getCvType
from cv_bridge.core import CvBridge, CvBridgeError

__all__ = ["CvBridge", "CvBridgeError", "cvtColorForDisplay", "getCvType"]
