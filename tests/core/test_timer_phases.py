"""Timers that are due at one instant ring in the order in which their periods began: on a robot no two are equal."""

from coursekit.core.ready_queue import ReadyQueue
from coursekit.core.time_base import STEADY_TIME, TimeBase
from coursekit.core.timer import Timer
from coursekit.core.virtual_clock import VirtualClock


def attached(queue, clock, *periods):
    """Timers of a queue with these periods in seconds, named by them."""
    timers = [Timer(TimeBase(STEADY_TIME, clock), round(period * 1e9)) for period in periods]
    for timer, period in zip(timers, periods, strict=True):
        timer.attach(queue, (period, timer))
    return timers


def rung(queue, clock, until):
    """Call what is due, each at its time; the periods in the order of the calls."""
    periods = []
    while True:
        queue.wait(round(until * 1e9))
        item = queue.pop()
        if item is None:
            return periods
        period, timer = item
        timer.queued = False
        timer.call()
        periods.append(period)


def test_the_timer_that_began_first_rings_first_however_often_it_has_rung_meanwhile():
    clock = VirtualClock()
    queue = ReadyQueue(clock)
    attached(queue, clock, 0.5, 2.0)
    assert rung(queue, clock, 2.0) == [0.5, 0.5, 0.5, 0.5, 2.0]


def test_a_timer_that_began_anew_rings_after_those_of_the_same_instant():
    clock = VirtualClock()
    queue = ReadyQueue(clock)
    first, second = attached(queue, clock, 1.0, 0.5)
    first.reset()
    assert rung(queue, clock, 1.0) == [0.5, 0.5, 1.0]
    second.reset()
    assert rung(queue, clock, 2.0) == [0.5, 1.0, 0.5]
