"""Timers and ROS time."""

import pytest

from coursekit.core.ready_queue import ReadyQueue
from coursekit.core.time_base import ROS_TIME, STEADY_TIME, TimeBase
from coursekit.core.timer import Timer
from coursekit.core.virtual_clock import VirtualClock

MS = 1_000_000


@pytest.fixture
def clock():
    return VirtualClock()


def calls(clock, queue, until_ms):
    """When timers were called, in milliseconds, until a moment."""
    seen = []
    while True:
        timer = queue.pop()
        if timer is not None:
            timer.queued = False
            if timer.has_work():
                timer.call()
                seen.append(clock.steady() // MS)
            continue
        if clock.steady() >= until_ms * MS:
            return seen
        queue.wait(until_ms * MS)


def test_a_timer_is_due_once_a_period(clock):
    queue, timer = ReadyQueue(clock), Timer(TimeBase(STEADY_TIME, clock), 10 * MS)
    timer.attach(queue, timer)
    assert calls(clock, queue, 45) == [10, 20, 30, 40]


def test_missed_periods_are_skipped_not_made_up_for(clock):
    queue, timer = ReadyQueue(clock), Timer(TimeBase(STEADY_TIME, clock), 10 * MS)
    timer.attach(queue, timer)
    clock.sleep(0.035)
    assert calls(clock, queue, 60) == [35, 40, 50, 60]


def test_a_cancelled_timer_rests_until_it_is_reset(clock):
    queue, timer = ReadyQueue(clock), Timer(TimeBase(STEADY_TIME, clock), 10 * MS)
    timer.attach(queue, timer)
    timer.cancel()
    assert calls(clock, queue, 25) == [] and timer.time_until_next_call() is None
    timer.reset()
    assert calls(clock, queue, 46) == [35, 45]


def test_a_timer_on_simulated_time_follows_that_time(clock):
    base = TimeBase(ROS_TIME, clock)
    base.set_active(True)
    queue, timer = ReadyQueue(clock), Timer(base, 10 * MS)
    timer.attach(queue, timer)
    assert calls(clock, queue, 100) == []
    base.set_override(10 * MS)
    assert queue.pop() is timer
    timer.queued = False
    timer.call()
    base.set_override(15 * MS)
    assert queue.pop() is None
    base.set_override(20 * MS)
    assert queue.pop() is timer


def test_ros_time_is_zero_before_the_first_message_and_jumps_are_told(clock):
    base, told = TimeBase(ROS_TIME, clock), []
    token = object()
    base.add_watcher(token, None, lambda delta, toggled, active: told.append((delta, toggled, active)))
    base.set_active(True)
    assert base.now() == 0
    base.set_override(5)
    base.set_override(3)
    base.remove_watcher(token)
    base.set_active(False)
    assert told[0][1:] == (True, True) and told[1:] == [(5, False, True), (-2, False, True)]
    assert base.now() == clock.now()
