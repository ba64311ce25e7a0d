"""diagnostic_aggregator: statuses in groups, as its parameters say."""

import pytest
import yaml
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus

GENERIC = "diagnostic_aggregator/GenericAnalyzer"
ROBOT = {
    "path": "Robot",
    "arms": {"type": GENERIC, "path": "Arms", "startswith": ["/arms"], "timeout": 5.0},
    "motors": {"type": GENERIC, "path": "Motors", "contains": "motor", "find_and_remove_prefix": ["/legs"]},
    "sides": {
        "type": "diagnostic_aggregator/AnalyzerGroup", "path": "Sides",
        "analyzers": {"left": {"type": GENERIC, "path": "Left", "regex": ".*left.*"}},
    },
    "noise": {"type": "diagnostic_aggregator/DiscardAnalyzer", "path": "Noise", "name": "chatter"},
    "off": {"type": "diagnostic_aggregator/IgnoreAnalyzer", "path": "Off", "contains": "fan"},
}  # fmt: skip


@pytest.fixture
def aggregator(run, tmp_path):
    """aggregator(parameters) starts the node."""

    def start(parameters):
        file = tmp_path / "analyzers.yaml"
        file.write_text(yaml.safe_dump({"analyzers": {"ros__parameters": parameters}}))
        return run("diagnostic_aggregator", "aggregator_node", "--ros-args", "--params-file", str(file))

    return start


def tell(friend, **levels):
    msg = DiagnosticArray(status=[DiagnosticStatus(name=name, level=bytes([level])) for name, level in levels.items()])
    msg.header.stamp = friend.node.get_clock().now().to_msg()
    friend.say("/diagnostics", msg)


def last(heard):
    return {status.name: status.level[0] for status in heard[-1].status}


def test_each_status_is_reported_by_all_that_match_it_and_groups_have_the_worst_level(friend, aggregator):
    aggregator(ROBOT)
    heard = friend.hear(DiagnosticArray, "/diagnostics_agg")
    worst = friend.hear(DiagnosticStatus, "/diagnostics_toplevel_state")
    friend.spin(0.5)
    tell(friend, **{"/arms/left": 0, "/arms/right": 1, "/legs/left/motor": 2, "chatter": 2, "fan": 0})
    friend.spin(1.0)
    assert last(heard) == {
        "/Robot": 2, "/Robot/Arms": 1, "/Robot/Arms/ arms left": 0, "/Robot/Arms/ arms right": 1,
        "/Robot/Motors": 2, "/Robot/Motors/left motor": 2,
        "/Robot/Sides": 2, "/Robot/Sides/Left": 2, "/Robot/Sides/Left/ arms left": 0,
        "/Robot/Sides/Left/ legs left motor": 2,
        "/Robot/Other": 0, "/Robot/Other/fan": 0,
    }  # fmt: skip
    top = next(status for status in heard[-1].status if status.name == "/Robot")
    assert {value.key: value.value for value in top.values} == {"Arms": "Warning", "Motors": "Error", "Sides": "Error"}
    assert worst[-1].name == "toplevel_state" and worst[-1].level == b"\x02"


def test_what_is_no_longer_told_is_stale_and_others_are_forgotten(friend, aggregator):
    aggregator(ROBOT)
    heard = friend.hear(DiagnosticArray, "/diagnostics_agg")
    worst = friend.hear(DiagnosticStatus, "/diagnostics_toplevel_state")
    friend.spin(0.5)
    tell(friend, **{"/arms/left": 0, "/arms/right": 0, "fan": 0})
    friend.spin(4.0)
    tell(friend, **{"/arms/right": 0})
    friend.spin(3.0)
    assert last(heard)["/Robot/Arms"] == 2 and last(heard)["/Robot/Arms/ arms left"] == 3
    assert last(heard)["/Robot/Arms/ arms right"] == 0 and "/Robot/Other" not in last(heard)
    friend.spin(6.0)
    assert last(heard)["/Robot/Arms"] == 3 and last(heard)["/Robot"] == 3 and worst[-1].level == b"\x03"


@pytest.mark.parametrize(
    ("settings", "level", "message"),
    [
        ({"expected": ["lidar"]}, 3, "Stale"),
        ({"expected": ["lidar"], "contains": "cam"}, 2, "Error"),
        ({"contains": "cam", "num_items": 2}, 2, "Expected 2, found 1"),
        ({"contains": "x", "num_items": 0}, 0, "OK"),
        ({"contains": "x", "num_items": 3}, 3, "No items found, expected 3"),
        ({"expected": ["lidar"], "contains": "cam", "timeout": 1.0, "discard_stale": True}, 2, "Error"),
    ],
)
def test_expected_names_and_numbers_are_checked(friend, aggregator, settings, level, message):
    aggregator({"path": "R", "sensors": {"type": GENERIC, "path": "Sensors", **settings}})
    heard = friend.hear(DiagnosticArray, "/diagnostics_agg")
    friend.spin(2.6)
    tell(friend, cam=0)
    friend.spin(0.6)
    head = next(status for status in heard[-1].status if status.name == "/R/Sensors")
    assert (head.level[0], head.message) == (level, message)


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        ({"type": GENERIC, "path": "A"}, "GenericAnalyzer 'A' was not initialized with any way of checking diagnostics."),
        ({"type": GENERIC, "contains": "x"}, "Unable to initialize analyzer a, type: diagnostic_aggregator/GenericAnalyzer"),
        ({"type": "diagnostic_aggregator/GenericAnalyser", "path": "A"}, "no such class. Did you mean GenericAnalyzer?"),
        ({"type": GENERIC, "path": "A", "regex": ["("], "name": "x"}, "Attempted to make regex from (."),
    ],
)
def test_wrong_analyzers_are_told(friend, aggregator, settings, said):
    node = aggregator({"a": settings, "b": {"type": GENERIC, "path": "B", "name": "x"}})
    heard = friend.hear(DiagnosticArray, "/diagnostics_agg")
    friend.spin(1.5)
    assert said in node.output
    assert ("/a" in last(heard)) == ("regex" not in settings) and "/B" in last(heard)


def test_messages_without_a_stamp_are_told_once(friend, aggregator):
    node = aggregator({})
    for _ in range(3):
        friend.spin(0.2)
        friend.say("/diagnostics", DiagnosticArray(status=[DiagnosticStatus(name="a"), DiagnosticStatus(name="b")]))
    friend.spin(0.2)
    assert node.output.count("No timestamp set for diagnostic message. Message names: a, b") == 1
    assert "No analyzers initialized in AnalyzerGroup" in node.output
