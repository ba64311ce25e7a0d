import pytest
import rclpy
from example_interfaces.srv import AddTwoInts
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

from coursekit.core.names import is_hidden
from coursekit.core.session import Session
from coursekit.lab.graph_panel import GraphPanel, graph
from coursekit.lab.log_console import LogConsole
from coursekit.lab.messages import echo
from coursekit.lab.panel import close_panels, open_panels
from coursekit.lab.parameter_panel import ParameterPanel
from coursekit.lab.service_panel import ServiceCaller
from coursekit.lab.topic_panel import TopicPanel


class Robot(Node):
    """Publishes, serves, logs and has parameters."""

    def __init__(self):
        super().__init__("robot")
        self.count = 0
        self.publisher = self.create_publisher(String, "news", 10)
        self.create_timer(0.5, self.publish)
        self.create_service(AddTwoInts, "add", self.add)
        limits = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10, step=1)])
        self.declare_parameter("speed", 3, limits)
        self.declare_parameter("names", ["a", "b"])
        self.declare_parameter("serial", "X1", ParameterDescriptor(read_only=True))
        self.add_on_set_parameters_callback(self.judge)

    def publish(self):
        self.count += 1
        self.publisher.publish(String(data=f"news {self.count}"))
        self.get_logger().info(f"sent {self.count}")
        if self.count == 2:
            self.get_logger().warning("two is enough")

    def add(self, request, response):
        response.sum = request.a + request.b
        return response

    def judge(self, parameters):
        bad = any(one.name == "names" and not one.value for one in parameters)
        return SetParametersResult(successful=not bad, reason="names must not be empty" if bad else "")


def main():
    rclpy.init()
    try:
        rclpy.spin(Robot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


@pytest.fixture
def session():
    with Session(virtual=True).use() as made:
        made.start(main, name="robot")
        made.clock.sleep(0.1)
        yield made
        close_panels()


def heard_by_browser(panel, monkeypatch):
    """What the panel sends from now on."""
    sent = []
    monkeypatch.setattr(panel, "send", lambda message, buffers=None: sent.append(message))
    return sent


def says(panel, **message):
    panel._hear(panel, message, [])


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


# -- the parameter panel


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


# -- the log


def test_the_log_counts_levels_and_filters(session):
    console = LogConsole()
    session.clock.sleep(1.6)
    assert console.text().splitlines()[0] == "log: 3 INFO, 1 WARN"
    console.filter(level="WARN")
    assert console.lines() == ["[WARN] [robot]: two is enough"]
    console.filter(level="DEBUG", text="SENT 3")
    assert console.lines() == ["[INFO] [robot]: sent 3"]
    console.filter(text="", node="nobody")
    assert console.lines() == []


def test_a_paused_log_stands_still_but_forgets_nothing(session):
    console = LogConsole()
    session.clock.sleep(0.6)
    console.pause()
    session.clock.sleep(2.0)
    assert len(console.lines()) == 1
    console.pause(False)
    assert len(console.lines()) > 4


def test_a_late_log_is_in_the_order_of_time(session):
    session.clock.sleep(2.0)
    assert [line.rpartition(" ")[2] for line in LogConsole().lines()] == []
    console = LogConsole()
    session.clock.sleep(0.1)
    assert console.lines()[0].endswith("sent 1")


def test_the_log_is_filtered_from_the_browser(session, monkeypatch):
    console = LogConsole()
    session.clock.sleep(1.6)
    sent = heard_by_browser(console, monkeypatch)
    says(console, type="ready")
    says(console, type="filter", level="WARN")
    assert [len(message["lines"]) for message in sent] == [4, 1]
    assert sent[1]["counts"]["INFO"] == 3 and sent[1]["lines"][0]["time"] == "22:13:21.000"


def test_a_level_that_does_not_exist_names_those_that_do(session):
    with pytest.raises(ValueError, match="DEBUG, INFO, WARN"):
        LogConsole("LOUD")


# -- the graph


def test_a_still_graph_is_a_picture_and_a_live_one_a_panel(session):
    assert (
        graph().text() == "graph: 1 node, 1 topic\nnodes: /robot\ntopic /news [std_msgs/msg/String]: /robot -> (nobody)"
    )
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
    made = [TopicPanel("/news"), ServiceCaller(), ParameterPanel("/robot"), LogConsole(), graph(live=True)]
    ours = [node.full_name for node in session.graph().nodes if is_hidden(node.full_name)]
    assert len(ours) == 4
    assert close_panels() == len(made)
    assert [node.full_name for node in session.graph().nodes] == ["/robot"]
    assert session.graph()._watchers == []


def test_the_text_of_a_panel_is_what_a_notebook_stores(session):
    panel = TopicPanel()
    data = panel._repr_mimebundle_()
    data = data[0] if isinstance(data, tuple) else data
    assert data["text/plain"] == panel.text()


@pytest.mark.parametrize("name", ["viewer", "joints", "topics", "log"])
def test_a_panels_own_style_wins_over_the_shared_one_of_a_panel_that_opens_later(name):
    from coursekit.lab.panel import _STATIC, static

    shared = (_STATIC / "panel.css").read_text(encoding="utf-8")
    own = static(f"{name}.css").removeprefix(shared)
    assert f".ck-panel.ck-{name} " in own and f"\n.ck-{name} " not in own
