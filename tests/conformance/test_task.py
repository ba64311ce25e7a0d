import pytest
from rclpy.task import Future, Task


def test_a_function_runs_once():
    task = Task(lambda: "result")
    task()
    assert task.done()
    assert task.result() == "result"


def test_arguments_are_passed():
    task = Task(lambda *args, **kwargs: (args, kwargs), args=(1,), kwargs={"two": 2})
    task()
    assert task.result() == ((1,), {"two": 2})


def test_a_coroutine_runs_in_steps():
    future = Future()

    async def wait():
        return await future

    task = Task(wait)
    task()
    assert not task.done()
    future.set_result(3)
    task()
    assert task.done()
    assert task.result() == 3


def test_an_exception_is_kept():
    def fail():
        raise KeyError("lost")

    task = Task(fail)
    task()
    assert isinstance(task.exception(), KeyError)


def test_a_done_task_does_not_run_again():
    calls = []
    task = Task(lambda: calls.append(1))
    task()
    task()
    assert calls == [1]


def test_a_cancelled_task_does_not_run():
    calls = []
    task = Task(lambda: calls.append(1))
    task.cancel()
    task()
    assert task.cancelled()
    assert calls == []


def test_the_executor_runs_tasks(world):
    task = world.executor.create_task(lambda: 42)
    assert world.result(task) == 42


def test_the_executor_runs_coroutines(world):
    async def answer(value):
        return value

    assert world.result(world.executor.create_task(answer, 5)) == 5


def test_one_task_may_await_another(world):
    async def inner():
        return "inner"

    async def outer():
        return await world.executor.create_task(inner) + " outer"

    task = world.executor.create_task(outer)
    world.spin_until(task.done)
    assert task.result() == "inner outer"


def test_an_exception_in_a_task_leaves_spin(world):
    def fail():
        raise ValueError("task failed")

    world.executor.create_task(fail)
    with pytest.raises(ValueError, match="task failed"):
        world.spin_for(1.0)


def test_a_task_wakes_when_its_future_is_done(world):
    future = Future(executor=world.executor)

    async def wait():
        return await future

    task = world.executor.create_task(wait)
    world.executor.spin_once(timeout_sec=0)
    assert not task.done()
    future.set_result("now")
    assert world.result(task) == "now"
