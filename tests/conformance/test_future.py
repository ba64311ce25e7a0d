import asyncio

import pytest
from rclpy.task import Future


def test_a_new_future_is_open():
    future = Future()
    assert not future.done()
    assert not future.cancelled()
    assert future.result() is None
    assert future.exception() is None


def test_a_result_ends_it():
    future = Future()
    future.set_result("sentinel")
    assert future.done()
    assert future.result() == "sentinel"


def test_an_exception_ends_it_and_is_raised():
    future = Future()
    future.set_exception(ValueError("bad"))
    assert future.done()
    assert isinstance(future.exception(), ValueError)
    with pytest.raises(ValueError, match="bad"):
        future.result()


def test_cancelling_marks_it():
    future = Future()
    future.cancel()
    assert future.cancelled()


def test_cancelling_a_done_future_does_nothing():
    future = Future()
    future.set_result(1)
    future.cancel()
    assert not future.cancelled()


@pytest.mark.parametrize("early", [True, False])
def test_done_callbacks_are_called_once(early):
    future, seen = Future(), []
    if early:
        future.add_done_callback(seen.append)
    future.set_result(None)
    if not early:
        future.add_done_callback(seen.append)
    assert seen == [future]


def test_a_cancelled_future_calls_back():
    future, seen = Future(), []
    future.add_done_callback(seen.append)
    future.cancel()
    assert seen == [future]


def test_a_future_can_be_awaited():
    future = Future()

    async def wait():
        return await future

    coroutine = wait()
    coroutine.send(None)
    future.set_result("there")
    with pytest.raises(StopIteration) as caught:
        coroutine.send(None)
    assert caught.value.value == "there"


def test_callbacks_run_in_the_executor_when_there_is_one(world):
    seen = []
    future = Future(executor=world.executor)
    future.add_done_callback(seen.append)
    future.set_result(1)
    assert seen == []
    world.spin_until(lambda: seen)
    assert seen == [future]


def test_results_may_be_none_and_done():
    future = Future()
    future.set_result(None)
    assert future.done()
    assert future.result() is None


def test_a_future_is_awaited_in_asyncio_too():
    future = Future()

    async def wait():
        return await future

    async def both():
        waiting = asyncio.ensure_future(wait())
        await asyncio.sleep(0)
        future.set_result("done")
        return await waiting

    assert asyncio.run(both()) == "done"
