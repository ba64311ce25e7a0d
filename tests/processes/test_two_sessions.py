"""Two sessions in one interpreter, one after the other, print the same bytes: nothing is counted or kept beside them."""

from __future__ import annotations

import rclpy
from rclpy.executors import MultiThreadedExecutor
from std_msgs.msg import String
from turtlesim.srv import Spawn

from coursekit.nodes.turtlesim.simulators import simulators
from coursekit.processes.executables import find
from coursekit.processes.session import Session


def program() -> None:
    """Shows what is counted: endpoints' gids, requests, timers, threads, goals' numbers."""
    rclpy.init()
    node = rclpy.create_node("node")
    publisher = node.create_publisher(String, "t", 1)
    node.create_subscription(String, "t", lambda msg: print(msg.data), 1)
    for info in (*node.get_publishers_info_by_topic("/t"), *node.get_subscriptions_info_by_topic("/t")):
        print(info.endpoint_gid)
    client = node.create_client(Spawn, "spawn")
    client.wait_for_service()
    future = client.call_async(Spawn.Request(x=1.0, y=1.0))
    rclpy.spin_until_future_complete(node, future)
    print(future.result())

    import threading

    done = rclpy.Future()

    def tick() -> None:
        publisher.publish(String(data=threading.current_thread().name))
        done.set_result(None)

    timer = node.create_timer(0.1, tick)
    executor = MultiThreadedExecutor(2)
    executor.add_node(node)
    executor.spin_until_future_complete(done)
    timer.cancel()
    executor.spin_once(0.1)


def run() -> str:
    with Session(virtual=True).use() as session:
        sim = session.start_executable(find("turtlesim", "turtlesim_node"), name="turtlesim_node")
        process = session.start(program, name="p")
        assert process.wait(60) == 0, process.output
        assert len(simulators.running(session)) == 1
        return f"{sim.output}{process.output}"


def test_a_second_session_prints_what_the_first_one_did():
    first = run()
    assert "ThreadPoolExecutor-0_0" in first
    assert run() == first


def test_what_the_interpreter_s_own_code_left_open_does_not_meet_the_next_session():
    said = []
    for _ in range(2):
        with Session(virtual=True).use():
            rclpy.init(args=[])
            node = rclpy.create_node("left_open")
            said.append((node.get_logger().get_effective_level(), rclpy.get_global_executor().get_nodes()))
            rclpy.logging.set_logger_level("left_open", rclpy.logging.LoggingSeverity.DEBUG)
            node.create_publisher(String, "t", 1)
            said[-1] += (node.get_publishers_info_by_topic("/t")[0].endpoint_gid,)
    assert said[0] == said[1]
