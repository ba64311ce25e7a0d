"""What rclcpp does, noun by noun: each program in `conformance/` says of each thing whether it holds, on both clocks."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from coursekit.processes.executables import make_process
from coursekit.processes.session import Session

ROOM = Path(__file__).parent / "conformance"
NOUNS = sorted(path.stem for path in ROOM.glob("*.cpp"))
_CALL = re.compile(r'\b(?:check|equal|throws<[\w:]+>|refuses)\(\s*"([^"]+)"')
_BY_NAME = re.compile(r'\b(?:said)\(\s*"([^"]+)"')
_LEAST = 150


def checks_of(noun):
    """The names of all that a program checks."""
    text = (ROOM / f"{noun}.cpp").read_text(encoding="utf-8")
    return sorted(set(_CALL.findall(text)) | set(_BY_NAME.findall(text)))


@pytest.mark.parametrize("virtual", [True, False], ids=["virtual", "wall"])
@pytest.mark.parametrize("noun", NOUNS)
def test_it_does_as_humble_does(noun, virtual, build, tmp_path):
    path = build(noun, (ROOM / f"{noun}.cpp").read_text(encoding="utf-8"))
    with (session := Session(virtual=virtual)).use():
        process = session.launch(make_process(session, path, name=noun, cwd=str(tmp_path)))
        code = process.wait(60.0)
    lines = process.output.splitlines()
    assert [line for line in lines if line.startswith("not ok")] == []
    assert sorted({line[3:] for line in lines if line.startswith("ok ")}) == checks_of(noun), process.output
    assert code == 0, process.output


def test_lines_of_loggers_are_those_of_humble(build):
    path = build("logging", (ROOM / "logging.cpp").read_text(encoding="utf-8"))
    with (session := Session(virtual=True)).use():
        process = session.launch(make_process(session, path, name="logging"))
        assert process.wait(20.0) == 0
    said = [line.partition("LINE ")[2] for line in process.output.splitlines() if "LINE" in line]
    assert said == [
        "1 of text",
        "stream 2 0.5",
        *("once 0", "throttled 0", "throttled stream 0", "fatal 0"),
        *("skipped first 1", "expression 1", "skipped first 2"),
        "function",
        "by name",
        "by name 2",
        "throttled by name 0",
    ]


def test_what_a_callback_for_news_throws_is_logged(build):
    path = build("news", (ROOM / "news.cpp").read_text(encoding="utf-8"))
    with (session := Session(virtual=True)).use():
        process = session.launch(make_process(session, path, name="news"))
        assert process.wait(20.0) == 0
    said = [re.sub("@0x[0-9a-f]+", "@", line.partition("]: ")[2]) for line in process.output.splitlines() if "]: " in line]
    assert said == [
        "rclcpp::SubscriptionBase@ caught std::runtime_error exception in user-provided callback for the "
        "'on new message' callback: of mine",
        "Calling set_on_new_qos_event_callback for non registered subscription event_type",
    ]


def test_there_are_many_checks():
    assert sum(len(checks_of(noun)) for noun in NOUNS) >= _LEAST
