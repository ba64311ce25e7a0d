"""`ros2 run image_proc resize_node`, also image_proc::ResizeNode: image/image_raw in another size as resize/image_raw."""

from __future__ import annotations

from typing import Any

import cv2
from sensor_msgs.msg import CameraInfo

from coursekit.nodes.running import run

from .camera_stage import CameraStage

_DEFAULTS = {"interpolation": 1, "use_scale": True, "scale_height": 1.0, "scale_width": 1.0, "height": -1, "width": -1}


class ResizeNode(CameraStage):
    """Scales images by `scale_width` and `scale_height`, or with `use_scale` false to `width` and `height`."""

    def __init__(self) -> None:
        super().__init__("ResizeNode", "image", "resize", _DEFAULTS)

    def change(self, picture: Any, info: CameraInfo) -> Any:
        """Scale the picture, and focal lengths and centres with it."""
        rows, columns = picture.shape[:2]
        if self.given["use_scale"]:
            across, down = self.given["scale_width"], self.given["scale_height"]
            width, height = max(1, round(columns * across)), max(1, round(rows * down))
            info.width, info.height = int(info.width * across), int(info.height * down)
        else:
            width = columns if self.given["width"] == -1 else self.given["width"]
            height = rows if self.given["height"] == -1 else self.given["height"]
            across, down = width / (info.width or columns), height / (info.height or rows)
            info.width, info.height = width, height
        for matrix, scaled in ((info.k, ((0, across), (2, across), (4, down), (5, down))),
                               (info.p, ((0, across), (2, across), (3, across), (5, down), (6, down)))):  # fmt: skip
            for place, scale in scaled:
                matrix[place] *= scale
        return cv2.resize(picture, (width, height), interpolation=self.given["interpolation"])


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(ResizeNode, args)
