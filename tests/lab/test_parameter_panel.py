"""The parameter panel shows, sets and follows."""

import pytest

from coursekit.lab.panel import open_panels
from coursekit.lab.parameter_panel import ParameterPanel
from tests.lab.panel_robot import heard_by_browser, robot_running, says


@pytest.fixture
def session():
    with robot_running() as virtual_session:
        yield virtual_session


def test_parameters_are_listed_with_type_range_and_lock(session):
    text = ParameterPanel("robot").text()
    assert "speed (integer): 3  0 .. 10" in text
    assert "names (string array): [a, b]" in text
    assert "serial (string): X1  read-only" in text


def test_a_parameter_set_elsewhere_is_followed(session):
    panel = ParameterPanel("/robot")
    other = ParameterPanel("/robot")
    assert other.set("speed", 7)
    session.clock.sleep(0.1)
    assert panel.values["speed"] == 7


def test_a_refused_value_goes_back_with_the_nodes_reason(session, monkeypatch):
    panel = ParameterPanel("/robot")
    sent = heard_by_browser(panel, monkeypatch)
    says(panel, type="set", name="names", value="[]")
    session.clock.sleep(0.1)
    assert sent[0] == {"type": "refused", "name": "names", "reason": "names must not be empty"}
    assert next(row for row in sent[1]["rows"] if row["name"] == "names")["value"] == "[a, b]"


def test_what_is_not_a_number_does_not_reach_the_node(session, monkeypatch):
    panel = ParameterPanel("/robot")
    sent = heard_by_browser(panel, monkeypatch)
    says(panel, type="set", name="speed", value="fast")
    assert sent[0]["reason"] == "'fast' is no integer"


def test_a_node_that_does_not_exist_is_told_with_its_neighbour(session):
    with pytest.raises(LookupError, match="Did you mean /robot"):
        ParameterPanel("/robbot")
    assert open_panels() == []
