"""A server of interactive markers: it tells its clients of them, and its program what they do with them."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from dataclasses import dataclass, field
from threading import Lock
from typing import Any

from geometry_msgs.msg import Pose
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from std_msgs.msg import Header
from visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerFeedback,
    InteractiveMarkerPose,
    InteractiveMarkerUpdate,
)
from visualization_msgs.srv import GetInteractiveMarkers

Callback = Callable[[InteractiveMarkerFeedback], object]
ONE_CLIENT = Duration(seconds=1)
"""How long a marker belongs to the client that moved it last."""


@dataclass
class Callbacks:
    """What is called at feedback: by its type, or by default."""

    default_feedback_callback: Callback | None = None
    feedback_callbacks: dict[int, Callback] = field(default_factory=dict)

    def put(self, kind: int, callback: Callback | None) -> None:
        """Set or unset (None) one of them."""
        if kind == InteractiveMarkerServer.DEFAULT_FEEDBACK_CALLBACK:
            self.default_feedback_callback = callback
        elif callback is not None:
            self.feedback_callbacks[kind] = callback
        else:
            self.feedback_callbacks.pop(kind, None)


@dataclass
class MarkerContext(Callbacks):
    """A marker that clients know."""

    int_marker: InteractiveMarker = field(default_factory=InteractiveMarker)
    last_feedback: Time = field(default_factory=Time)
    last_client_id: str = ""


@dataclass
class UpdateContext(Callbacks):
    """A change that `applyChanges` will send."""

    FULL_UPDATE = 0
    POSE_UPDATE = 1
    ERASE = 2

    update_type: int = FULL_UPDATE
    int_marker: InteractiveMarker = field(default_factory=InteractiveMarker)


class InteractiveMarkerServer:
    """Markers below the topics `topic_ns`/update and `topic_ns`/feedback; changes count from `applyChanges()` on."""

    DEFAULT_FEEDBACK_CALLBACK = 255

    def __init__(self, node: Node, topic_ns: str, q_size: int = 100) -> None:
        self.node, self.topic_ns, self.seq_num = node, topic_ns, 0
        self.mutex = Lock()
        self.marker_contexts: dict[str, MarkerContext] = {}
        self.pending_updates: dict[str, UpdateContext] = {}
        self.get_interactive_markers_srv: Any = node.create_service(
            GetInteractiveMarkers, f"{topic_ns}/get_interactive_markers", self.getInteractiveMarkersCallback
        )
        self.update_pub: Any = node.create_publisher(InteractiveMarkerUpdate, f"{topic_ns}/update", q_size)
        self.feedback_sub: Any = node.create_subscription(
            InteractiveMarkerFeedback, f"{topic_ns}/feedback", self.processFeedback, q_size
        )

    def shutdown(self) -> None:
        """Erase all markers and end; to be called before the node is destroyed."""
        if self.update_pub is None:
            return
        self.clear()
        self.applyChanges()
        self.node.destroy_service(self.get_interactive_markers_srv)
        self.node.destroy_publisher(self.update_pub)
        self.node.destroy_subscription(self.feedback_sub)
        self.get_interactive_markers_srv = self.update_pub = self.feedback_sub = None

    def __del__(self) -> None:
        with contextlib.suppress(Exception):  # its node may have been destroyed before it
            self.shutdown()

    def insert(
        self,
        marker: InteractiveMarker,
        *,
        feedback_callback: Callback | None = None,
        feedback_type: int = DEFAULT_FEEDBACK_CALLBACK,
    ) -> None:
        """Add or replace a marker; its callback counts at once."""
        with self.mutex:
            update = self.pending_updates.setdefault(marker.name, UpdateContext())
            update.update_type, update.int_marker = UpdateContext.FULL_UPDATE, marker
        if feedback_callback is not None:
            self.setCallback(marker.name, feedback_callback, feedback_type)

    def setPose(self, name: str, pose: Pose, header: Header | None = None) -> bool:
        """Move a marker, in its old frame if `header` names none. False for a marker that clients do not know."""
        with self.mutex:
            known, update = self.marker_contexts.get(name), self.pending_updates.get(name)
            if known is None or (update is not None and update.update_type == UpdateContext.FULL_UPDATE):
                return False
            told = header if header is not None and header.frame_id else known.int_marker.header
            self.doSetPose(update, name, pose, told)
            return True

    def erase(self, name: str) -> bool:
        """Erase a marker; False if there is none of this name."""
        with self.mutex:
            if name not in self.pending_updates and name not in self.marker_contexts:
                return False
            self.pending_updates.setdefault(name, UpdateContext()).update_type = UpdateContext.ERASE
            return True

    def clear(self) -> None:
        """Erase all markers."""
        self.pending_updates = {}
        for name in self.marker_contexts:
            self.erase(name)

    def setCallback(
        self, name: str, feedback_callback: Callback | None, feedback_type: int = DEFAULT_FEEDBACK_CALLBACK
    ) -> bool:
        """Set the function for one type of feedback, or for all others; None unsets it. False for an unknown marker."""
        with self.mutex:
            known = [self.marker_contexts.get(name), self.pending_updates.get(name)]
            for context in known:
                if context is not None:
                    context.put(feedback_type, feedback_callback)
            return any(context is not None for context in known)

    def applyChanges(self) -> None:
        """Make the changes since the last call count, and tell the clients."""
        with self.mutex:
            if not self.pending_updates:
                return
            message = InteractiveMarkerUpdate(type=InteractiveMarkerUpdate.UPDATE)
            for name, update in self.pending_updates.items():
                self._apply(name, update, message)
            self.pending_updates = {}
        self.seq_num += 1
        self.publish(message)

    def _apply(self, name: str, update: UpdateContext, message: InteractiveMarkerUpdate) -> None:
        known = self.marker_contexts.get(name)
        if update.update_type == UpdateContext.FULL_UPDATE:
            if known is None:
                known = self.marker_contexts[name] = MarkerContext(
                    update.default_feedback_callback, update.feedback_callbacks, last_feedback=self.node.get_clock().now()
                )
            known.int_marker = update.int_marker
            message.markers.append(known.int_marker)
        elif update.update_type == UpdateContext.POSE_UPDATE and known is not None:
            marker = known.int_marker
            marker.pose, marker.header = update.int_marker.pose, update.int_marker.header
            message.poses.append(InteractiveMarkerPose(header=marker.header, pose=marker.pose, name=marker.name))
        elif update.update_type == UpdateContext.ERASE and known is not None:
            del self.marker_contexts[name]
            message.erases.append(name)

    def get(self, name: str) -> InteractiveMarker | None:
        """Return a marker as it will be after the pending changes; None if there is none."""
        update, known = self.pending_updates.get(name), self.marker_contexts.get(name)
        if update is None:
            return None if known is None else known.int_marker
        if update.update_type == UpdateContext.FULL_UPDATE:
            return update.int_marker
        if update.update_type == UpdateContext.ERASE or known is None:
            return None
        known.int_marker.pose = update.int_marker.pose
        return known.int_marker

    def processFeedback(self, feedback: InteractiveMarkerFeedback) -> None:
        """Move the marker, if a client did, and call the function for this feedback."""
        with self.mutex:
            known = self.marker_contexts.get(feedback.marker_name)
            if known is None:
                return
            now, other = self.node.get_clock().now(), known.last_client_id != feedback.client_id
            if other and now - known.last_feedback < ONE_CLIENT:
                text = f"Rejecting feedback for {feedback.marker_name}: conflicting feedback from separate clients."
                self.node.get_logger().debug(text)
                return
            known.last_feedback, known.last_client_id = now, feedback.client_id
            if feedback.event_type == InteractiveMarkerFeedback.POSE_UPDATE:
                update = self.pending_updates.get(feedback.marker_name)
                self.doSetPose(update, feedback.marker_name, feedback.pose, feedback.header)
        callback = known.feedback_callbacks.get(feedback.event_type, known.default_feedback_callback)
        if callback is not None:
            callback(feedback)

    def publish(self, update: InteractiveMarkerUpdate) -> None:
        """Send an update with the current number."""
        update.seq_num = self.seq_num
        self.update_pub.publish(update)

    def getInteractiveMarkersCallback(
        self, request: GetInteractiveMarkers.Request, response: GetInteractiveMarkers.Response
    ) -> GetInteractiveMarkers.Response:
        """Answer a new client with all markers."""
        with self.mutex:
            response.sequence_number = self.seq_num
            response.markers = [context.int_marker for context in self.marker_contexts.values()]
            return response

    def doSetPose(self, update: UpdateContext | None, name: str, pose: Pose, header: Header) -> None:
        """Note a new pose; the lock is held."""
        if update is None:
            update = self.pending_updates[name] = UpdateContext(update_type=UpdateContext.POSE_UPDATE)
        elif update.update_type != UpdateContext.FULL_UPDATE:
            update.update_type = UpdateContext.POSE_UPDATE
        update.int_marker.pose, update.int_marker.header = pose, header
        at = pose.position
        self.node.get_logger().debug(f"Marker '{name}' is now at {at.x}, {at.y}, {at.z}")
