"""Models of a single camera and of a stereo pair."""

from __future__ import annotations

import math
from typing import Any

import cv2
import numpy as np
import numpy.typing as npt
from sensor_msgs.msg import CameraInfo

Array = npt.NDArray[np.float64]


class PinholeCameraModel:
    """A camera: K, D, R and P of its CameraInfo, with binning and region of interest taken into account.

    >>> camera = PinholeCameraModel()
    >>> p = np.array([[500, 0, 320, 0], [0, 500, 240, 0], [0, 0, 1, 0]], float)
    >>> camera.fromCameraInfo(CameraInfo(width=640, height=480, k=p[:, :3].ravel(), r=np.eye(3).ravel(), p=p.ravel()))
    >>> camera.project3dToPixel((0.1, 0.0, 1.0))
    (370.0, 240.0)
    """

    def __init__(self) -> None:
        self.K: Array | None = None
        self.D: Array | None = None
        self.R: Array | None = None
        self.P: Array | None = None
        self.full_K: Array | None = None
        self.full_P: Array | None = None
        self.width: int | None = None
        self.height: int | None = None
        self.resolution: tuple[int, int] | None = None
        self.binning_x: int | None = None
        self.binning_y: int | None = None
        self.raw_roi: Any = None
        self.tf_frame: str | None = None
        self.stamp: Any = None

    def fromCameraInfo(self, msg: CameraInfo) -> None:
        """Set all values from a message."""
        self.K, self.R = np.array(msg.k, float).reshape(3, 3), np.array(msg.r, float).reshape(3, 3)
        self.P, self.D = np.array(msg.p, float).reshape(3, 4), np.array(msg.d, float)
        self.full_K, self.full_P = self.K.copy(), self.P.copy()
        self.width, self.height = msg.width, msg.height
        self.resolution = (msg.width, msg.height)
        self.binning_x, self.binning_y = max(1, msg.binning_x), max(1, msg.binning_y)
        self.raw_roi, self.tf_frame, self.stamp = msg.roi, msg.header.frame_id, msg.header.stamp
        for matrix in (self.K, self.P):
            self._shift_and_shrink(matrix)

    def _shift_and_shrink(self, matrix: Array) -> None:
        """Convert to the pixels of the published image: a region of the sensor's image, with binning."""
        matrix[0, 2] -= self.raw_roi.x_offset
        matrix[1, 2] -= self.raw_roi.y_offset
        matrix[0] /= self.binning_x
        matrix[1] /= self.binning_y

    # -- pixels and rays

    def project3dToPixel(self, point: Any) -> tuple[float, float]:
        """The pixel (u, v) of the rectified image of a point (x, y, z) [m]; NaN in the camera's plane."""
        assert self.P is not None
        x, y, w = (float(number) for number in self.P @ np.array([*point, 1.0], float))
        return (x / w, y / w) if w != 0 else (math.nan, math.nan)

    def projectPixelTo3dRay(self, uv: Any) -> tuple[float, float, float]:
        """The unit vector of the ray through a pixel of the rectified image."""
        x, y = (uv[0] - self.cx()) / self.fx(), (uv[1] - self.cy()) / self.fy()
        length = math.sqrt(x * x + y * y + 1.0)
        return (x / length, y / length, 1.0 / length)

    def rectifyImage(self, raw: Any, rectified: Any) -> None:
        """Rectify an image into an array of the same size."""
        size = (raw.shape[1], raw.shape[0])
        x, y = cv2.initUndistortRectifyMap(self.K, self.D, self.R, self.P, size, cv2.CV_32FC1)  # type: ignore[arg-type, call-overload]
        cv2.remap(raw, x, y, cv2.INTER_CUBIC, rectified)

    def rectifyPoint(self, uv_raw: Any) -> Array:
        """The position of a pixel of the raw image in the rectified image."""
        source = np.array(uv_raw, float).reshape(1, 1, 2)
        point: Array = cv2.undistortPoints(source, self.K, self.D, R=self.R, P=self.P)[0, 0]  # type: ignore[arg-type, call-overload]
        return point

    def getDeltaU(self, deltaX: float, Z: float) -> float:
        """The width in pixels of an object with width `deltaX` [m] at depth `Z` [m]."""
        return math.inf if Z == 0 else self.fx() * deltaX / Z

    def getDeltaV(self, deltaY: float, Z: float) -> float:
        """The height in pixels of an object with height `deltaY` [m] at depth `Z` [m]."""
        return math.inf if Z == 0 else self.fy() * deltaY / Z

    def getDeltaX(self, deltaU: float, Z: float) -> float:
        """The width [m] of an object that is `deltaU` pixels wide at depth `Z` [m]."""
        return Z * deltaU / self.fx()

    def getDeltaY(self, deltaV: float, Z: float) -> float:
        """The height [m] of an object that is `deltaV` pixels high at depth `Z` [m]."""
        return Z * deltaV / self.fy()

    # -- parameters

    def fullResolution(self) -> tuple[int, int] | None:
        """Width and height of the sensor's image."""
        return self.resolution

    def intrinsicMatrix(self) -> Array | None:
        """K."""
        return self.K

    def fullIntrinsicMatrix(self) -> Array | None:
        """K of the sensor's whole image."""
        return self.full_K

    def fullProjectionMatrix(self) -> Array | None:
        """P of the sensor's whole image."""
        return self.full_P

    def distortionCoeffs(self) -> Array | None:
        """D."""
        return self.D

    def rotationMatrix(self) -> Array | None:
        """R."""
        return self.R

    def projectionMatrix(self) -> Array | None:
        """P."""
        return self.P

    def _p(self, row: int, column: int) -> float:
        assert self.P is not None
        return float(self.P[row, column])

    def cx(self) -> float:
        """The column of the principal point."""
        return self._p(0, 2)

    def cy(self) -> float:
        """The row of the principal point."""
        return self._p(1, 2)

    def fx(self) -> float:
        """The focal length along x [pixels]."""
        return self._p(0, 0)

    def fy(self) -> float:
        """The focal length along y [pixels]."""
        return self._p(1, 1)

    def Tx(self) -> float:
        """The offset of a pair's second camera to the right [m], times -fx."""
        return self._p(0, 3)

    def Ty(self) -> float:
        """The offset of a pair's second camera downwards [m], times -fy."""
        return self._p(1, 3)

    def fovX(self) -> float:
        """The horizontal field of view [rad]."""
        assert self.full_P is not None and self.width is not None
        return 2 * math.atan(self.width / (2 * self.full_P[0, 0]))

    def fovY(self) -> float:
        """The vertical field of view [rad]."""
        assert self.full_P is not None and self.height is not None
        return 2 * math.atan(self.height / (2 * self.full_P[1, 1]))

    def tfFrame(self) -> str | None:
        """The camera's frame."""
        return self.tf_frame


class StereoCameraModel:
    """A stereo pair; the right camera's P contains their distance."""

    def __init__(self) -> None:
        self.left, self.right = PinholeCameraModel(), PinholeCameraModel()
        self.Q: Array | None = None

    def fromCameraInfo(self, left_msg: CameraInfo, right_msg: CameraInfo) -> None:
        """Set all values from two messages."""
        self.left.fromCameraInfo(left_msg)
        self.right.fromCameraInfo(right_msg)
        f, base = self.right.fx(), self.right.Tx() / self.right.fx()
        self.Q = np.zeros((4, 4))
        self.Q[0, 0] = self.Q[1, 1] = 1.0
        self.Q[0, 3], self.Q[1, 3], self.Q[2, 3] = -self.right.cx(), -self.right.cy(), f
        self.Q[3, 2], self.Q[3, 3] = -1.0 / base, (self.left.cx() - self.right.cx()) / base

    def tfFrame(self) -> str | None:
        """The left camera's frame."""
        return self.left.tfFrame()

    def project3dToPixel(self, point: Any) -> tuple[tuple[float, float], tuple[float, float]]:
        """The pixels of a point in the left and the right image."""
        return self.left.project3dToPixel(point), self.right.project3dToPixel(point)

    def projectPixelTo3d(self, left_uv: Any, disparity: float) -> tuple[float, float, float]:
        """The point at a pixel of the left image with that disparity; (0, 0, 0) if it is infinitely far away."""
        assert self.Q is not None
        x, y, z, w = (float(number) for number in self.Q @ np.array([left_uv[0], left_uv[1], disparity, 1.0]))
        return (x / w, y / w, z / w) if w != 0 else (0.0, 0.0, 0.0)

    def getZ(self, disparity: float) -> float:
        """The depth [m] of a point with that disparity [pixels]."""
        return math.inf if disparity == 0 else -self.right.Tx() / (disparity - (self.left.cx() - self.right.cx()))

    def getDisparity(self, Z: float) -> float:
        """The disparity [pixels] of a point at that depth [m]."""
        return math.inf if Z == 0 else -self.right.Tx() / Z + self.left.cx() - self.right.cx()
