"""Calls a service from a launch: waits for it, and gives up when the launch ends."""

from __future__ import annotations

from typing import Any

from launch.launch_context import LaunchContext

from coursekit.processes import session

PATIENCE = 10  # seconds until a warning that no node offers the service


def call_service(client: Any, request: Any, context: LaunchContext, logger: Any) -> Any:
    """Return the service's response; None, after a warning, if the launch shuts down meanwhile.

    It blocks: call it in a separate execution context, not in the launch's loop.
    """
    waited = 0
    while not client.wait_for_service(timeout_sec=1.0):
        if context.is_shutdown:
            logger.warning(f"Abandoning wait for the '{client.srv_name}' service, due to shutdown.")
            return None
        waited += 1
        if waited == PATIENCE:
            logger.warning(f"Nobody offers the '{client.srv_name}' service yet; is its node's name right?")
    answered = session.current().clock.new_event()
    future = client.call_async(request)
    future.add_done_callback(lambda _: answered.set())
    while not answered.wait(1.0):
        if context.is_shutdown:
            logger.warning(f"Abandoning wait for the '{client.srv_name}' service response, due to shutdown.")
            future.cancel()
            return None
    return future.result()
