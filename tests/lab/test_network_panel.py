"""The network's panel looks again once a second, however often the graph changes meanwhile."""

from coursekit.lab.network_panel import network_panel
from coursekit.processes.session import Session


def test_changes_of_the_graph_do_not_multiply_its_looks():
    with Session(virtual=True).use() as session:
        panel, sent = network_panel(), []
        panel.send = lambda message, *_: sent.append(message)
        panel._hear(panel, {"type": "ready"}, [])
        for _ in range(5):
            panel.changed()
            session.clock.sleep(0.3)
        sent.clear()
        session.clock.sleep(12.0)
        assert 9 <= len(sent) <= 11  # a second after each look, and 0.2 s until the browser is told
        panel.close()
