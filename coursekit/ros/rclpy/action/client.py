"""Action clients. In ROS 2: rclpy.action.client."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalStatusArray
from action_msgs.srv import CancelGoal
from unique_identifier_msgs.msg import UUID

from coursekit.processes import session
from rclpy._lent import lender
from rclpy._one_type import check_action_type
from rclpy._parts_wait import PartsWait
from rclpy.action.client_goal_handle import ClientGoalHandle
from rclpy.action.goal_state import TERMINAL
from rclpy.action.names import action_names
from rclpy.qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from rclpy.task import Future
from rclpy.type_support import check_for_type_support
from rclpy.waitable import NumberOfEntities

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.node import Node

__getattr__ = lender(__name__)  # names that programs import from here

_POLL_SEC = 0.01
_LATE_FEEDBACK = 50
"""The number of finished goals whose feedback is still passed on."""


class ActionClient(PartsWait):
    """Sends goals to an action server, over the services and topics below `<action_name>/_action/`.

    >>> from example_interfaces.action import Fibonacci
    >>> client = ActionClient(node, Fibonacci, "fibonacci")
    >>> client.wait_for_server(timeout_sec=1.0)  # its server does not run
    False
    """

    def __init__(
        self,
        node: Node,
        action_type: type[Any],
        action_name: str,
        *,
        callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile = QoSProfile(depth=10),
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default,
    ) -> None:
        group = node.default_callback_group if callback_group is None else callback_group
        super().__init__(group)
        check_for_type_support(action_type)
        self._node = node
        self._action_type = action_type
        self._action_name = action_name
        self._goal_handles: dict[bytes, weakref.ref[ClientGoalHandle]] = {}
        self._feedback_callbacks: dict[bytes, Callable[[Any], Any]] = {}
        self._finished: list[bytes] = []
        self._early_statuses: dict[bytes, int | None] = {}
        names, impl = action_names("client", action_name), action_type.Impl
        check_action_type(node.handle, "client", names.send_goal, impl.SendGoalService)

        def client(type_: Any, name: str, qos: QoSProfile) -> Any:
            return node.create_client(type_, name, qos_profile=qos, callback_group=group)

        self._goal_client = client(impl.SendGoalService, names.send_goal, goal_service_qos_profile)
        self._cancel_client = client(CancelGoal, names.cancel_goal, cancel_service_qos_profile)
        self._result_client = client(impl.GetResultService, names.get_result, result_service_qos_profile)
        self._feedback_subscription = node.create_subscription(
            impl.FeedbackMessage,
            names.feedback,
            self._heard_feedback,
            feedback_sub_qos_profile,
            callback_group=group,
        )
        self._status_subscription = node.create_subscription(
            GoalStatusArray, names.status, self._heard_status, status_sub_qos_profile, callback_group=group
        )

    # -- messages from the server

    def _heard_feedback(self, message: Any) -> Any:
        callback = self._feedback_callbacks.get(bytes(message.goal_id.uuid))
        return None if callback is None else callback(message)

    def _heard_status(self, message: Any) -> None:
        for each in message.status_list:
            key = bytes(each.goal_info.goal_id.uuid)
            if key in self._early_statuses:
                self._early_statuses[key] = each.status
            reference = self._goal_handles.get(key)
            handle = reference() if reference is not None else None
            if handle is not None:
                handle._update_status(each.status)
            if each.status in TERMINAL:
                self._goal_handles.pop(key, None)
                self._forget_feedback(key)

    def _forget_feedback(self, key: bytes) -> None:
        """Drop a finished goal's callback, but not at once: feedback may still arrive."""
        if key in self._feedback_callbacks and key not in self._finished:
            self._finished.append(key)
        while len(self._finished) > _LATE_FEEDBACK:
            self._feedback_callbacks.pop(self._finished.pop(0), None)

    # -- goals

    def send_goal(self, goal: Any, **kwargs: Any) -> Any:
        """Send a goal and wait for its result; never in a callback of the executor that must take it.

        Takes the options of send_goal_async. Raises TypeError for anything but the action's Goal.
        """
        return self._get_result(_wait(self.send_goal_async(goal, **kwargs)))

    def send_goal_async(
        self, goal: Any, feedback_callback: Callable[[Any], Any] | None = None, goal_uuid: UUID | None = None
    ) -> Future:
        """Send a goal; the future gets a ClientGoalHandle once the server has accepted or rejected it.

        `feedback_callback(message)` is called with every feedback message (its `feedback` is the action's).
        """
        if not isinstance(goal, self._action_type.Goal):
            expected = type(self._action_type.Goal)
            raise TypeError(f"Expected goal type ({expected}) but received ({type(goal)})")
        request = self._action_type.Impl.SendGoalService.Request()
        request.goal_id = UUID(uuid=list(session.current().new_uuid())) if goal_uuid is None else goal_uuid
        request.goal = goal
        key = bytes(request.goal_id.uuid)
        if feedback_callback is not None:
            self._feedback_callbacks[key] = feedback_callback
        self._early_statuses[key] = None
        answered = self._goal_client.call_async(request)
        return _then(answered, lambda response: self._goal_answered(request.goal_id, response))

    def _goal_answered(self, goal_id: UUID, response: Any) -> ClientGoalHandle:
        key = bytes(goal_id.uuid)
        handle = ClientGoalHandle(self, goal_id, response)
        early = self._early_statuses.pop(key, None)
        if not handle.accepted:
            self._feedback_callbacks.pop(key, None)
            return handle
        if early is not None:
            handle._update_status(early)
        if handle.status not in TERMINAL:
            self._goal_handles[key] = weakref.ref(handle)
        return handle

    def _cancel_goal(self, goal_handle: ClientGoalHandle) -> Any:
        return _wait(self._cancel_goal_async(goal_handle))

    def _cancel_goal_async(self, goal_handle: ClientGoalHandle) -> Future:
        _check_handle(goal_handle)
        request = CancelGoal.Request()
        request.goal_info.goal_id = goal_handle.goal_id
        return self._cancel_client.call_async(request)

    def _get_result(self, goal_handle: ClientGoalHandle) -> Any:
        return _wait(self._get_result_async(goal_handle))

    def _get_result_async(self, goal_handle: ClientGoalHandle) -> Future:
        _check_handle(goal_handle)
        request = self._action_type.Impl.GetResultService.Request(goal_id=goal_handle.goal_id)

        def answered(response: Any) -> Any:
            goal_handle._update_status(response.status)
            self._feedback_callbacks.pop(bytes(goal_handle.goal_id.uuid), None)  # no feedback after the result
            return response

        return _then(self._result_client.call_async(request), answered)

    # -- the server

    def server_is_ready(self) -> bool:
        """Whether a server is available with all its services and topics."""
        topics = (self._feedback_subscription.topic_name, self._status_subscription.topic_name)
        return all(client.service_is_ready() for client in self._clients) and all(
            self._node.count_publishers(topic) for topic in topics
        )

    @property
    def _clients(self) -> tuple[Any, Any, Any]:
        return self._goal_client, self._cancel_client, self._result_client

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Wait for a server; False if `timeout_sec` seconds passed or ROS was shut down."""
        clock = session.current().clock
        end = None if timeout_sec is None or timeout_sec < 0 else clock.steady() + int(timeout_sec * 1e9)
        while not self.server_is_ready():
            left = None if end is None else (end - clock.steady()) / 1e9
            if not self._node.context.ok() or (left is not None and left <= 0):
                return False
            if all(client.wait_for_service(left) for client in self._clients):
                clock.sleep(_POLL_SEC if left is None else min(left, _POLL_SEC))
        return True

    def get_num_entities(self) -> NumberOfEntities:
        """Three clients, two subscriptions."""
        return NumberOfEntities(num_clients=3, num_subs=2)

    def destroy(self) -> None:
        """Destroy the clients and subscriptions; responses that have not arrived yet are lost."""
        for client in self._clients:
            self._node.destroy_client(client)
        self._node.destroy_subscription(self._feedback_subscription)
        self._node.destroy_subscription(self._status_subscription)


def _check_handle(goal_handle: Any) -> None:
    if not isinstance(goal_handle, ClientGoalHandle):
        raise TypeError(f"Expected type ClientGoalHandle but received {type(goal_handle)}")


def _then(source: Future, change: Callable[[Any], Any]) -> Future:
    """A future of `change(result)` of the source; cancelling it cancels the source."""
    target = Future()

    def done(finished: Future) -> None:
        error = finished.exception()
        if finished.cancelled():
            target.cancel()
        elif error is not None:
            target.set_exception(error)
        else:
            target.set_result(change(finished.result()))

    def given_up(finished: Future) -> None:
        if finished.cancelled():
            source.cancel()

    source.add_done_callback(done)
    target.add_done_callback(given_up)
    return target


def _wait(future: Future) -> Any:
    event = session.current().clock.new_event()
    future.add_done_callback(lambda _: event.set())
    event.wait()
    if future.exception() is not None:
        raise future.exception()  # type: ignore[misc]
    return future.result()
