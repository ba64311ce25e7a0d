"""Both clocks: what holds for every wait."""

import threading

import pytest

from coursekit.core.clock import WallClock
from coursekit.core.virtual_clock import START_NS, VirtualClock


@pytest.fixture(params=[WallClock, VirtualClock])
def clock(request):
    tested_clock = request.param()
    yield tested_clock
    tested_clock.close()


def test_a_set_event_does_not_wait(clock):
    event = clock.new_event()
    event.set()
    assert event.wait() and event.is_set()


def test_waiting_for_an_event_that_nobody_sets_ends_at_its_timeout(clock):
    before = clock.steady()
    assert not clock.new_event().wait(timeout_sec=0.01)
    assert clock.steady() - before >= 10_000_000


def test_a_cleared_event_waits_again(clock):
    event = clock.new_event()
    event.set()
    event.clear()
    assert not event.wait(timeout_sec=0.0)


def test_a_lane_wakes_another(clock):
    event, seen = clock.new_event(), []
    clock.spawn(lambda: (seen.append(1), event.set()), "setter")
    assert event.wait(timeout_sec=5) and seen == [1]


def test_a_waiter_remembers_a_notification(clock):
    waiter = clock.new_waiter()
    waiter.notify()
    assert waiter.wait(clock.steady())


def test_an_alarm_rings_once_and_a_cancelled_one_never(clock):
    rung, done = [], clock.new_event()
    clock.call_at(clock.steady() + 1_000_000, lambda: rung.append("a"))
    clock.call_at(clock.steady() + 2_000_000, lambda: rung.append("b")).cancel()
    clock.call_at(clock.steady() + 3_000_000, done.set)
    assert done.wait(timeout_sec=5) and rung == ["a"]


def test_virtual_time_begins_at_a_fixed_moment_and_passes_only_in_waits():
    clock = VirtualClock()
    assert clock.now() == START_NS and clock.steady() == 0
    assert clock.now() == START_NS
    clock.sleep(3600)
    assert clock.steady() == 3600 * 10**9


def test_virtual_lanes_run_in_the_order_in_which_they_are_due():
    clock, log = VirtualClock(), []
    for name, period in (("slow", 0.3), ("fast", 0.1)):

        def context(name=name, period=period):
            for _ in range(3):
                clock.sleep(period)
                log.append((name, clock.steady() // 10**6))

        clock.spawn(context, name)
    clock.sleep(1)
    assert [when for _, when in log] == [100, 200, 300, 300, 600, 900]
    assert [who for who, when in log if when == 300] == ["slow", "fast"]  # the slow one lay down first


def test_lanes_that_are_due_together_are_all_ready_before_one_that_they_wake():
    clock, seen = VirtualClock(), []
    woken = clock.new_event()

    def due(name):
        clock.sleep(1.0)
        seen.append(name)
        woken.set()

    clock.spawn(lambda: (woken.wait(), seen.append("woken")), "woken")
    for name in ("first", "second"):
        clock.spawn(lambda name=name: due(name), name)
    clock.sleep(2.0)
    assert seen == ["first", "second", "woken"]


def test_a_loop_that_only_asks_cannot_stop_virtual_time():
    clock = VirtualClock()
    event = clock.new_event()
    clock.spawn(lambda: (clock.sleep(0.01), event.set()), "later")
    questions = 0
    while not event.is_set():
        questions += 1
    assert clock.steady() >= 10_000_000 and questions <= 20_000


def test_a_thread_from_outside_wakes_a_virtual_lane():
    clock = VirtualClock()
    event = clock.new_event()
    threading.Thread(target=event.set).start()
    assert event.wait()


class InterruptedClock(VirtualClock):
    """A clock in which a thread from outside always comes at the worst moment: when somebody has decided to wait."""

    def __init__(self):
        super().__init__()
        self.outside = None

    def _block(self, context, waiter, deadline):
        run_outside(self.outside)
        super()._block(context, waiter, deadline)


def run_outside(function):
    thread = threading.Thread(target=function)
    thread.start()
    thread.join()


def test_a_notification_that_comes_when_a_lane_is_about_to_wait_is_not_lost():
    clock = InterruptedClock()
    waiter = clock.new_waiter()
    clock.outside = waiter.notify
    assert waiter.wait(1_000_000_000) and clock.steady() == 0


def test_what_is_posted_when_a_lane_is_about_to_wait_is_done_at_once():
    clock, seen = InterruptedClock(), []
    clock.outside = lambda: clock.running.post(lambda: seen.append(clock.steady()))
    assert not clock.new_waiter().wait(1_000_000_000)
    assert seen == [0]


def test_a_thread_from_outside_waits_for_a_virtual_lane():
    clock = VirtualClock()
    asked, answered, seen = clock.new_event(), clock.new_event(), []

    def outside():
        asked.set()
        seen.append(answered.wait())

    thread = threading.Thread(target=outside)
    thread.start()
    asked.wait()
    answered.set()
    thread.join()
    assert seen == [True]


def test_a_lane_that_ends_may_hand_over_to_one_that_has_not_begun():
    clock, log = VirtualClock(), []
    for name in "abc":
        clock.spawn(lambda name=name: log.append(name), name)
    clock.sleep(0.1)
    assert log == ["a", "b", "c"]
