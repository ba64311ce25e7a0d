"""The window of rqt_reconfigure: it lists the nodes, and shows the parameters of the one that is chosen."""

import rclpy
from rclpy.node import Node

from coursekit.lab.panel import open_panels
from coursekit.lab.reconfigure import Reconfigure


def spinning(session, *names):
    if not rclpy.ok():
        rclpy.init()
    nodes = [Node(name) for name in names]
    for node in nodes:
        node.declare_parameter(f"of_{node.get_name()}", 1.0)
        session.spawn(rclpy.spin, node, rclpy.executors.SingleThreadedExecutor())
    session.clock.sleep(0.5)
    return nodes


def shown(window):
    return [list(panel.values) for panel in window.children[1:]]


def test_a_node_is_chosen_and_its_parameters_are_shown(session):
    spinning(session, "arm", "base")
    window = Reconfigure()
    session.clock.sleep(0.5)
    assert window.nodes == ["/arm", "/base"] and "of_arm" in shown(window)[0]
    window.choose("/base")
    session.clock.sleep(0.5)
    assert "of_base" in shown(window)[0] and len(open_panels()) == 1
    window.close()
    assert open_panels() == []
    rclpy.shutdown()


def test_nodes_come_and_go_while_it_is_open(session):
    window = Reconfigure()
    assert window.nodes == [] and shown(window) == []
    arm, base = spinning(session, "arm", "base")
    session.clock.sleep(0.5)
    assert window.nodes == ["/arm", "/base"] and "of_arm" in shown(window)[0]
    [aaa] = spinning(session, "aaa")
    assert window.nodes == ["/aaa", "/arm", "/base"] and "of_arm" in shown(window)[0], "the choice stays"
    aaa.destroy_node()
    arm.destroy_node()
    session.clock.sleep(0.5)
    assert window.nodes == ["/base"] and "of_base" in shown(window)[0]
    base.destroy_node()
    session.clock.sleep(0.5)
    assert window.nodes == [] and shown(window) == [] and open_panels() == []
    window.close()
    rclpy.shutdown()


def test_a_window_that_is_closed_while_a_node_is_asked_leaves_no_panel(session):
    spinning(session, "arm")
    Reconfigure().close()
    session.clock.sleep(1.0)
    assert open_panels() == []
    rclpy.shutdown()


def test_a_node_that_does_not_answer_is_told(session):
    rclpy.init()
    Node("asleep")
    window = Reconfigure()
    session.clock.sleep(8.0)
    assert "No answer within 5 s. Does the node that should answer spin?" in window.children[1].value
    window.close()
    rclpy.shutdown()
