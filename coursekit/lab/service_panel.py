"""Calling services: with a form made from the type, or from code."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.cli.api import full_name
from coursekit.core.interface import Message
from coursekit.suggestions import did_you_mean
from coursekit.view.graph_facts import nodes_at, take, types_of
from coursekit.words.gettext import gettext

from .errors import NotThere
from .form import filled, schema
from .messages import as_yaml
from .panel import Panel, static
from .panel_node import WAIT_SECONDS, appears

if TYPE_CHECKING:
    from rclpy.task import Future


class ServiceCaller(Panel):
    """See `service_caller`."""

    _esm = static("services.js", "form.js")
    _css = static("services.css", "form.css")

    def __init__(self, service: str = "") -> None:
        super().__init__("service_caller")
        self._chosen = full_name(service) if service else ""
        self._last = ""
        self._clients: dict[str, Any] = {}
        self.hidden.graph.watch(self.changed)

    # -- from code

    def call(self, service: str = "", /, *, timeout_sec: float = WAIT_SECONDS, **fields: Any) -> Any:
        """Call a service (the chosen one by default) and return its response.

        Fields not given keep their defaults; a nested field is given as a dict. LookupError: no node serves it;
        ValueError: a field does not fit; TimeoutError: no answer.
        """
        name = full_name(service) if service else self._chosen
        self._chosen = name
        appears(lambda: name in self.hidden.graph.servers)
        client, request = self._prepared(name, fields)
        response = self.hidden.result(client.call_async(request), timeout_sec)
        self._note(name, request, response)
        return response

    def _prepared(self, name: str, fields: dict[str, Any]) -> tuple[Any, Any]:
        kind = self._type(name)
        request = filled(kind.Request(), fields)
        if name not in self._clients:
            self._clients[name] = self.hidden.node.create_client(kind, name)
        return self._clients[name], request

    def _type(self, name: str) -> Any:
        from rosidl_runtime_py.utilities import get_service

        served = {service: list(servers) for service, servers in list(self.hidden.graph.servers.items())}
        if name not in served:
            names = self._names()
            hint = did_you_mean(name, names, f"Served are: {', '.join(names) or 'none'}.")
            raise NotThere(f"No node serves {name or 'a service without a name'}. {hint}")
        return get_service(served[name][0].type_name)

    def _names(self) -> list[str]:
        facts = take(self.hidden.graph)
        return sorted({end.name for end in facts.servers})

    def _note(self, name: str, request: Message, response: Message) -> None:
        given = ", ".join(f"{key}={getattr(request, key)!r}" for key in _fields(request))
        answer = "\n".join(f"    {line}" for line in _answer(response).splitlines())
        self._last = f"called: {name}({given})\n{answer}"
        self.changed()

    # -- what is shown

    def text(self) -> str:
        """Return the services with their types, and the last call."""
        facts = take(self.hidden.graph)
        names = self._names()
        lines = [f"services: {len(names)}"]
        for name in names:
            types = ", ".join(types_of(name, facts.servers))
            lines.append(f"{name} [{types}] served by {', '.join(nodes_at(name, facts.servers))}")
        return "\n".join([*lines, *([self._last] if self._last else [])])

    def shown(self) -> dict[str, Any]:
        """Return the services and the form of the selected one."""
        names = self._names()
        if self._chosen not in names and names:
            self._chosen = names[0]
        if self._chosen not in names:
            return {"services": names, "chosen": "", "kind": "", "fields": []}
        kind = self._type(self._chosen)
        return {
            "services": names,
            "chosen": self._chosen,
            "kind": kind._TYPE_NAME,
            "fields": schema(kind.Request),
        }

    def on_choose(self, message: dict[str, Any]) -> None:
        """Select another service."""
        self._chosen = str(message.get("name", ""))
        self._push()

    def on_call(self, message: dict[str, Any]) -> None:
        """Handle the call button."""
        name = str(message.get("name", ""))
        try:
            client, request = self._prepared(name, dict(message.get("fields") or {}))
        except Exception as error:  # any input is possible; the panel shows its error
            self.tell(type="answer", ok=False, text=str(error))
            return
        began = self.session.clock.steady()
        self.tell(type="waiting", name=name)
        future = client.call_async(request)
        future.add_done_callback(lambda done: self._answered(name, request, done, began))

    def _answered(self, name: str, request: Message, future: Future, began: int) -> None:
        response = future.result()
        milliseconds = (self.session.clock.steady() - began) * 1e-6
        self._note(name, request, response)
        self.tell(type="answer", ok=True, text=_answer(response), milliseconds=round(milliseconds, 1))

    def leave(self) -> None:
        """Stop watching the graph."""
        self.hidden.graph.unwatch(self.changed)


def _fields(message: Any) -> list[str]:
    return [name for name in message.get_fields_and_field_types() if name != "structure_needs_at_least_one_member"]


def _answer(response: Message) -> str:
    return as_yaml(response) if _fields(response) else gettext("(done; the response has no fields)")


def service_caller(service: str = "") -> ServiceCaller:
    """Show a form to choose and call a service and see its response; `.call(service, **fields)` from code.

    >>> %ros2 run demo_nodes_py add_two_ints_server &
    [add_two_ints_server: running]
    >>> service_caller().call("/add_two_ints", a=2, b=3)
    example_interfaces.srv.AddTwoInts_Response(sum=5)

    In ROS 2: `ros2 service call`, or rqt's service caller.
    """
    return ServiceCaller(service)


__all__ = ["ServiceCaller", "service_caller"]
