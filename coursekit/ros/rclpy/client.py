"""Service clients."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from coursekit.processes.session import current
from rclpy._lent import lender
from rclpy._rclpy_pybind11 import Client as _Handle
from rclpy.task import Future

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.context import Context
    from rclpy.qos import QoSProfile

__getattr__ = lender(__name__)  # names that programs import from here


class Client:
    """A service client, created by `Node.create_client`."""

    def __init__(
        self,
        context: Context,
        client_impl: _Handle,
        srv_type: type[Any],
        srv_name: str,
        qos_profile: QoSProfile | int,
        callback_group: CallbackGroup,
    ) -> None:
        self.context = context
        self.__client = client_impl
        self.srv_type = srv_type
        self.srv_name = srv_name
        self.qos_profile = qos_profile
        self.callback_group = callback_group
        self._pending_requests: dict[int, Future] = {}
        self._lock = threading.RLock()

    def call(self, request: Any, timeout_sec: float | None = None) -> Any:
        """Send a request and wait for the response; never in a callback of the executor that must take it."""
        self._check_request(request)
        answered = current().clock.new_event()
        future = self.call_async(request)
        future.add_done_callback(lambda _: answered.set())
        if not answered.wait(timeout_sec):
            self.remove_pending_request(future)
            raise TimeoutError()
        if future.exception() is not None:
            raise future.exception()  # type: ignore[misc]
        return future.result()

    def call_async(self, request: Any) -> Future:
        """Send a request; the future gets the response.

        >>> from std_srvs.srv import Trigger
        >>> service = node.create_service(Trigger, "stop", lambda request, response: Trigger.Response(success=True))
        >>> future = node.create_client(Trigger, "stop").call_async(Trigger.Request())
        >>> rclpy.spin_until_future_complete(node, future)
        >>> future.result().success
        True
        """
        self._check_request(request)
        with self._lock, self.__client:
            number = self.__client.core.peek_number()
            future = Future()
            self._pending_requests[number] = future
            future.add_done_callback(self.remove_pending_request)
            self.__client.send_request(request)
        return future

    def _check_request(self, request: Any) -> None:
        if not isinstance(request, self.srv_type.Request):
            raise TypeError()

    def get_pending_request(self, sequence_number: int) -> Future:
        """The future of a pending request; KeyError if there is none."""
        with self._lock:
            return self._pending_requests[sequence_number]

    def remove_pending_request(self, future: Future) -> None:
        """Forget a request; its response will be ignored."""
        with self._lock:
            for number, pending in list(self._pending_requests.items()):
                if pending is future:
                    del self._pending_requests[number]

    def service_is_ready(self) -> bool:
        """Whether the service has a server."""
        with self.__client:
            current().clock.poll()
            return self.__client.service_server_is_available()

    def wait_for_service(self, timeout_sec: float | None = None) -> bool:
        """Wait for a server, for at most `timeout_sec`; return whether there is one.

        >>> from std_srvs.srv import Trigger
        >>> client = node.create_client(Trigger, "stop")
        >>> client.wait_for_service(timeout_sec=1.0)
        False
        """
        clock = current().clock
        deadline = None if timeout_sec is None or timeout_sec < 0 else clock.steady() + int(timeout_sec * 1e9)
        changed = clock.new_event()
        graph = self.__client.core.graph
        graph.watch(changed.set)
        self.context.on_shutdown(changed.set)
        try:
            while self.context.ok() and not self.service_is_ready():
                left = None if deadline is None else (deadline - clock.steady()) * 1e-9
                if left is not None and left <= 0:
                    break
                changed.wait(left)
                changed.clear()
        finally:
            graph.unwatch(changed.set)
            self.context.remove_on_shutdown(changed.set)
        return self.service_is_ready()

    @property
    def handle(self) -> _Handle:
        """The client's handle."""
        return self.__client

    @property
    def service_name(self) -> str:
        """The resolved name."""
        with self.__client:
            return self.__client.name

    @property
    def logger_name(self) -> str:
        """The name of its node's logger."""
        with self.__client:
            return str(self.__client.core.node.logger_name)

    def destroy(self) -> None:
        """Use `Node.destroy_client` instead."""
        self.__client.destroy_when_not_in_use()

    def _sources(self) -> list[Any]:
        return [self.__client.core]

    def _take(self) -> Any:
        taken = self.__client.core.take() if self.__client.valid else None
        if taken is None:
            return None
        return lambda: self._answered(*taken)

    def _answered(self, number: int, response: Any) -> None:
        with self._lock:
            future = self._pending_requests.pop(number, None)
        if future is not None and not future.cancelled():
            future.set_result(response)

    def __enter__(self) -> Client:
        return self

    def __exit__(self, *_error: object) -> None:
        self.destroy()
