"""Components that a compiled program cannot load itself: each runs as its own program."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from rcl_interfaces.msg import Parameter as ParameterMessage
from rclpy.parameter import Parameter

from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.components.loading import LoadedComponent
from coursekit.processes.components import Given
from coursekit.systems import signal_names

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host
    from coursekit.processes.base_process import BaseProcess


class ComponentOfProgram(LoadedComponent):
    """Ends together with the program that requested it."""

    def __init__(self, host: Host, path: Path, given: Given) -> None:
        graph = host.session.graph(host.context_called(0).get_domain_id())
        super().__init__(path, given, graph, host.argv)
        self._host = host
        self._unloaded = False
        host.process.cleanups.append(self.process.kill)
        self.process.on_exit(self._ended)

    def _ended(self, process: BaseProcess) -> None:
        """Handle a component's end; a crash aborts the program, as with a component in a library."""
        if process.exit_code and not self._unloaded and not self._host.over:
            self._host.process.send_signal(signal_names.ABORT)

    def unload(self) -> None:
        """End the component, as Ctrl-C does."""
        self._unloaded = True
        super().unload()


def do_component(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Run a component, whose node gets command-line arguments and parameters."""
    path = Path(frame.text())
    words = [frame.text() for _ in range(frame.integer())]
    parameters = [Parameter.from_parameter_msg(frame.message(ParameterMessage)) for _ in range(frame.integer())]
    component = ComponentOfProgram(host, path, Given(words, parameters))
    return packed(host.keep(component), component.full_name)
