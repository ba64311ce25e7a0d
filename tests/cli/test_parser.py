"""The parser takes the flags that Humble's commands take."""

import pytest

from coursekit.cli.parser import COMMANDS, make_parser


@pytest.mark.parametrize(
    "line",
    [
        "node list --no-daemon --spin-time 2",
        "node info --spin-time 0.5 /talker",
        "topic list --no-daemon -t",
        "topic info -s -v /chatter",
        "topic echo --spin-time 1 --use-sim-time /chatter",
        "service list --no-daemon",
        "action list --no-daemon",
        "param get --no-daemon /talker use_sim_time",
        "lifecycle nodes --no-daemon",
    ],
)
def test_the_flags_for_how_the_graph_is_found_are_taken(line):
    words = line.split()
    for parser in (make_parser(), make_parser(words[0])):
        assert parser.parse_args(words).main is not None


def test_flags_that_no_command_knows_are_refused(capsys):
    with pytest.raises(SystemExit):
        make_parser("node").parse_args(["node", "list", "--no-demon"])
    assert "--no-demon" in capsys.readouterr().err


def test_help_lists_the_commands_by_name_and_says_that_wtf_is_the_doctor():
    lines = [line.split(maxsplit=1) for line in make_parser().format_help().splitlines() if line.startswith("    ")]
    names = [words[0] for words in lines if words[0] in COMMANDS]
    assert names == sorted(COMMANDS)
    assert lines[-1] == ["wtf", "Use `wtf` as alias to `doctor`"]
    assert make_parser("wtf").parse_args(["wtf", "-r"]).report
