"""rqt's windows in a notebook: a panel for each, which goes when the program ends."""

import pytest

from coursekit.lab import rqt_windows
from coursekit.lab.panel import open_panels
from coursekit.nodes.rqt.windows import RqtWindow

KINDS = {
    "rqt_graph": ["GraphPanel"], "rqt_console": ["LogConsole"], "rqt_plot": ["PlotPicture"],
    "rqt_publisher": ["MessagePublisher"],
    "rqt_gui": ["ServiceCaller", "TopicPanel", "MessagePublisher", "Reconfigure", "LogConsole", "GraphPanel", "FramesPanel"],
    "rqt_reconfigure": ["Reconfigure"], "rqt_robot_steering": ["Pad"], "rqt_service_caller": ["ServiceCaller"],
    "rqt_tf_tree": ["FramesPanel"], "rqt_topic": ["TopicPanel"],
}  # fmt: skip


@pytest.mark.parametrize("kind", KINDS)
def test_each_has_its_panels_until_it_ends(session, kind):
    window = RqtWindow(kind, session, "rqt_plot_1" if kind == "rqt_plot" else "", "/cmd_vel", (0.5, 1.0))
    rqt_windows._windows.show(window)
    session.clock.sleep(0.2)
    window_panel = rqt_windows._windows._panels[id(window)]
    shown = window_panel.children if kind == "rqt_gui" else (window_panel,)
    assert [type(panel).__name__ for panel in shown] == KINDS[kind]
    assert not [panel for panel in shown if panel.of_cell], "they stay when a cell is run again"
    rqt_windows._windows.forget(window)
    assert rqt_windows._windows._panels == {} and open_panels() == []


def test_on_the_virtual_clock_none_appears_and_it_is_drawn_all_the_same(session):
    session.embedded = True
    assert rqt_windows._windows.hear(RqtWindow("rqt_graph", session)) and open_panels() == []
    session.embedded = False
    assert not rqt_windows._windows.hear(RqtWindow("rqt_graph", session)), "a session without a notebook draws nothing"
