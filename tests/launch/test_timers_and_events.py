from __future__ import annotations

import asyncio

import pytest
from launch import Event, EventHandler, LaunchContext
from launch.actions import (
    EmitEvent,
    LogInfo,
    OpaqueCoroutine,
    OpaqueFunction,
    RegisterEventHandler,
    SetLaunchConfiguration,
    Shutdown,
    TimerAction,
    UnregisterEventHandler,
)
from launch.event_handlers import OnExecutionComplete, OnShutdown
from launch.substitutions import LaunchConfiguration, LocalSubstitution

USER = "[INFO] [launch.user]: "


def test_functions_get_the_context_and_their_arguments_and_give_entities(launch) -> None:
    def function(context, word, *, times):
        assert isinstance(context, LaunchContext)
        return [LogInfo(msg=word)] * times

    result = launch([OpaqueFunction(function=function, args=["twice"], kwargs={"times": 2})])
    assert result.lines == [USER + "twice"] * 2


def test_a_coroutine_is_cancelled_when_the_launch_ends(launch, session) -> None:
    ended = []

    async def coroutine(context, name):
        try:
            await asyncio.sleep(60.0)
        except asyncio.CancelledError:
            ended.append((name, session.clock.steady()))
            raise

    result = launch(
        [OpaqueCoroutine(coroutine=coroutine, args=["x"]), TimerAction(period=2.0, actions=[Shutdown()])]
    )
    assert (result.code, ended) == (0, [("x", 2_000_000_000)])


def test_a_coroutine_that_goes_on_keeps_the_launch_alive(launch, session) -> None:
    times = []

    async def coroutine():
        start = session.clock.steady()
        await asyncio.sleep(60.0)
        done, _ = await asyncio.wait([asyncio.ensure_future(asyncio.sleep(1.0, "slept"))])
        times.append((session.clock.steady() - start, done.pop().result()))

    assert launch([OpaqueCoroutine(coroutine=coroutine, ignore_context=True)]).code == 0
    assert times == [(61_000_000_000, "slept")]
    with pytest.raises(TypeError):
        OpaqueCoroutine(coroutine=lambda context: None)


def test_work_in_an_executor_is_awaited(launch) -> None:
    async def coroutine(context):
        context.launch_configurations["answer"] = str(await asyncio.to_thread(lambda: 6 * 7))

    result = launch([OpaqueCoroutine(coroutine=coroutine)])
    assert result.service.context.launch_configurations == {"answer": "42"}


def test_an_error_in_a_coroutine_ends_the_launch_with_1(launch) -> None:
    async def coroutine(context):
        raise ValueError("went wrong")

    result = launch([OpaqueCoroutine(coroutine=coroutine)])
    assert result.code == 1
    assert (
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): went wrong" in result.lines
    )


def test_timers_fire_in_order_of_their_time(launch, session) -> None:
    start = session.clock.steady()
    result = launch(
        [
            TimerAction(period=20.0, actions=[LogInfo(msg="late")]),
            SetLaunchConfiguration("soon", "1.5"),
            TimerAction(period=[LaunchConfiguration("soon")], actions=[LogInfo(msg="soon")]),
        ]
    )
    assert result.lines == [USER + "soon", USER + "late"]
    assert session.clock.steady() - start == 20_000_000_000


def test_a_cancelled_timer_does_nothing_and_is_not_waited_for(launch, session) -> None:
    timer = TimerAction(period=100.0, actions=[LogInfo(msg="never")])
    early = TimerAction(period=1.0, actions=[LogInfo(msg="never either")])
    early.cancel()
    result = launch(
        [
            timer,
            early,
            TimerAction(period=2.0, actions=[OpaqueFunction(function=lambda context: timer.cancel())]),
        ]
    )
    assert result.lines == []
    assert session.clock.steady() < 3e9


def test_timers_end_with_the_launch_unless_they_are_to_stay(launch) -> None:
    result = launch(
        [
            TimerAction(period=5.0, actions=[LogInfo(msg="gone")]),
            TimerAction(period=5.0, actions=[LogInfo(msg="stays")], cancel_on_shutdown=False),
            TimerAction(period=1.0, actions=[Shutdown(reason="enough")]),
            RegisterEventHandler(
                OnShutdown(on_shutdown=[LogInfo(msg=["why: ", LocalSubstitution("event.reason")])])
            ),
        ]
    )
    assert result.lines == [USER + "why: enough", USER + "stays"]


def test_handlers_react_to_events_until_they_are_unregistered(launch) -> None:
    class Ring(Event):
        name = "ring"

    handler = EventHandler(matcher=lambda event: isinstance(event, Ring), entities=[LogInfo(msg="ding")])
    result = launch(
        [
            RegisterEventHandler(handler),
            EmitEvent(event=Ring()),
            EmitEvent(event=Ring()),
            TimerAction(period=1.0, actions=[UnregisterEventHandler(handler), EmitEvent(event=Ring())]),
        ]
    )
    assert result.lines == [USER + "ding"] * 2


def test_a_handler_that_handles_once_reacts_only_once(launch) -> None:
    handler = EventHandler(
        matcher=lambda event: event.name == "ring",
        handle_once=True,
        entities=lambda event, context: LogInfo(msg=f"got {event.name}"),
    )
    ring = Event()
    ring.name = "ring"
    result = launch([RegisterEventHandler(handler), EmitEvent(event=ring), EmitEvent(event=ring)])
    assert result.lines == [USER + "got ring"]


def test_the_completion_of_an_action_is_an_event(launch) -> None:
    timer = TimerAction(period=3.0, actions=[])
    result = launch(
        [
            RegisterEventHandler(
                OnExecutionComplete(target_action=timer, on_completion=[LogInfo(msg="done")])
            ),
            timer,
        ]
    )
    assert result.lines == [USER + "done"]
