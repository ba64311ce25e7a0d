"""A compiled program's requests about actions: the servers and clients are rclpy's, the decisions the program's."""

from __future__ import annotations

from functools import partial
from threading import Lock, local
from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalStatus
from action_msgs.srv import CancelGoal
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.action.goal_state import GoalEvent
from rclpy.time import Time

from coursekit.interfaces.cdr import deserialize, serialize
from coursekit.interfaces.registry import load
from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.valid_objects import check_node_of_client

if TYPE_CHECKING:
    from collections.abc import Callable

    from rclpy.action.goal_handle import ServerGoalHandle
    from rclpy.node import Node
    from rclpy.service import Service
    from rclpy.task import Future

    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

_ACCEPT_AND_EXECUTE, _ACCEPT_AND_DEFER = 2, 3
_ACCEPT_CANCEL = 2


class _RefusesAll:
    """Responds like rclcpp's servers: if no goal may be canceled, the whole request is rejected."""

    def __init__(self, service: Service) -> None:
        self._service = service

    def send_response(self, response: CancelGoal.Response, header: object) -> None:
        """Send the response."""
        if response.return_code == CancelGoal.Response.ERROR_NONE and not response.goals_canceling:
            response.return_code = CancelGoal.Response.ERROR_REJECTED
        self._service.send_response(response, header)


class CompiledActionServer(ActionServer):
    """Asks the program whether to accept a goal, also by its id, and notifies it of accepted goals."""

    def __init__(
        self, host: Host, handlers: tuple[int, int, int], node: Node, kind: type[Any], name: str, **options: Any
    ) -> None:
        self._host = host
        self._goal_handler, self._accepted_handler, self._cancel_handler = handlers
        self._asked = local()
        super().__init__(
            node,
            kind,
            name,
            _nothing,
            goal_callback=self._decide,
            handle_accepted_callback=self._tell,
            cancel_callback=self._decide_cancel,
            **options,
        )

    async def _accepted(self, request: Any) -> Any:
        self._asked.key = bytes(request.goal_id.uuid)
        return await super()._accepted(request)

    def _begin(self, handle: ServerGoalHandle) -> None:
        if self._asked.answer == _ACCEPT_AND_EXECUTE:
            handle._update_state(GoalEvent.EXECUTE)  # rclcpp tells of this state only, not of the one before
        else:
            super()._begin(handle)

    def _decide(self, goal: object) -> GoalResponse:
        answer = self._host.call(self._goal_handler, packed(self._asked.key) + serialize(goal)).integer()
        self._asked.answer = answer
        return GoalResponse.ACCEPT if answer in (_ACCEPT_AND_EXECUTE, _ACCEPT_AND_DEFER) else GoalResponse.REJECT

    def _tell(self, handle: ServerGoalHandle) -> None:
        self._host.call(self._accepted_handler, packed(bytes(handle.goal_id.uuid)))

    def _decide_cancel(self, handle: ServerGoalHandle) -> CancelResponse:
        answer = self._host.call(self._cancel_handler, packed(bytes(handle.goal_id.uuid))).integer()
        return CancelResponse.ACCEPT if answer == _ACCEPT_CANCEL else CancelResponse.REJECT

    async def _cancel_asked(self, service: Service, request: CancelGoal.Request, header: object) -> None:
        await super()._cancel_asked(_RefusesAll(service), request, header)

    def goal(self, key: bytes) -> Any:
        """Return the handle of a goal."""
        return self._goal_handles[key]

    def end(self, key: bytes, how: str, result: bytes) -> None:
        """End a goal (succeed, abort or canceled), and send its result to those who requested it."""
        handle = self._goal_handles[key]
        getattr(handle, how)()
        response = self._action_type.Impl.GetResultService.Response(status=handle.status)
        response.result = deserialize(result, self._action_type.Result)
        self._result_futures[key].set_result(response)

    def drop(self, key: bytes) -> None:
        """Handle a goal dropped by the program: an active one is canceled, because nothing executes it."""
        handle = self._goal_handles.get(key)
        if handle is None or not handle.is_active:
            return
        if not handle.is_cancel_requested:
            if handle.status == GoalStatus.STATUS_ACCEPTED:
                handle._update_state(GoalEvent.EXECUTE)
            handle._update_state(GoalEvent.CANCEL_GOAL)
        self.end(key, "canceled", serialize(self._action_type.Result()))


def _nothing(_handle: ServerGoalHandle) -> None:
    """Never called: the program executes its goals itself."""


def do_action_server(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make an action server."""
    node, kind, name = host.things[frame.integer()], load(frame.text()), frame.text()
    handlers = (frame.integer(), frame.integer(), frame.integer())
    group, keep_ns = host.things.get(frame.integer()), frame.integer()
    server = CompiledActionServer(host, handlers, node, kind, name, callback_group=group, result_timeout=keep_ns / 1e9)
    return packed(host.keep(server), name)


def _server(host: Host, frame: Unpacker) -> tuple[CompiledActionServer, bytes]:
    return host.things[frame.integer()], frame.blob()


def do_goal_status(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the status of a goal: a number of action_msgs/msg/GoalStatus."""
    server, key = _server(host, frame)
    return packed(server.goal(key).status)


def do_goal_execute(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Start a deferred goal."""
    server, key = _server(host, frame)
    server.goal(key)._update_state(GoalEvent.EXECUTE)


def do_goal_end(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """End a goal, with its result."""
    server, key = _server(host, frame)
    server.end(key, frame.text(), frame.blob())


def do_goal_dropped(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Handle a goal whose handle in the program is gone."""
    server = host.things.get(frame.integer())
    if server is not None:
        server.drop(frame.blob())


def do_feedback(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Publish feedback to the clients of a goal."""
    server, key = _server(host, frame)
    server.goal(key).publish_feedback(deserialize(frame.blob(), server.action_type.Feedback))


# -- clients


class _Sent:
    """A sent goal. Feedback that arrives before the response is held back: the program does not know its goal yet."""

    def __init__(self, tell_answer: Callable[[Any], None], tell_feedback: Callable[[Any], None]) -> None:
        self._tell_answer = tell_answer
        self._tell_feedback = tell_feedback
        self._early: list[Any] = []
        self._answered = False
        self._lock = Lock()

    def heard(self, message: object) -> None:
        """Handle feedback."""
        with self._lock:
            if not self._answered:
                self._early.append(message)
                return
        self._tell_feedback(message)

    def answered(self, future: Future) -> None:
        """Handle the response: pass it on, then the held feedback in order."""
        self._tell_answer(future)
        while early := self._waiting():
            for message in early:
                self._tell_feedback(message)

    def _waiting(self) -> list[Any]:
        with self._lock:
            early, self._early = self._early, []
            self._answered = not early
        return early


class CompiledActionClient(ActionClient):
    """Tracks its goals by id, until their results arrive."""

    def __init__(self, host: Host, handlers: tuple[int, int, int, int], *names: Any, **options: Any) -> None:
        super().__init__(*names, **options)
        self.host = host
        self.goal_handler, self.feedback_handler, self.result_handler, self.cancel_handler = handlers
        self.goals: dict[bytes, Any] = {}

    def send(self, number: int, goal: bytes) -> None:
        """Send a goal; the program receives the response under its number."""
        sent = _Sent(partial(self._tell_answer, number), self._tell_feedback)
        future = self.send_goal_async(deserialize(goal, self._action_type.Goal), feedback_callback=sent.heard)
        future.add_done_callback(sent.answered)

    def _tell_answer(self, number: int, future: Future) -> None:
        handle = future.result()
        key = bytes(handle.goal_id.uuid)
        if handle.accepted:
            self.goals[key] = handle
        stamp = Time.from_msg(handle.stamp).nanoseconds
        self.host.call(self.goal_handler, packed(number, int(handle.accepted), key, stamp))

    def _tell_feedback(self, message: Any) -> None:
        self.host.call(self.feedback_handler, packed(bytes(message.goal_id.uuid)) + serialize(message.feedback))

    def get_result(self, key: bytes) -> None:
        """Request a goal's result for the program."""
        self.goals[key].get_result_async().add_done_callback(partial(self._tell_result, key))

    def _tell_result(self, key: bytes, future: Future) -> None:
        response = future.result()
        self.goals.pop(key, None)
        self.host.call(self.result_handler, packed(key, response.status) + serialize(response.result))

    def cancel(self, number: int, key: bytes, stamp_ns: int) -> None:
        """Request to cancel one goal, those before a time, or all; the program receives the response under its number."""
        request = CancelGoal.Request()
        request.goal_info.goal_id.uuid = list(key)
        request.goal_info.stamp = Time(nanoseconds=stamp_ns).to_msg()
        self._cancel_client.call_async(request).add_done_callback(partial(self._tell_cancelled, number))

    def _tell_cancelled(self, number: int, future: Future) -> None:
        self.host.call(self.cancel_handler, packed(number) + serialize(future.result()))


def do_action_client(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make an action client."""
    node, kind, name = host.things[frame.integer()], load(frame.text()), frame.text()
    handlers = (frame.integer(), frame.integer(), frame.integer(), frame.integer())
    client = CompiledActionClient(host, handlers, node, kind, name, callback_group=host.things.get(frame.integer()))
    return packed(host.keep(client), name)


def do_action_ready(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a client's server is available."""
    return packed(int(host.things[frame.integer()].server_is_ready()))


def do_wait_for_action(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for a client's server."""
    client, nanoseconds = host.things[frame.integer()], frame.integer()
    check_node_of_client(client._node)
    return packed(int(client.wait_for_server(None if nanoseconds < 0 else nanoseconds / 1e9)))


def do_send_goal(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Send a goal."""
    host.things[frame.integer()].send(frame.integer(), frame.rest())


def do_get_result(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Request a goal's result."""
    host.things[frame.integer()].get_result(frame.blob())


def do_cancel_goals(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Request to cancel goals."""
    host.things[frame.integer()].cancel(frame.integer(), frame.blob(), frame.integer())


def do_client_goal_status(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the last known status of a goal."""
    client, key = host.things[frame.integer()], frame.blob()
    return packed(client.goals[key].status if key in client.goals else GoalStatus.STATUS_UNKNOWN)
