from __future__ import annotations

import asyncio

import pytest
from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess, LogInfo, OpaqueCoroutine, OpaqueFunction, TimerAction
from launch.clock_loop import ClockLoop
from launch.events import Shutdown


def test_a_service_may_run_several_times_and_in_the_code_that_made_it(
    session, capsys: pytest.CaptureFixture[str]
) -> None:
    service = LaunchService(argv=["a:=1"], noninteractive=True)
    assert service.context.argv == ["a:=1"]
    for word in ("first", "second"):
        service.include_launch_description(LaunchDescription([LogInfo(msg=word)]))
        assert service.run() == 0
    assert capsys.readouterr().out.splitlines()[1:] == [
        "[INFO] [launch]: Default logging verbosity is set to INFO",
        "[INFO] [launch.user]: first",
        "[INFO] [launch.user]: second",
    ]


def test_a_service_runs_inside_of_another_running_loop(session) -> None:
    times = []

    async def coroutine(context) -> None:
        await asyncio.sleep(30.0)
        times.append(asyncio.get_running_loop() is context.asyncio_loop)

    async def cell() -> int:
        service = LaunchService(noninteractive=True)
        service.include_launch_description(LaunchDescription([OpaqueCoroutine(coroutine=coroutine)]))
        code = service.run()
        assert asyncio.get_running_loop() is not service.event_loop
        await asyncio.sleep(0)
        return code

    assert asyncio.run(cell()) == 0
    assert times == [True]


def test_a_service_can_be_awaited_on_another_loop(session, capsys: pytest.CaptureFixture[str]) -> None:
    service = LaunchService(noninteractive=True)
    service.include_launch_description(
        LaunchDescription([ExecuteProcess(cmd=["echo", "a"], output="screen")])
    )
    loop = ClockLoop()
    assert loop.run_until_complete(service.run_async()) == 0
    assert "[echo-1] a" in capsys.readouterr().out


def test_without_shutdown_when_idle_it_runs_until_it_is_told(session) -> None:
    service = LaunchService(noninteractive=True)
    service.include_launch_description(
        LaunchDescription(
            [
                TimerAction(
                    period=5.0,
                    actions=[
                        OpaqueFunction(
                            function=lambda context: context.emit_event_sync(Shutdown(reason="test"))
                        )
                    ],
                )
            ]
        )
    )

    def later() -> None:
        session.clock.sleep(50.0)
        service.shutdown()

    session.spawn(later)
    assert session.start(lambda: service.run(shutdown_when_idle=False), name="launch").wait() == 0
    assert session.clock.steady() == 5_000_000_000


def test_events_from_another_lane_arrive(launch, session) -> None:
    def meanwhile(service: LaunchService) -> None:
        session.clock.sleep(2.0)
        service.include_launch_description(LaunchDescription([LogInfo(msg="thrown in")]))

    result = launch([TimerAction(period=10.0, actions=[])], meanwhile=meanwhile)
    assert result.lines == ["[INFO] [launch.user]: thrown in"]


def test_debug_shows_events_and_tracebacks(launch) -> None:
    def fail(context) -> None:
        raise ValueError("why")

    result = launch([OpaqueFunction(function=fail)], debug=True)
    assert "ValueError: why" in result.text
    assert "Traceback" in result.text
    assert "processing event: '<launch.events.shutdown.Shutdown" in result.text


def test_the_loop_keeps_asyncio_promises(session) -> None:
    loop = ClockLoop()
    order: list[str] = []

    async def work() -> str:
        loop.call_later(2.0, order.append, "two")
        cancelled = loop.call_later(1.5, order.append, "never")
        loop.call_later(1.0, order.append, "one")
        cancelled.cancel()
        loop.call_soon(order.append, "soon")
        with pytest.raises(asyncio.TimeoutError):
            await asyncio.wait_for(loop.create_future(), timeout=3.0)
        results = await asyncio.gather(asyncio.sleep(1.0, "a"), loop.run_in_executor(None, lambda: "b"))
        with pytest.raises(ZeroDivisionError):
            await loop.run_in_executor(None, lambda: 1 / 0)
        return "".join(results)

    assert loop.run_until_complete(work()) == "ab"
    assert order == ["soon", "one", "two"]
    assert session.clock.steady() == 4_000_000_000
    loop.call_later(1.0, loop.stop)
    loop.run_forever()
    loop.close()
    with pytest.raises(RuntimeError, match="Event loop is closed"):
        loop.run_forever()
