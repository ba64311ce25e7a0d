"""MultiThreadedExecutor has a pool: few threads, used again, on both clocks."""

import gc
import threading
import time
import warnings

import pytest
import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.task import Future

from coursekit.processes.session import Session

CALLS = 40


@pytest.fixture(params=["wall", "virtual"])
def session(request):
    with Session(virtual=request.param == "virtual").use() as session:
        yield session


def many_calls(threads, work):
    """A program whose reentrant timer calls `work()` CALLS times in that many threads."""

    def main():
        rclpy.init()
        node, done, calls = rclpy.create_node("node"), Future(), []

        def call():
            work()
            calls.append(1)
            if len(calls) == CALLS:
                done.set_result(None)

        node.create_timer(0.001, call, callback_group=ReentrantCallbackGroup())
        executor = MultiThreadedExecutor(threads)
        executor.add_node(node)
        executor.spin_until_future_complete(done)
        executor.shutdown()
        rclpy.shutdown()

    return main


def test_callbacks_share_as_many_threads_as_were_asked_for(session):
    seen = []
    assert session.start(many_calls(3, lambda: seen.append(threading.current_thread())), name="p").wait(60) == 0
    assert len(seen) >= CALLS and 1 <= len(set(seen)) <= 3
    assert all(thread.name.startswith("ThreadPoolExecutor-") for thread in seen)


def test_threads_run_side_by_side_and_are_named_one_by_one(session):
    names = set()

    def work():
        names.add(threading.current_thread().name.rpartition("_")[2])
        time.sleep(0.05)

    assert session.start(many_calls(3, work), name="p").wait(60) == 0
    assert names == {"0", "1", "2"}


def test_what_a_callback_keeps_in_its_thread_is_there_the_next_time():
    kept, counts, idents = threading.local(), [], set()

    def work():
        kept.count = getattr(kept, "count", 0) + 1
        counts.append(kept.count)
        idents.add(threading.get_ident())

    with Session().use() as session:
        assert session.start(many_calls(2, work), name="p").wait(60) == 0
    assert len(idents) <= 2 and max(counts) >= CALLS / 2
    assert counts.count(1) == len(idents)


def test_a_callback_that_blocks_leaves_the_other_threads(session):
    def main():
        rclpy.init()
        node, done, release, calls = rclpy.create_node("node"), Future(), threading.Event(), []
        group, first = ReentrantCallbackGroup(), threading.Lock()

        def block():
            if first.acquire(blocking=False):  # the timer may be due again before it is cancelled
                blocking.cancel()
                release.wait()

        def call():
            calls.append(threading.current_thread())
            if len(calls) == 10:
                done.set_result(None)

        blocking = node.create_timer(0.001, block, callback_group=group)
        executor = MultiThreadedExecutor(2)
        executor.add_node(node)
        while not blocking.is_canceled():
            executor.spin_once(timeout_sec=0.01)
        node.create_timer(0.001, call, callback_group=group)
        executor.spin_until_future_complete(done)
        print(len(set(calls)))
        release.set()

    process = session.start(main, name="p")
    assert process.wait(60) == 0 and process.output == "1\n"


def test_a_spin_ends_in_time_though_no_thread_is_free(session):
    def main():
        rclpy.init()
        node, release = rclpy.create_node("node"), threading.Event()
        started = threading.Event()

        def block():
            started.set()
            release.wait()

        node.create_timer(0.001, block, callback_group=ReentrantCallbackGroup())
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            executor = MultiThreadedExecutor(1)
        executor.add_node(node)
        while not started.is_set():
            executor.spin_once(timeout_sec=0.01)
        future = Future()
        executor.spin_until_future_complete(future, timeout_sec=0.05)
        print("in time", future.done())
        executor.create_task(lambda: None)
        threading.Timer(0.05, lambda: future.set_result(None)).start()
        executor.spin_until_future_complete(future)
        print("done")
        release.set()

    process = session.start(main, name="p")
    assert process.wait(60) == 0 and process.output == "in time False\ndone\n"


def test_a_program_that_ends_waits_for_its_callbacks(session):
    def main():
        rclpy.init()
        node, started = rclpy.create_node("node"), threading.Event()

        def work():
            timer.cancel()
            started.set()
            time.sleep(0.2)
            print("the callback has ended")

        timer = node.create_timer(0.001, work)
        executor = MultiThreadedExecutor(2)
        executor.add_node(node)
        while not started.is_set():
            executor.spin_once(timeout_sec=0.01)
        assert executor.shutdown(timeout_sec=0)
        print("main has ended")

    process = session.start(main, name="p")
    assert process.wait(60) == 0
    assert process.output == "main has ended\nthe callback has ended\n"


@pytest.mark.parametrize("kind", [KeyError, SystemExit])
def test_what_a_callback_raises_ends_the_spin_and_no_thread(session, kind):
    """SystemExit ends a thread's work and nothing else, as with Python's own pool."""

    def main():
        rclpy.init()
        node, calls = rclpy.create_node("node"), []

        def fail():
            calls.append(threading.current_thread())
            if len(calls) % 2:
                raise kind("from the callback")

        node.create_timer(0.001, fail)
        executor = MultiThreadedExecutor(2)
        executor.add_node(node)
        raised = 0
        while len(calls) < 8:
            try:
                executor.spin_once()
            except KeyError:
                raised += 1
        print(len(set(calls)) <= 2, raised >= 3)

    process = session.start(main, name="p")
    assert process.wait(60) == 0 and process.output == f"True {kind is KeyError}\n"


def test_one_thread_is_told_and_none_is_refused():
    with Session().use():
        rclpy.init()
        with pytest.warns(UserWarning, match="used with a single thread.\nUse the SingleThreadedExecutor"):
            MultiThreadedExecutor(1)
        with pytest.raises(ValueError, match="max_workers must be greater than 0"):
            MultiThreadedExecutor(0)
        rclpy.shutdown()


def test_an_executor_that_is_forgotten_leaves_no_thread():
    before = set(threading.enumerate())
    with Session().use():
        rclpy.init()
        executor = MultiThreadedExecutor(2)
        executor.create_task(lambda: None)
        executor.spin_once(timeout_sec=1.0)
        started = [thread for thread in set(threading.enumerate()) - before if "ThreadPool" in thread.name]
        assert started
        rclpy.shutdown()
        del executor
        gc.collect()
        for thread in started:
            thread.join(10.0)
        assert not any(thread.is_alive() for thread in started)
