"""Service servers."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy._lent import lender
from rclpy._rclpy_pybind11 import Service as _Handle

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.qos import QoSProfile

__getattr__ = lender(__name__)  # names that programs import from here


class Service:
    """A service server, created by `Node.create_service`."""

    def __init__(
        self,
        service_impl: _Handle,
        srv_type: type[Any],
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile | int,
    ) -> None:
        self.__service = service_impl
        self.srv_type = srv_type
        self.srv_name = srv_name
        self.callback = callback
        self.callback_group = callback_group
        self.qos_profile = qos_profile

    def send_response(self, response: Any, header: Any) -> None:
        """Answer the request that `header` belongs to."""
        if not isinstance(response, self.srv_type.Response):
            raise TypeError()
        with self.__service:
            self.__service.service_send_response(response, header)

    @property
    def handle(self) -> _Handle:
        """The service's handle."""
        return self.__service

    @property
    def service_name(self) -> str:
        """The resolved name."""
        with self.__service:
            return self.__service.name

    @property
    def logger_name(self) -> str:
        """The name of its node's logger."""
        with self.__service:
            return str(self.__service.core.node.logger_name)

    def destroy(self) -> None:
        """Use `Node.destroy_service` instead."""
        self.__service.destroy_when_not_in_use()

    def _sources(self) -> list[Any]:
        return [self.__service.core]

    def _take(self) -> Any:
        taken = self.__service.core.take() if self.__service.valid else None
        if taken is None:
            return None
        return lambda: self._answer(*taken)

    def _answer(self, request: Any, header: Any) -> Any:
        response = self.callback(request, self.srv_type.Response())
        if inspect.iscoroutine(response):
            return self._answer_later(response, header)
        self.send_response(response, header)
        return None

    async def _answer_later(self, response: Any, header: Any) -> None:
        self.send_response(await response, header)

    def __enter__(self) -> Service:
        return self

    def __exit__(self, *_error: object) -> None:
        self.destroy()
