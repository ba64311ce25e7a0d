"""Runs launch descriptions: visits their entities and handles events until all work is done."""

from __future__ import annotations

import asyncio
import logging
import traceback
from collections.abc import Coroutine, Generator, Iterable
from typing import Any

from . import logging as launch_logging
from .clock_loop import ClockLoop
from .event import Event
from .event_handler import as_entities
from .event_handlers import OnIncludeLaunchDescription, OnShutdown
from .events import IncludeLaunchDescription, Shutdown
from .launch_context import LaunchContext
from .launch_description import LaunchDescription
from .launch_description_entity import LaunchDescriptionEntity
from .utilities.entities import visit_entities

INTERRUPTED = "user interrupted with ctrl-c (SIGINT)"


class _Done(Coroutine[Any, Any, None]):
    """A coroutine that has nothing to do, and need not be awaited."""

    def send(self, value: Any) -> Any:
        raise StopIteration

    def throw(self, *error: Any) -> Any:
        raise StopIteration

    def close(self) -> None:
        pass

    def __await__(self) -> Generator[Any, Any, None]:
        return
        yield


class LaunchService:
    """Launches a system, on the session's clock.

    Include launch descriptions, then `run()`; or await `run_async()` on your own loop.
    """

    def __init__(
        self, *, argv: Iterable[str] | None = None, noninteractive: bool = False, debug: bool = False
    ) -> None:
        launch_logging.launch_config.level = logging.DEBUG if debug else logging.INFO
        self.__debug = debug
        self.__logger = launch_logging.get_logger("launch")
        launch_logging.log_launch_config(logger=self.__logger)
        self.__context = LaunchContext(argv=argv, noninteractive=noninteractive)
        self.__context.register_event_handler(OnIncludeLaunchDescription())
        self.__context.register_event_handler(OnShutdown(on_shutdown=self.__on_shutdown))
        self.__begun: list[asyncio.Future[Any]] = []
        self.__watched: set[asyncio.Future[Any]] = set()
        self.__loop: asyncio.AbstractEventLoop | None = None
        self.__task: asyncio.Task[Any] | None = None
        self.__shutting_down = False
        self.__interrupted = False
        self.__return_code = 0

    @property
    def context(self) -> LaunchContext:
        """The launch's context."""
        return self.__context

    @property
    def event_loop(self) -> asyncio.AbstractEventLoop | None:
        """The loop on which the launch runs; None if it is not running."""
        return self.__loop

    @property
    def task(self) -> asyncio.Task[Any] | None:
        """The running task; None if the launch is not running."""
        return self.__task

    # -- calls from any thread

    def emit_event(self, event: Event) -> None:
        """Queue an event; safe from any thread."""
        if self.__loop is None:
            self.__context.emit_event_sync(event)
        else:
            self.__loop.call_soon_threadsafe(self.__context.emit_event_sync, event)

    def include_launch_description(self, launch_description: LaunchDescription) -> None:
        """Launch a description; safe from any thread."""
        self.emit_event(IncludeLaunchDescription(launch_description))

    def shutdown(self, force_sync: bool = False) -> Coroutine[Any, Any, None]:
        """End the launch; safe from any thread. No effect if it is not running.

        The result may be awaited, or made a task, as in programs for ROS 2, but this is not necessary.
        """
        if self.__loop is not None:
            self.__loop.call_soon_threadsafe(self._shutdown, "LaunchService.shutdown() called", False)
        return _Done()

    # -- running

    def run(self, *, shutdown_when_idle: bool = True) -> int:
        """Launch, and return when all work is done: 0, or 1 after a failure.

        Ctrl-C shuts the launch down, and is passed on to the processes that it has started.
        """
        if self.__loop is not None:
            raise RuntimeError("LaunchService.run() called from multiple threads concurrently.")
        loop = ClockLoop()  # type: ignore[abstract]
        loop.set_debug(self.__debug)
        task = loop.create_task(self.run_async(shutdown_when_idle=shutdown_when_idle))
        try:
            while not task.done():
                self.__run_until_interrupted(loop, task)
        finally:
            self.__end_processes()
            self.__loop = None
            loop.close()
        result: int = task.result()
        return result

    def __run_until_interrupted(self, loop: ClockLoop, task: asyncio.Task[int]) -> None:
        try:
            loop.run_until_complete(task)
        except KeyboardInterrupt:
            self._on_sigint()

    def _on_sigint(self) -> None:
        if self.__interrupted:
            self.__logger.warning(f"{INTERRUPTED} again, ignoring...")
            return
        self.__interrupted = True
        self.__logger.warning(INTERRUPTED)
        self._shutdown("ctrl-c (SIGINT)", True)
        if not self.__context.noninteractive:
            self.__pass_on_ctrl_c()

    def __pass_on_ctrl_c(self) -> None:
        """Interrupt all started processes, as Ctrl-C in a terminal does."""
        for process in list(self.__context._launched_processes):
            if process.exit_code is None:
                process.interrupt()

    async def run_async(self, *, shutdown_when_idle: bool = True) -> int:
        """Launch on the loop that runs this coroutine; see `run`."""
        self.__loop = asyncio.get_running_loop()
        self.__task = asyncio.current_task(self.__loop)
        self.__context._set_asyncio_loop(self.__loop)
        self.__shutting_down = False
        self.__return_code = 0
        try:
            await self.__serve(shutdown_when_idle)
        finally:
            while self.__context._at_end:
                self.__context._at_end.pop()()
            self.__context._set_asyncio_loop(None)
            self.__context._set_is_shutdown(False)
            self.__loop = self.__task = None
        return self.__return_code

    async def __serve(self, shutdown_when_idle: bool) -> None:
        """Handle events until the launch is idle. Then shut down if requested; return when it is idle after a shutdown."""
        while True:
            while not self.__context._event_queue.empty():
                self.__handle_safely(self.__context._event_queue.get_nowait())
            if self._is_idle():
                await asyncio.sleep(0)  # work that has just ended may still emit an event
            if not self._is_idle():
                await self.__something_happens()
            elif self.__shutting_down:
                return
            elif shutdown_when_idle:
                self._shutdown("idle", False)
            else:
                await self.__something_happens()

    async def __something_happens(self) -> None:
        """Wait for an event, or for the end of ongoing work."""
        assert self.__loop is not None
        await self.__context._event_queue.stirred(self.__loop)

    def __watch_begun(self) -> None:
        """Watch work that has begun: its end wakes the launch, its failure ends the launch."""
        completions = self.__context._completion_futures
        for future in (*self.__begun, *completions):
            if future not in self.__watched:
                self.__watched.add(future)
                future.add_done_callback(self.__report_failure)
                future.add_done_callback(self.__watched.discard)
                future.add_done_callback(self.__context._event_queue.stir)
        self.__begun.clear()
        completions.clear()

    def __report_failure(self, future: asyncio.Future[Any]) -> None:
        error = None if future.cancelled() else future.exception()
        if error is not None:
            self.__fail(error)

    def _is_idle(self) -> bool:
        """Return whether there is neither ongoing work nor an event."""
        self.__watch_begun()
        return not self.__watched and self.__context._event_queue.empty()

    def __handle_safely(self, event: Event) -> None:
        try:
            self.__handle(event)
        except Exception as error:
            self.__fail(error)

    def __fail(self, error: BaseException) -> None:
        """Log an error and shut down; the launch returns 1."""
        text = "".join(traceback.format_exception(type(error), error, error.__traceback__))
        self.__logger.debug("Traceback: " + text)
        self.__logger.error(f"Caught exception in launch (see debug for traceback): {error}")
        self.__return_code = 1
        self._shutdown(f"An exception was raised in an async action/event: {error}", False)

    def __handle(self, event: Event) -> None:
        """Run every handler that accepts the event, each with its own locals."""
        for handler in self.__context._handlers_for(event):
            if not handler.matches(event):
                continue
            if self.__logger.isEnabledFor(logging.DEBUG):
                self.__logger.debug(f"processing event: '{event}' ✓ '{handler}'")
            self.__context._push_locals()
            try:
                for entity in as_entities(handler.handle(event, self.__context)):
                    self.__visit(entity)
            finally:
                self.__context._pop_locals()

    def __visit(self, entity: Any) -> None:
        if entity is None:
            return
        if not isinstance(entity, LaunchDescriptionEntity):
            raise RuntimeError(f"expected a LaunchDescriptionEntity from event_handler, got '{entity}'")
        for _, future in visit_entities(entity, self.__context):
            self.__begun.append(future)

    # -- the end

    def __on_shutdown(self, event: Event, context: LaunchContext) -> None:
        self.__shutting_down = True
        self.__context._set_is_shutdown(True)

    def _shutdown(self, reason: str, due_to_sigint: bool) -> None:
        if not self.__shutting_down:
            self.__context.emit_event_sync(Shutdown(reason=reason, due_to_sigint=due_to_sigint))
        self.__shutting_down = True
        self.__context._set_is_shutdown(True)

    def __end_processes(self) -> None:
        """End processes that are still running if the launch itself was killed."""
        for process in self.__context._launched_processes:
            if process.state == "running":
                process.kill()
