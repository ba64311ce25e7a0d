"""A compiled program's requests about nodes, timers and services."""

from __future__ import annotations

import itertools
from functools import partial
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Parameter as ParameterMessage
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.clock import Clock, ClockType, JumpHandle, JumpThreshold, TimeJump
from rclpy.duration import Duration
from rclpy.parameter import Parameter
from tf2_ros import TransformListener
from tf2_ros.buffer_server import BufferServer

from coursekit.interfaces.cdr import deserialize, serialize
from coursekit.interfaces.registry import load
from coursekit.nodes.compiled import qos
from coursekit.nodes.compiled.executors import Work
from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.lifecycle import CompiledLifecycleNode
from coursekit.nodes.compiled.node import CompiledNode
from coursekit.nodes.compiled.shared_objects import facts
from coursekit.nodes.compiled.valid_objects import check_context_of_timer, check_node_of_client, living_node
from coursekit.nodes.components.loading import LoadedComponent

if TYPE_CHECKING:
    from rclpy.task import Future

    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

_FOREVER = 2**63 - 1
_requests = itertools.count(1)
_SYSTEM_TIME, _STEADY_TIME = 2, 3


def do_drop(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Handle the destruction of an object in the program."""
    thing = host.things.pop(frame.integer(), None)
    if isinstance(thing, CompiledNode):
        thing.destroy_node()
    elif isinstance(thing, tuple):  # (node, name of its destroy method, entity)
        node, how, entity = thing
        getattr(node, how)(entity)
        if statistics := getattr(getattr(entity, "hearing", None), "statistics", None):
            statistics.destroy()
    elif isinstance(thing, (ActionClient, ActionServer)):
        thing.destroy()
    elif isinstance(thing, JumpHandle):
        thing.unregister()
    elif isinstance(thing, Work):
        thing.drop()
    elif isinstance(thing, BufferServer):
        thing.destroy()
    elif isinstance(thing, LoadedComponent):
        thing.unload()
    elif isinstance(thing, TransformListener):
        thing.executor.shutdown(0)


def do_node(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a node."""
    name, namespace, managed = frame.text(), frame.text(), frame.integer()
    use_global, allow, automatic, rosout, services = (bool(frame.integer()) for _ in range(5))
    context = host.context_called(frame.integer())
    arguments = [frame.text() for _ in range(frame.integer())]
    overrides = [Parameter.from_parameter_msg(frame.message(ParameterMessage)) for _ in range(frame.integer())]
    node = (CompiledLifecycleNode if managed else CompiledNode)(
        name,
        context=context,
        namespace=namespace,
        cli_args=arguments,
        use_global_arguments=use_global,
        enable_rosout=rosout,
        start_parameter_services=services,
        parameter_overrides=overrides,
        allow_undeclared_parameters=allow,
        automatically_declare_parameters_from_overrides=automatic,
    )
    return facts(host, host.keep(node))


def do_callback_group(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a callback group, which is served with its node, or separately."""
    node, reentrant, automatic = host.things[frame.integer()], frame.integer(), frame.integer()
    group = ReentrantCallbackGroup() if reentrant else MutuallyExclusiveCallbackGroup()
    if not automatic:
        node.set_apart(group)
    return packed(host.keep(group))


def do_ros_now(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the time of a node that follows /clock."""
    return packed(host.things[frame.integer()].get_clock().now().nanoseconds)


def do_ros_sleep(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Sleep on the clock of a node that follows /clock; returns 0 if its context ended, or it no longer follows."""
    node, span = host.things[frame.integer()], Duration(nanoseconds=frame.integer())
    return packed(int(node.get_clock().sleep_for(span, context=node.context)))


def do_ros_time_active(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a node follows /clock."""
    return packed(int(host.things[frame.integer()].get_clock().ros_time_is_active))


def do_jump_callback(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Call the program before and after jumps of a node's clock."""
    clock, on_change, forward, backward, before, after = host.things[frame.integer()].get_clock(), *_integers(frame, 5)
    threshold = JumpThreshold(
        min_forward=Duration(nanoseconds=forward) if forward else None,
        min_backward=Duration(nanoseconds=backward) if backward else None,
        on_clock_change=bool(on_change),
    )

    def warn() -> None:
        host.call(before)

    def tell(jump: TimeJump) -> None:
        host.call(after, packed(int(jump.clock_change), jump.delta.nanoseconds))

    return packed(host.keep(clock.create_jump_callback(threshold, pre_callback=warn, post_callback=tell)))


def _integers(frame: Unpacker, count: int) -> list[int]:
    return [frame.integer() for _ in range(count)]


# -- timers


def do_timer(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a timer."""
    node, period, kind, handler = host.things[frame.integer()], frame.integer(), frame.integer(), frame.integer()
    check_context_of_timer(node)
    group = host.things.get(frame.integer())
    clocks = {_STEADY_TIME: ClockType.STEADY_TIME, _SYSTEM_TIME: ClockType.SYSTEM_TIME}
    clock = Clock(clock_type=clocks[kind]) if kind in clocks else None

    def ring() -> None:
        host.call(handler)

    return packed(host.keep((node, "destroy_timer", node.create_timer(period / 1e9, ring, group, clock))))


def do_timer_cancel(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Stop a timer."""
    host.things[frame.integer()][2].cancel()


def do_timer_reset(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Restart a timer."""
    host.things[frame.integer()][2].reset()


def do_timer_canceled(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a timer is canceled."""
    return packed(int(host.things[frame.integer()][2].is_canceled()))


def do_timer_ready(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a timer is due."""
    return packed(int(host.things[frame.integer()][2].is_ready()))


def do_timer_left(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Nanoseconds until a timer is due."""
    left = host.things[frame.integer()][2].time_until_next_call()
    return packed(_FOREVER if left is None else left)


def do_timer_call(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Count a call of a timer, whose callback the program runs itself; 0 for a canceled one."""
    core = host.things[frame.integer()][2]._sources()[0]
    if not core.canceled:
        core.call()
    return packed(int(not core.canceled))


# -- services


def do_service(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a service; its callback responds directly, or later by `send_response`."""
    node, kind, name = living_node(host, frame, "service"), load(frame.text()), frame.text()
    handler, group = frame.integer(), host.things.get(frame.integer())
    service = node.create_service(kind, name, _unused, qos_profile=qos.profile(frame), callback_group=group)
    service.unanswered = {}
    service._answer = partial(_answer, host, handler, service)
    return packed(host.keep((node, "destroy_service", service)), service.service_name)


def _unused(_request: object, response: Any) -> Any:
    return response


def _answer(host: Host, handler: int, service: Any, request: object, header: object) -> None:
    number = next(_requests)
    service.unanswered[number] = header
    result = host.call(handler, packed(number) + serialize(request))
    if result.integer():
        service.send_response(result.message(service.srv_type.Response), service.unanswered.pop(number))


def do_send_response(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Respond to a deferred request."""
    service, number = host.things[frame.integer()][2], frame.integer()
    header = service.unanswered.pop(number, None)
    if header is not None:
        service.send_response(frame.message(service.srv_type.Response), header)


def do_take_request(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Take the next queued request without the callback, 0 if there is none. The response is sent by `send_response`."""
    service = host.things[frame.integer()][2]
    taken = service.handle.core.take()
    if taken is None:
        return packed(0)
    request, header = taken
    number = next(_requests)
    service.unanswered[number] = header
    return packed(1, number) + serialize(request)


def do_client(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a client."""
    node, kind, name = living_node(host, frame, "client"), load(frame.text()), frame.text()
    handler, group = frame.integer(), host.things.get(frame.integer())
    client = node.create_client(kind, name, qos_profile=qos.profile(frame), callback_group=group)
    client.handler = handler
    client.numbers = {}
    return packed(host.keep((node, "destroy_client", client)), client.service_name)


def do_send_request(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Send a request; the response goes to the client's handler."""
    client, number = host.things[frame.integer()][2], frame.integer()
    own = client.handle.core.peek_number()
    client.numbers[own] = number
    future = client.call_async(deserialize(frame.rest(), client.srv_type.Request))

    def answered(done: Future) -> None:
        client.numbers.pop(own, None)
        host.call(client.handler, packed(number) + serialize(done.result()))

    future.add_done_callback(answered)


def do_take_response(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Take the next queued response without the request's callback, 0 if there is none."""
    client = host.things[frame.integer()][2]
    taken = client.handle.core.take()
    if taken is None:
        return packed(0)
    number, response = taken
    client._pending_requests.pop(number, None)
    return packed(1, client.numbers.pop(number, 0)) + serialize(response)


def do_service_ready(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether a client's service is available."""
    return packed(int(host.things[frame.integer()][2].service_is_ready()))


def do_wait_for_service(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for a client's service."""
    (node, _how, client), nanoseconds = host.things[frame.integer()], frame.integer()
    check_node_of_client(node)
    return packed(int(client.wait_for_service(None if nanoseconds < 0 else nanoseconds / 1e9)))
