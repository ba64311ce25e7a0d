"""A live view of an image topic in the notebook."""

from __future__ import annotations

import numpy as np
from sensor_msgs.msg import CompressedImage, Image

from coursekit.cli.session_client import domain_id
from coursekit.core.graph_node import GraphNode
from coursekit.core.qos import BEST_EFFORT, Qos
from coursekit.core.topic import Subscription
from coursekit.nodes.images.transport import to_bgr
from coursekit.processes.session import current

from .picture import Picture


class _Taker:
    """Takes each message on arrival and keeps the newest."""

    def __init__(self, view: ImageView) -> None:
        self._view = view

    def put(self, subscription: Subscription) -> None:
        """Take the queued messages."""
        subscription.queued = False
        while (entry := subscription.take()) is not None:
            self._view.take(entry[0])


class ImageView(Picture):
    """Shows a topic of sensor_msgs/Image or CompressedImage; made by `image_view`.

    `message` is the newest message, `count` the number received, `drawn` the number of the last one sent to the
    browser.
    """

    def __init__(self, topic: str) -> None:
        super().__init__(self._newest)
        self.topic = topic if topic.startswith("/") else f"/{topic}"
        self.message: Image | CompressedImage | None = None
        self.count = 0
        self.drawn = 0
        self._node: GraphNode | None = None
        self._listen()

    def _listen(self) -> None:
        node = current().graph(domain_id()).add_node("image_view" + self.topic.replace("/", "_"), "/")
        kind = CompressedImage if self.topic.endswith("/compressed") else Image
        subscription = node.subscription(self.topic, kind, Qos(depth=1, reliability=BEST_EFFORT))
        subscription.attach(_Taker(self), subscription)  # type: ignore[arg-type]
        self._node = node

    def take(self, message: Image | CompressedImage) -> None:
        """Store a newer message."""
        self.message = message
        self.count += 1
        self.news()

    @property
    def image(self) -> np.ndarray | None:
        """The newest image in BGR order; None before the first."""
        return self._newest()

    def _newest(self) -> np.ndarray | None:
        self.drawn = self.count
        return None if self.message is None else to_bgr(self.message)

    def heading(self) -> str:
        """The topic."""
        return self.topic

    def note(self) -> str:
        """The size and encoding of the newest image."""
        message = self.message
        if message is None:
            return ""
        if isinstance(message, Image):
            return f"{message.width}x{message.height} {message.encoding}"
        return f"{message.format}, {len(message.data)} bytes"

    def is_open(self) -> bool:
        """Whether the topic has a publisher."""
        return bool(current().graph(domain_id()).publishers.get(self.topic))

    def __repr__(self) -> str:
        if self.message is None:
            return f"[image {self.topic}: no image yet; `ros2 topic info {self.topic}` shows its publishers]"
        return f"[image {self.topic}: {self.note()}]"


def image_view(topic: str = "/camera/image_raw") -> ImageView:
    """Show the newest image of a topic, live; `.image` is that image as an array in BGR order.

    >>> %ros2 run image_tools cam2image --ros-args -p burger_mode:=true &
    [cam2image: running]
    >>> camera = image_view("/image")
    >>> wait(until="/image")
    >>> camera
    [image /image: 320x240 bgr8]
    >>> camera.image.shape
    (240, 320, 3)
    """
    return ImageView(topic)
