"""`wait` and `--until` wait for what happens, not only for a time."""

import pytest
from IPython.core.interactiveshell import InteractiveShell

from coursekit.lab import waiting
from coursekit.lab.errors import NotNow, TooLate
from coursekit.lab.known_terminals import KNOWN, failed
from coursekit.lab.magics import CourseMagics, show_as
from coursekit.lab.terminal import Terminal
from coursekit.lab.waiting import wait
from coursekit.view.progress_bar import ProgressBar


def late_talker(session, delay):
    """A node that begins to speak after `delay` seconds, as one that has to be compiled first."""

    def main():
        import rclpy
        from std_msgs.msg import String

        session.clock.sleep(delay)
        rclpy.init()
        node = rclpy.create_node("late")
        publisher = node.create_publisher(String, "map", 1)
        node.create_timer(0.1, lambda: publisher.publish(String(data="here")))
        try:
            rclpy.spin(node)
        except KeyboardInterrupt:
            rclpy.try_shutdown()

    return session.start(main, name="late")


def seconds(session, call):
    begin = session.clock.steady()
    call()
    return (session.clock.steady() - begin) * 1e-9


@pytest.mark.parametrize(("delay", "least", "passed"), [(40.0, 1.0, 40.1), (0.0, 3.0, 3.0)])
def test_it_waits_the_time_and_on_until_a_message_came(session, delay, least, passed):
    late_talker(session, delay)
    assert seconds(session, lambda: wait(least, until="map")) == pytest.approx(passed, abs=0.1)


def test_without_a_topic_it_is_a_time(session):
    assert seconds(session, lambda: wait(2.5)) == pytest.approx(2.5)


def silent(session):
    """A program that runs and publishes nothing."""
    return session.start(lambda: session.clock.sleep(1000.0), name="silent")


def test_where_no_program_runs_nothing_is_waited_for(session):
    def asked():
        with pytest.raises(NotNow, match="Nothing publishes /map: no program runs"):
            wait(1.0, until="/map")

    assert seconds(session, asked) < 2


def test_what_never_comes_is_said(session):
    silent(session)
    with pytest.raises(TooLate, match=r"No message came on /map within 5 s.*graph\(\)"):
        wait(1.0, until="/map", timeout_sec=5.0)


def test_a_program_that_ended_with_an_error_is_named_with_what_never_came(session):
    KNOWN.clear()  # those of other tests
    shown = Terminal(session.start(lambda: 3, name="client_exe"), "client_exe")
    shown.wait()
    show_as("client_exe", shown)
    silent(session)
    with pytest.raises(TimeoutError, match=r"within 1 s\. client_exe ended with exit code 3\. `graph"):
        wait(until="/map", timeout_sec=1.0)


def test_the_bar_names_a_program_that_ended_while_nobody_publishes(session, monkeypatch):
    bars = []
    monkeypatch.setattr(waiting, "ProgressBar", lambda *given: bars.append(ProgressBar(*given)) or bars[-1])
    KNOWN.clear()
    shown = Terminal(session.start(lambda: 3, name="client_exe"), "client_exe")
    shown.wait()
    show_as("client_exe", shown)
    silent(session)
    with pytest.raises(TooLate):
        wait(until="/map", timeout_sec=1.0)
    assert "Nobody publishes it yet. client_exe ended with exit code 3. The stop button" in bars[0].html()


def test_the_bar_is_quiet_once_somebody_publishes(session, monkeypatch):
    bars = []
    monkeypatch.setattr(waiting, "ProgressBar", lambda *given: bars.append(ProgressBar(*given)) or bars[-1])
    late_talker(session, 2.0)
    wait(until="/map")
    assert "Nobody" not in bars[0].html()


def test_a_program_that_ended_by_ctrl_c_has_not_failed(session):
    KNOWN.clear()

    def main():
        try:
            session.clock.sleep(100.0)
        except KeyboardInterrupt:
            return 2  # as `ros2 topic pub` does
        return 0

    shown = Terminal(session.start(main, name="pub"), "pub")
    show_as("pub", shown)
    session.clock.sleep(1.0)
    shown.interrupt()
    shown.wait()
    assert shown.process.exit_code == 2 and failed() == []


def ros2(line):
    CourseMagics(InteractiveShell()).ros2(line)


def test_a_command_goes_on_until_it_has_said_what_is_waited_for(session, capsys):
    late_talker(session, 10.0)
    took = seconds(session, lambda: ros2('--stop-after 1 --until "data:" topic echo /map std_msgs/msg/String'))
    assert 10.0 < took < 11.0 and "data: here" in capsys.readouterr().out


def test_a_command_that_has_said_it_early_still_has_its_time(session, capsys):
    late_talker(session, 0.0)
    took = seconds(session, lambda: ros2('--stop-after 3 --until "data:" topic echo /map std_msgs/msg/String'))
    assert took == pytest.approx(3.0, abs=0.1)


def test_a_command_that_ends_is_not_waited_for(session):
    assert seconds(session, lambda: ros2('--until "never" node list')) < 5


def test_a_program_that_only_repeats_its_line_is_ended_and_the_reason_said(session, capsys):
    line = '--stop-after 1.5 --until "At time" run tf2_ros tf2_echo odom nobody'
    assert 25 < seconds(session, lambda: ros2(line)) < 40
    assert '"At time" did not come' in capsys.readouterr().out
