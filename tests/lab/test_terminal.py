import pytest

from coursekit.lab.terminal import LINES, Terminal


def opened(session, main, monkeypatch, again=False):
    """A terminal of `main`, and what it sends to its browser."""

    def begin():
        return session.start(main, name="program")

    terminal = Terminal(begin(), "program", again=begin if again else None)
    sent = []
    monkeypatch.setattr(terminal, "send", lambda message, buffers=None: sent.append(message))
    return terminal, sent


def says(terminal, **message):
    terminal._hear(terminal, message, [])


def chatty(session, lines, every):
    def main():
        for number in range(lines):
            print(f"line {number}")
            session.clock.sleep(every)

    return main


def test_a_thousand_lines_a_second_are_ten_messages_a_second(session, monkeypatch):
    terminal, sent = opened(session, chatty(session, 3000, 0.001), monkeypatch)
    says(terminal, type="ready")
    terminal.wait()
    assert len(sent) < 35
    assert "".join(message["text"] for message in sent) == terminal.text


def test_the_browser_gets_the_newest_lines_and_how_many_are_missing(session, monkeypatch):
    terminal, sent = opened(session, chatty(session, LINES + 200, 0.0), monkeypatch)
    terminal.wait()
    says(terminal, type="ready")
    assert sent[0]["skipped"] == 200 and sent[0]["text"].startswith("line 200\n") and sent[0]["whole"]


def test_a_page_that_is_loaded_again_gets_every_line_once(session, monkeypatch):
    terminal, sent = opened(session, chatty(session, 20, 0.07), monkeypatch)
    says(terminal, type="ready")
    session.clock.sleep(0.5)
    del sent[:]
    says(terminal, type="ready")
    terminal.wait()
    assert "".join(message["text"] for message in sent) == terminal.text


def test_run_again_starts_the_same_command_in_the_same_terminal(session, monkeypatch):
    terminal, sent = opened(session, lambda: print("hello"), monkeypatch, again=True)
    terminal.wait()
    first = terminal.process
    says(terminal, type="ready")
    says(terminal, type="again")
    terminal.wait()
    assert terminal.process is not first and terminal.text == "hello\n"
    assert sent[-1]["state"] == "finished"


def test_a_terminal_that_cannot_start_its_process_again_says_so(session, monkeypatch):
    terminal, _ = opened(session, lambda: None, monkeypatch)
    with pytest.raises(RuntimeError, match="started elsewhere"):
        terminal.restart()


def test_ctrl_c_ends_and_the_state_says_how(session, monkeypatch):
    terminal, sent = opened(session, chatty(session, 100, 1.0), monkeypatch)
    says(terminal, type="ready")
    session.clock.sleep(0.5)
    says(terminal, type="interrupt")
    terminal.wait()
    assert terminal.state == "exit code -2" and sent[-1]["state"] == "exit code -2"
    assert repr(terminal) == "[program: exit code -2]"


def test_a_typed_line_reaches_the_program(session, monkeypatch):
    terminal, _ = opened(session, lambda: print("you said", input()), monkeypatch)
    session.clock.sleep(0.1)
    says(terminal, type="line", text="hi")
    terminal.wait()
    assert terminal.tail(1) == "you said hi"


def test_a_terminal_is_waited_for_until_it_says_something(session, monkeypatch):
    shown, _ = opened(session, chatty(session, 9, 1.0), monkeypatch)
    assert shown.wait(until="line 3") is None and shown.text.splitlines()[-1] == "line 3"
    assert shown.wait(1.0, until="line 8") is None and shown.wait() == 0
    assert shown.wait(until="line 99") == 0, "it has ended: nothing more is said"
