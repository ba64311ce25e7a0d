"""The parser takes the flags that Humble's commands take."""

import pytest

from coursekit.cli.parser import make_parser


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
