"""`ros2 run image_proc crop_decimate_node`, also image_proc::CropDecimateNode: a part of in/image_raw as out/image_raw."""

from __future__ import annotations

from typing import Any

import cv2
from sensor_msgs.msg import CameraInfo

from coursekit.nodes.running import run

from .camera_stage import CameraStage

_DEFAULTS = {
    "queue_size": 5, "decimation_x": 1, "decimation_y": 1, "width": 0, "height": 0, "offset_x": 0, "offset_y": 0,
    "interpolation": 0,
}  # fmt: skip


class CropDecimateNode(CameraStage):
    """Cuts `width` by `height` pixels out at an offset (0: as many as there are), and keeps every n-th of them."""

    def __init__(self) -> None:
        super().__init__("CropDecimateNode", "in", "out", _DEFAULTS)

    def change(self, picture: Any, info: CameraInfo) -> Any:
        """Cut and decimate; the info tells the cut as a region and the decimation as binning."""
        rows, columns = picture.shape[:2]
        left, top = self.given["offset_x"], self.given["offset_y"]
        width, height = (
            min(most, wanted) if wanted > 0 else most
            for wanted, most in ((self.given["width"], columns - left), (self.given["height"], rows - top))
        )
        across, down = self.given["decimation_x"], self.given["decimation_y"]
        self._tell(info, left, top, width, height)
        info.roi.do_rectify = info.roi.do_rectify or (width, height) != (columns, rows)
        part = picture[top : top + height, left : left + width]
        if self.given["interpolation"] == 0:
            return part[::down, ::across].copy()
        return cv2.resize(part, (width // across, height // down), interpolation=self.given["interpolation"])

    def _tell(self, info: CameraInfo, left: int, top: int, width: int, height: int) -> None:
        binned_x, binned_y = max(info.binning_x, 1), max(info.binning_y, 1)
        info.binning_x, info.binning_y = binned_x * self.given["decimation_x"], binned_y * self.given["decimation_y"]
        info.roi.x_offset += left * binned_x
        info.roi.y_offset += top * binned_y
        info.roi.width, info.roi.height = width * binned_x, height * binned_y


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(CropDecimateNode, args)
