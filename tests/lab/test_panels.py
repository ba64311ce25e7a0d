"""Panels of topics, services and the graph, and what holds for all."""

import pytest
import rclpy
from std_msgs.msg import String

from coursekit.lab.graph_panel import GraphPanel, graph
from coursekit.lab.log_console import LogConsole
from coursekit.lab.messages import echo
from coursekit.lab.panel import end_panels, open_panels
from coursekit.lab.parameter_panel import ParameterPanel
from coursekit.lab.service_panel import ServiceCaller
from coursekit.lab.topic_panel import TopicPanel
from coursekit.rcl.names import is_hidden
from tests.lab.panel_robot import heard_by_browser, robot_running, says


@pytest.fixture
def session():
    with robot_running() as virtual_session:
        yield virtual_session


# -- the topic panel


def test_a_watched_topic_shows_rate_and_last_message(session):
    panel = TopicPanel("news")
    session.clock.sleep(3.0)
    assert panel.rate("/news") == pytest.approx(2.0)
    assert panel.last("news").data == "news 6"
    assert panel.text().splitlines() == ["topics: 1", "/news [std_msgs/msg/String] 1 -> 0  2.00 Hz", "    data: news 6"]


def test_a_topic_that_falls_silent_has_no_rate(session):
    panel = TopicPanel("/news")
    session.clock.sleep(2.0)
    session.processes[0].interrupt()
    session.clock.sleep(4.0)
    assert panel.rate("/news") == 0.0


def test_a_panel_is_not_counted_among_the_subscribers(session):
    panel = TopicPanel("/news")
    assert panel.shown()["rows"][0]["subscribers"] == 0


def test_a_topic_that_does_not_exist_is_told_with_its_neighbour_and_leaves_no_panel(session):
    with pytest.raises(LookupError, match="Did you mean /news"):
        TopicPanel("/new")
    assert open_panels() == []


def test_a_tick_in_the_browser_watches(session):
    panel = TopicPanel()
    says(panel, type="watch", name="/news", on=True)
    session.clock.sleep(1.2)
    assert panel.shown()["rows"][0]["count"] == 2
    says(panel, type="watch", name="/news", on=False)
    assert panel.shown()["rows"][0]["watched"] is False


def test_the_browser_hears_at_most_five_times_a_second(session, monkeypatch):
    panel = TopicPanel("/news")
    sent = heard_by_browser(panel, monkeypatch)
    says(panel, type="ready")
    for _ in range(1000):
        session.clock.sleep(0.001)
        panel.changed()
    assert 1 < len(sent) <= 6


def test_nothing_is_sent_while_no_browser_looks(session, monkeypatch):
    panel = TopicPanel("/news")
    sent = heard_by_browser(panel, monkeypatch)
    session.clock.sleep(3.0)
    assert sent == []


def test_echo_prints_the_next_messages(session, capsys):
    echo("news", n=2)
    assert capsys.readouterr().out == "data: news 1\n---\ndata: news 2\n---\n"


def test_echo_of_a_silent_topic_ends_with_advice(session):
    session.processes[0].interrupt()
    rclpy.init()
    node = rclpy.create_node("silent")
    node.create_publisher(String, "silence", 1)
    with pytest.raises(TimeoutError, match="0 of 1 messages"):
        echo("/silence", timeout_sec=1.0)
    node.destroy_node()
    rclpy.shutdown()


# -- the service caller


def test_a_service_is_called_from_code(session):
    caller = ServiceCaller()
    assert caller.call("add", a=2, b=3).sum == 5
    assert caller.text().splitlines()[-2:] == ["called: /add(a=2, b=3)", "    sum: 5"]


def test_the_form_of_a_service_is_filled_in_and_answered(session, monkeypatch):
    caller = ServiceCaller()
    assert [field["control"] for field in caller.shown()["fields"]] == ["whole", "whole"]
    sent = heard_by_browser(caller, monkeypatch)
    says(caller, type="call", name="/add", fields={"a": "20", "b": "22"})
    session.clock.sleep(0.1)
    assert sent[-1]["ok"] and sent[-1]["text"] == "sum: 42"


def test_a_field_that_does_not_fit_is_named(session, monkeypatch):
    caller = ServiceCaller()
    sent = heard_by_browser(caller, monkeypatch)
    says(caller, type="call", name="/add", fields={"a": "two", "b": "1"})
    assert sent == [{"type": "answer", "ok": False, "text": "a: 'two' is not a whole number"}]
    with pytest.raises(ValueError, match="no field 'c'. There are: a, b"):
        caller.call("/add", c=1)


def test_a_service_that_nobody_serves_is_told(session):
    with pytest.raises(LookupError, match="Did you mean /add"):
        ServiceCaller().call("/ad", a=1)


# -- the graph


def test_a_still_graph_is_a_picture_and_a_live_one_a_panel(session):
    assert graph().text() == "graph: 1 node, 1 topic\nnodes: /robot\ntopic /news [std_msgs/msg/String]: /robot -> (nobody)"
    assert isinstance(graph(live=True), GraphPanel)


def test_a_live_graph_follows_what_happens(session, monkeypatch):
    panel = graph("nodes", live=True)
    sent = heard_by_browser(panel, monkeypatch)
    says(panel, type="ready")
    session.processes[0].interrupt()
    session.clock.sleep(1.0)
    assert "/robot" in sent[0]["svg"] and "/robot" not in sent[-1]["svg"]


def test_a_click_shows_details(session, monkeypatch):
    panel = graph(live=True)
    sent = heard_by_browser(panel, monkeypatch)
    says(panel, type="choose", name="/news")
    assert "Publisher count: 1" in sent[-1]["details"]


def test_an_unknown_option_names_those_there_are(session):
    with pytest.raises(TypeError, match="no option 'colour'"):
        graph(colour=True)


# -- all of them


def test_panels_are_hidden_and_leave_nothing_behind(session):
    panels = [TopicPanel("/news"), ServiceCaller(), ParameterPanel("/robot"), LogConsole(), graph(live=True)]
    ours = [node.full_name for node in session.graph().nodes if is_hidden(node.full_name)]
    assert len(ours) == 4
    assert end_panels() == len(panels)
    assert [node.full_name for node in session.graph().nodes] == ["/robot"]
    assert session.graph()._watchers == []


def test_the_text_of_a_panel_is_what_a_notebook_stores(session):
    panel = TopicPanel()
    data = panel._repr_mimebundle_()
    data = data[0] if isinstance(data, tuple) else data
    assert data["text/plain"] == panel.text()


@pytest.mark.parametrize("name", ["viewer", "joints", "topics", "log"])
def test_a_panels_own_style_wins_over_the_shared_one_of_a_panel_that_opens_later(name):
    from coursekit.lab.panel import static
    from coursekit.lab.script import _STATIC

    shared = (_STATIC / "panel.css").read_text(encoding="utf-8")
    own = static(f"{name}.css").removeprefix(shared)
    assert f".ck-panel.ck-{name} " in own and f"\n.ck-{name} " not in own
