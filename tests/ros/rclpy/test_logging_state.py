import sys

import pytest
from rclpy.impl.logging_state import LoggingState
from rclpy.logging import LoggingSeverity, get_logger, get_logger_effective_level, set_logger_level

from coursekit.processes.session import Session

CALLER = ("/home/me/node.py", "spin_around", 12)
STAMP = 1_700_000_000_123_456_789


def shown(capsys, level=20, text="hello", **environ):
    LoggingState(environ).write(level, "robot.arm", text, CALLER, STAMP)
    captured = capsys.readouterr()
    return captured.err, captured.out


def test_a_line_looks_as_in_ros(capsys):
    assert shown(capsys) == ("[INFO] [1700000000.123456789] [robot.arm]: hello\n", "")


def test_the_format_is_read_from_the_environment(capsys):
    pattern = (
        "{severity} {name} {function_name} {file_name} {line_number} {time_as_nanoseconds} {message} {bad} {"
    )
    line, _ = shown(capsys, RCUTILS_CONSOLE_OUTPUT_FORMAT=pattern)
    where = "spin_around /home/me/node.py 12"
    assert line == f"INFO robot.arm {where} {STAMP} hello {{bad}} {{\n"


def test_text_with_braces_is_left_as_it_is(capsys):
    line, _ = shown(capsys, text="{name}", RCUTILS_CONSOLE_OUTPUT_FORMAT="{message}\\t|")
    assert line == "{name}\t|\n"


@pytest.mark.parametrize(("level", "colour"), [(10, "32"), (20, "0"), (30, "33"), (40, "31"), (50, "31")])
def test_colours_are_shown_when_asked_for(capsys, level, colour):
    line, _ = shown(capsys, level, RCUTILS_COLORIZED_OUTPUT="1")
    assert line.startswith(f"\033[{colour}m[")
    assert line.endswith("hello\033[0m\n")


def test_lines_can_go_to_standard_output(capsys):
    assert shown(capsys, RCUTILS_LOGGING_USE_STDOUT="1")[1].endswith("hello\n")


def test_unsetting_the_default_lets_everything_through():
    state = LoggingState({})
    state.set_level("", 40)
    assert state.effective_level("a") == 40
    state.set_level("", 0)
    assert state.effective_level("a") == state.effective_level("") == 0


def test_every_process_has_its_own_levels():
    session = Session(virtual=True)
    levels = []

    def loud():
        set_logger_level("own", LoggingSeverity.DEBUG)
        levels.append(get_logger_effective_level("own"))

    def quiet():
        levels.append(get_logger_effective_level("own"))

    with session.use():
        for main in (loud, quiet):
            session.start(main, name=main.__name__).wait()
    assert levels == [LoggingSeverity.DEBUG, LoggingSeverity.INFO]


def test_every_process_writes_to_its_own_output():
    session = Session(virtual=True)

    def say():
        get_logger("a").info(sys.argv[0])

    with session.use():
        one = session.start(say, name="one")
        two = session.start(say, name="two")
        assert (one.wait(), two.wait()) == (0, 0)
    assert "one" in one.output
    assert "two" not in one.output
    assert "two" in two.output


def test_the_stamp_is_the_sessions_time():
    session = Session(virtual=True)
    with session.use():
        before = session.clock.now() // 10**9
        process = session.start(lambda: get_logger("a").info("now"), name="p")
        process.wait()
    assert f"[{before}." in process.output
