"""What stands in the place of sys.stdout."""

import io

from coursekit.processes.session import Session
from coursekit.processes.streams import StreamProxy


def teed(stream: StreamProxy) -> list[str]:
    """Replace the stream's `write` by one that also remembers, as IPython does while a cell runs."""
    heard: list[str] = []
    before = stream.write

    def write(text: str) -> int:
        heard.append(text)
        return before(text)

    stream.write = write
    return heard


def test_who_replaces_write_hears_the_interpreter_s_own_text_which_still_arrives() -> None:
    real = io.StringIO()
    stream = StreamProxy("stdout", real)
    before = stream.write
    heard = teed(stream)
    stream.write("cell\n")
    stream.write = before
    stream.write("later\n")
    assert heard == ["cell\n"] and real.getvalue() == "cell\nlater\n"


def test_what_a_process_prints_is_none_of_the_cell_s_output() -> None:
    stream = StreamProxy("stdout", io.StringIO())
    heard = teed(stream)
    with Session(virtual=True).use() as session:
        process = session.start(lambda: print("hello", file=stream), name="greeter")
        process.wait()
    assert process.output == "hello\n" and heard == []
