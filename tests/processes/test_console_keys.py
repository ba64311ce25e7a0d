"""Programs that read single keys with msvcrt, as teleop nodes do on Windows."""

import pytest

from coursekit.processes import console_keys
from coursekit.processes.session import Session


def teleop():
    """Reads keys until Ctrl-Z."""
    while (key := console_keys.getwch()) != "\x1a":
        print(repr(key), end=" ")
    print("bye")


@pytest.fixture
def typed():
    """What a program prints when all this is typed, and how often it asked for single keys."""

    def run(main, *texts):
        with Session(virtual=True).use() as session:
            asked = []
            process = session.start(main, name="teleop")
            process.on_wants_keys = lambda: asked.append(True)
            for text in texts:
                session.clock.sleep(0.1)
                process.write_stdin(text)
            session.clock.sleep(0.1)
            process.close_stdin()
            assert process.wait(5) == 0
            return process.output, len(asked)

    return run


def test_keys_come_one_by_one_and_are_asked_for_once(typed):
    assert typed(teleop, "w", "xy") == ("'w' 'x' 'y' bye\n", 1)


def test_enter_is_a_carriage_return(typed):
    assert typed(teleop, "\n")[0] == "'\\r' bye\n"


def test_an_arrow_has_two_codes(typed):
    assert typed(teleop, "\x1b[A", "a")[0] == "'à' 'H' 'a' bye\n"


def test_what_only_begins_like_a_key_stays_as_it_is(typed):
    assert typed(teleop, "\x1b", "\x1bx")[0] == "'\\x1b' '\\x1b' 'x' bye\n"


def test_a_loop_that_asks_whether_there_is_a_key_lets_time_pass(typed):
    def asks():
        while not console_keys.kbhit():
            pass
        print(console_keys.getch())

    assert typed(asks, "q")[0] == "b'q'\n"


def test_on_windows_it_stands_in_msvcrt():
    msvcrt = pytest.importorskip("msvcrt")
    with Session(virtual=True).use():
        assert msvcrt.getwch is console_keys.getwch and msvcrt.kbhit is console_keys.kbhit
