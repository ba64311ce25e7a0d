"""Commands and verbs that a workspace's packages add to `ros2`, and what `ros2` itself does without a verb."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from coursekit.cli.parser import run
from coursekit.processes.session import Session

Command = Callable[..., tuple[int, str]]

ENTRY_POINTS = """
[ros2cli.command]
hello = added.commands:HelloCommand
broken = added.nothing:Command

[ros2topic.verb]
shout = added.commands:ShoutVerb
list = added.commands:ShoutVerb

[ros2cli.extension_point]
added.verb = added.commands:AddedVerb

[added.verb]
say = added.commands:SayVerb
"""
COMMANDS = '''
from ros2cli.command import CommandExtension, add_subparsers_on_demand
from ros2cli.node.strategy import NodeStrategy, add_arguments
from ros2cli.plugin_system import PLUGIN_SYSTEM_VERSION, satisfies_version
from ros2topic.verb import VerbExtension


class AddedVerb:
    NAME = None
    EXTENSION_POINT_VERSION = "0.1"

    def __init__(self):
        satisfies_version(PLUGIN_SYSTEM_VERSION, "^0.1")


class SayVerb(AddedVerb):
    """Say a word."""

    def add_arguments(self, parser, cli_name):
        parser.add_argument("word")

    def main(self, *, args):
        print("said", args.word)
        return 3


class HelloCommand(CommandExtension):
    """Greet whoever asks."""

    def add_arguments(self, parser, cli_name):
        self._subparser = parser
        add_subparsers_on_demand(parser, cli_name, "_verb", "added.verb", required=False)

    def main(self, *, parser, args):
        if not hasattr(args, "_verb"):
            self._subparser.print_help()
            return 0
        return getattr(args, "_verb").main(args=args)


class ShoutVerb(VerbExtension):
    """Shout the topics."""

    def add_arguments(self, parser, cli_name):
        add_arguments(parser)
        parser.add_argument("--fail", action="store_true")

    def main(self, *, args):
        if args.fail:
            return "hoarse"
        with NodeStrategy(args) as node:
            print(*(name.upper() for name, _ in node.get_topic_names_and_types()))
'''


@pytest.fixture
def ros2(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Command]:
    """A terminal in which a package with commands of its own is on the path."""
    (tmp_path / "added").mkdir()
    (tmp_path / "added" / "__init__.py").touch()
    (tmp_path / "added" / "commands.py").write_text(COMMANDS)
    (tmp_path / "added-1.0.dist-info").mkdir()
    (tmp_path / "added-1.0.dist-info" / "METADATA").write_text("Metadata-Version: 2.1\nName: added\nVersion: 1.0\n")
    (tmp_path / "added-1.0.dist-info" / "entry_points.txt").write_text(ENTRY_POINTS)
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}{os.pathsep}{os.environ.get('PYTHONPATH', '')}")
    with Session(virtual=True).use() as session:

        def carry_out(*words: str) -> tuple[int, str]:
            process = session.start(lambda: run(words), name="ros2")
            return process.wait(10), process.output

        yield carry_out


def test_a_package_adds_a_command_with_verbs(ros2: Command) -> None:
    code, text = ros2("hello")
    assert code == 0 and "say" in text and "Say a word" in text
    assert ros2("hello", "say", "hi") == (3, "said hi\n")
    assert "hello               Greet whoever asks" in ros2("--help")[1]


def test_a_package_adds_a_verb_and_replaces_none(ros2: Command) -> None:
    assert ros2("topic", "shout") == (0, "\n")
    assert ros2("topic", "shout", "--fail") == (1, "hoarse\n")
    assert "shout               Shout the topics" in ros2("topic")[1]
    assert "--show-types" in ros2("topic", "list", "--help")[1]


def test_an_extension_that_cannot_be_loaded_is_told(ros2: Command) -> None:
    code, text = ros2("broken")
    assert code == 2 and "invalid choice: 'broken'" in text
    assert "Failed to load entry point 'broken' of group 'ros2cli.command'" in text and "was it built?" in text


def test_extensions_and_their_points_are_listed(ros2: Command) -> None:
    points = ros2("extension_points")[1].split()
    assert {"added.verb", "ros2cli.command", "ros2topic.verb", "ros2controlcli.verb"} <= set(points)
    text = ros2("extensions", "--verbose")[1]
    assert "added.verb\n  say\n    added.commands:SayVerb\n" in text
    assert "  hz\n" in text and "extensions" not in ros2("--help")[1]


@pytest.mark.parametrize("command", ["action", "bag", "daemon", "param", "pkg", "topic"])
def test_a_command_without_a_verb_shows_its_help(ros2: Command, command: str) -> None:
    code, text = ros2(command)
    assert code == 0 and text.startswith(f"usage: ros2 {command}")


def test_buffering_may_be_asked_for(ros2: Command) -> None:
    assert ros2("--use-python-default-buffering", "node", "list") == (0, "")


def test_the_daemon_may_be_started_with_its_debug_output(ros2: Command) -> None:
    assert ros2("daemon", "start", "--debug") == (0, "The daemon is already running\n")


def test_doctor_says_hello(ros2: Command) -> None:
    code, text = ros2("doctor", "hello", "--once")
    assert code == 0
    assert text.startswith("MULTIMACHINE COMMUNICATION SUMMARY\nTopic: /canyouhearme, Published Msg Count: 1\n")


@pytest.mark.parametrize(
    "line",
    [
        ("topic", "pub", "/a", "std_msgs/msg/String", "{data: hi"),
        ("service", "call", "/a", "std_srvs/srv/SetBool", "{data: true"),
        ("action", "send_goal", "/a", "example_interfaces/action/Fibonacci", "{order: 3"),
    ],
)
def test_a_brace_that_is_missing_is_told(ros2: Command, line: tuple[str, ...]) -> None:
    code, text = ros2(*line)
    assert code == 1
    assert text.startswith("The passed value needs to be a dictionary in YAML format\n")
    assert f"expected ',' or '}}', but got '<stream end>' at character {len(line[-1]) + 1}" in text


def test_a_rate_is_above_zero(ros2: Command) -> None:
    assert "argument -r/--rate: The value must be greater than zero" in ros2("topic", "pub", "-r", "0", "/a", "x")[1]
