"""Starts a program and manages it until it ends."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Callable
from typing import Any, cast

from ..action import Action
from ..conditions import evaluate_condition_expression
from ..descriptions import Executable
from ..event import Event
from ..event_handler import EventHandler
from ..event_handlers import OnProcessExit, OnProcessIO, OnProcessStart, OnShutdown
from ..events import Shutdown, matches_action
from ..events.process import (
    ProcessIO,
    ShutdownProcess,
    SignalProcess,
)
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..logging import get_logger
from ..process_output import ProcessOutput
from ..process_run import ProcessRun, command_line
from ..some_entities_type import SomeEntitiesType
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..substitutions import LaunchConfiguration
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from ..utilities.type_utils import normalize_typed_substitution, perform_typed_substitution
from .emit_event import EmitEvent
from .escalation import Escalation

OnExit = SomeEntitiesType | Callable[..., SomeEntitiesType | None] | None


class ExecuteLocal(Action):
    """Starts the program of `process_description`, logs its output, and ends it when the launch ends.

    It emits ProcessStarted, ProcessStdout, ProcessStderr and ProcessExited, and reacts to ShutdownProcess,
    SignalProcess and Shutdown. `output` is 'log', 'screen', 'both', 'own_log' or 'full'. To end the program, it sends
    SIGINT, then SIGTERM after `sigterm_timeout` seconds, and SIGKILL after `sigkill_timeout` more seconds.
    """

    def __init__(
        self,
        *,
        process_description: Executable,
        shell: bool = False,
        sigterm_timeout: SomeSubstitutionsType = LaunchConfiguration("sigterm_timeout", default=5),
        sigkill_timeout: SomeSubstitutionsType = LaunchConfiguration("sigkill_timeout", default=5),
        emulate_tty: bool = False,
        output: Any = "log",
        output_format: str = "[{this.process_description.final_name}] {line}",
        cached_output: bool = False,
        log_cmd: bool = False,
        on_exit: OnExit = None,
        respawn: bool | SomeSubstitutionsType = False,
        respawn_delay: float | None = None,
        respawn_max_retries: int = -1,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__description = process_description
        self.__shell = shell
        self.__sigterm_timeout = normalize_to_list_of_substitutions(sigterm_timeout)
        self.__sigkill_timeout = normalize_to_list_of_substitutions(sigkill_timeout)
        self.__emulate_tty = emulate_tty
        output = os.environ.get("OVERRIDE_LAUNCH_PROCESS_OUTPUT", output)
        self.__output = output if isinstance(output, dict) else normalize_to_list_of_substitutions(output)
        self.__output_format = output_format
        self.__cached_output = cached_output
        self.__log_cmd = log_cmd
        self.__on_exit = on_exit
        self.__respawn = normalize_typed_substitution(respawn, bool)
        self.__respawn_delay = respawn_delay
        self.__retries_left = respawn_max_retries
        self.__details: dict[str, Any] | None = None
        self.__process: Any = None
        self.__executed = False
        self.__completed: asyncio.Future[None] | None = None
        self.__shutdown: asyncio.Future[None] | None = None
        self.__escalation: Escalation | None = None
        self.__lines: ProcessOutput | None = None

    @property
    def process_description(self) -> Executable:
        """The executable that is started."""
        return self.__description

    @property
    def shell(self) -> bool:
        """Whether a shell runs the command."""
        return self.__shell

    @property
    def emulate_tty(self) -> bool:
        """Whether the process writes to a terminal; the launch configuration of that name takes precedence."""
        return self.__emulate_tty

    @property
    def sigterm_timeout(self) -> list[Substitution]:
        """The seconds between SIGINT and SIGTERM, as substitutions."""
        return self.__sigterm_timeout

    @property
    def sigkill_timeout(self) -> list[Substitution]:
        """The seconds between SIGTERM and SIGKILL, as substitutions."""
        return self.__sigkill_timeout

    @property
    def output(self) -> Any:
        """The destination of the output, as substitutions or a mapping."""
        return self.__output

    @property
    def process_details(self) -> dict[str, Any] | None:
        """Action, name, cmd, cwd, env and pid; None before it is prepared."""
        return self.__details

    @property
    def return_code(self) -> int | None:
        """The exit code; None before the end."""
        return None if self.__process is None else self.__process.exit_code

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that are visited on exit, if they are known beforehand."""
        return self.__on_exit if isinstance(self.__on_exit, list) else []

    def get_stdout(self) -> str:
        """Return all of stdout; needs `cached_output=True`."""
        return self.__cached("stdout")

    def get_stderr(self) -> str:
        """Return all of stderr; needs `cached_output=True`."""
        return self.__cached("stderr")

    def __cached(self, stream: str) -> str:
        if not self.__cached_output:
            raise RuntimeError(
                f"cached output must be true to be able to get {stream}, "
                f"proc '{self.__description.final_name}'"
            )
        return "" if self.__lines is None else self.__lines.cached(stream)

    def prepare(self, context: LaunchContext) -> None:
        """Perform the substitutions of the description."""
        self.__description.prepare(context, self)
        self.__respawn = perform_typed_substitution(context, self.__respawn, bool)  # now: later the scope has ended
        self.__details = {
            "action": self,
            "name": self.__description.final_name,
            "cmd": self.__description.final_cmd,
            "cwd": self.__description.final_cwd,
            "env": self.__description.final_env,
        }

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Register the handlers, and start the process in the next iteration of the loop.

        Raises:
            RuntimeError: if the same action is executed twice.
        """
        self.prepare(context)
        name = cast(str, self.__description.final_name)
        if self.__executed:
            raise RuntimeError(f"ExecuteLocal action '{name}': executed more than once: {self.describe()}")
        self.__executed = True
        if context.is_shutdown:
            return None
        assert context.asyncio_loop is not None
        output = (
            self.__output
            if isinstance(self.__output, dict)
            else perform_substitutions(context, self.__output)
        )
        self.__lines = ProcessOutput(self, name, output, self.__output_format, self.__cached_output)
        self.__logger = get_logger(name)
        self.__completed = context.asyncio_loop.create_future()
        self.__shutdown = context.asyncio_loop.create_future()
        for handler in self.__handlers():
            context.register_event_handler(handler)
        context.asyncio_loop.create_task(self.__run(context))
        return None

    def __handlers(self) -> list[Any]:
        return [
            self.__on_request(ShutdownProcess, self.__on_shutdown_process),
            self.__on_request(SignalProcess, self.__on_signal),
            OnProcessIO(target_action=self, on_stdout=self.__on_io, on_stderr=self.__on_io),
            OnShutdown(on_shutdown=self.__on_shutdown),
            OnProcessExit(target_action=self, on_exit=self.__on_exit),
            OnProcessExit(target_action=self, on_exit=lambda event, context: cast(Any, self.__lines).flush()),
        ]

    def __on_request(self, kind: type[Event], reaction: Callable[..., Any]) -> EventHandler:
        """The handler of events of a class that match this process."""
        return EventHandler(
            matcher=lambda event: isinstance(event, kind) and cast(Any, event).process_matcher(self),
            entities=reaction,
            _event_class=kind,
        )

    async def __run(self, context: LaunchContext) -> None:
        """Run the process, repeatedly if it must be respawned."""
        try:
            while await self.__run_once(context) and await self.__to_respawn(context):
                pass
        except Exception as error:
            assert self.__completed is not None
            self.__completed.set_exception(error)  # the launch reports it
        finally:
            if self.__escalation is not None:
                self.__escalation.cancel()
            if self.__completed is not None and not self.__completed.done():
                self.__completed.set_result(None)

    async def __run_once(self, context: LaunchContext) -> bool:
        """Run the process to its end; return whether it was started."""
        assert self.__details is not None and self.__shutdown is not None and self.__lines is not None
        if self.__shutdown.done():
            return False
        self.__log_details()
        tty = self.__wants_tty(context)
        run = ProcessRun(context, self.__details, self.__lines, self.__logger, shell=self.__shell, tty=tty)
        if not run.start():
            return False
        self.__process = run.process
        await run.to_end()
        return True

    def __wants_tty(self, context: LaunchContext) -> bool:
        setting = context.launch_configurations.get("emulate_tty")
        if setting is None:
            return self.__emulate_tty
        return evaluate_condition_expression(context, normalize_to_list_of_substitutions(setting))

    def __log_details(self) -> None:
        if self.__log_cmd:
            custom = self.__description.env is not None or self.__description.additional_env is not None
            self.__logger.info(
                f"process details: cmd='{command_line(self.__description.final_cmd or [])}', "
                f"cwd='{self.__description.final_cwd}', custom_env?={custom}"
            )

    async def __to_respawn(self, context: LaunchContext) -> bool:
        """Wait for the respawn delay; return whether to start the process again."""
        assert self.__shutdown is not None
        if not self.__respawn or context.is_shutdown or self.__shutdown.done() or self.__retries_left == 0:
            return False
        self.__retries_left -= 1
        if self.__respawn_delay:
            await asyncio.wait((self.__shutdown,), timeout=self.__respawn_delay)
        return not self.__shutdown.done()

    def __on_io(self, event: ProcessIO) -> None:
        if self.__lines is not None:
            self.__lines.write(
                "stdout" if event.from_stdout else "stderr", event.text.decode(errors="replace")
            )

    def __on_shutdown_process(self, event: Event, context: LaunchContext) -> list[Action] | None:
        return self._shutdown_process(context, send_sigint=True)

    def __on_shutdown(self, event: Event, context: LaunchContext) -> list[Action] | None:
        ctrl_c = cast(Shutdown, event).due_to_sigint and not context.noninteractive  # it reached the process too
        return self._shutdown_process(context, send_sigint=not ctrl_c)

    def __is_running(self) -> bool:
        return self.__process is not None and self.__process.exit_code is None

    def _shutdown_process(self, context: LaunchContext, *, send_sigint: bool) -> list[Action] | None:
        """Begin to end the process; return the escalation timers and the first signal."""
        if self.__shutdown is None or self.__shutdown.done():
            return None
        if self.__process is None and self.__completed is not None and not self.__completed.done():
            self.__shut_down_once_started(context)
            return None
        self.__shutdown.set_result(None)
        if not self.__is_running():
            return None
        self.__escalation = Escalation(self, self.__sigterm_timeout, self.__sigkill_timeout)
        actions: list[Action] = [*self.__escalation.timers()]
        if send_sigint:
            actions.append(
                EmitEvent(event=SignalProcess(signal_number="SIGINT", process_matcher=matches_action(self)))
            )
        return actions

    def __shut_down_once_started(self, context: LaunchContext) -> None:
        """End the process, which is about to start, as soon as it has started."""
        context.register_event_handler(
            OnProcessStart(
                target_action=self,
                on_start=lambda event, context: self._shutdown_process(context, send_sigint=True),
                handle_once=True,
            )
        )

    def __on_signal(self, event: Event, context: LaunchContext) -> None:
        signal_event = cast(SignalProcess, event)
        if self.__process is None:
            raise RuntimeError("Signal event received before subprocess transport available.")
        name = cast(str, self.__description.final_name)
        if not self.__is_running():
            self.__logger.debug(
                f"signal '{signal_event.signal_name}' not sent to '{name}' because it has closed already"
            )
            return
        self.__logger.info(f"sending signal '{signal_event.signal_name}' to process[{name}]")
        self.__process.send_signal(int(signal_event.signal))

    def get_asyncio_future(self) -> asyncio.Future[None] | None:
        """Return a future that is done when the process has ended for good."""
        return self.__completed
