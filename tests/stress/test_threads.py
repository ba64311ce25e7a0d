"""Many threads, many processes: nothing is lost, reordered or left behind."""

import gc
import threading

import pytest
import rclpy
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.qos import HistoryPolicy, QoSProfile
from std_msgs.msg import Int64

from coursekit.processes.session import Session

PUBLISHERS, MESSAGES = 8, 125_000


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_eight_threads_publish_a_million_messages_and_none_is_lost_or_reordered():
    with Session().use():
        context = rclpy.context.Context()
        context.init([])
        keep_all = QoSProfile(history=HistoryPolicy.KEEP_ALL)
        senders = [rclpy.create_node(f"sender_{number}", context=context) for number in range(PUBLISHERS)]
        receiver = rclpy.create_node("receiver", context=context)
        got: list[list[int]] = [[] for _ in senders]
        for number in range(PUBLISHERS):
            receiver.create_subscription(
                Int64, f"t_{number}", lambda msg, seen=got[number]: seen.append(msg.data), keep_all
            )
        publishers = [node.create_publisher(Int64, f"t_{number}", keep_all) for number, node in enumerate(senders)]

        def send(publisher):
            msg = Int64()
            for value in range(MESSAGES):
                msg.data = value
                publisher.publish(msg)

        executor = SingleThreadedExecutor(context=context)
        executor.add_node(receiver)
        threads = [threading.Thread(target=send, args=(publisher,)) for publisher in publishers]
        for thread in threads:
            thread.start()
        while any(len(seen) < MESSAGES for seen in got):
            executor.spin_once(timeout_sec=5.0)
        for thread in threads:
            thread.join()
        context.shutdown()
    assert all(seen == list(range(MESSAGES)) for seen in got)


def test_one_topic_keeps_the_order_of_each_of_eight_publishers():
    with Session().use():
        context = rclpy.context.Context()
        context.init([])
        node = rclpy.create_node("node", context=context)
        keep_all = QoSProfile(history=HistoryPolicy.KEEP_ALL)
        got: list[int] = []
        node.create_subscription(Int64, "t", lambda msg: got.append(msg.data), keep_all)
        publishers = [node.create_publisher(Int64, "t", keep_all) for _ in range(PUBLISHERS)]
        executor = MultiThreadedExecutor(4, context=context)
        executor.add_node(node)

        def send(number):
            for value in range(1000):
                publishers[number].publish(Int64(data=number * 1000 + value))

        threads = [threading.Thread(target=send, args=(number,)) for number in range(PUBLISHERS)]
        for thread in threads:
            thread.start()
        while len(got) < PUBLISHERS * 1000:
            executor.spin_once(timeout_sec=5.0)
        executor.shutdown()
        context.shutdown()
    for number in range(PUBLISHERS):
        mine = [value for value in got if value // 1000 == number]
        assert mine == list(range(number * 1000, number * 1000 + 1000))


def spin_until_interrupted():
    rclpy.init(args=[])
    node = rclpy.create_node("node")
    node.create_timer(0.01, lambda: None)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass


def count_objects() -> int:
    gc.collect()
    return sum(
        issubclass(type(instance), rclpy.node.Node) for instance in gc.get_objects()
    )  # isinstance asks dead proxies too


@pytest.mark.parametrize("virtual", [True, pytest.param(False, marks=pytest.mark.slow)])
def test_a_thousand_processes_come_and_go_and_leave_nothing(virtual):
    before, nodes_before = threading.active_count(), count_objects()
    with Session(virtual=virtual).use() as session:
        for _ in range(50):
            started = [session.start(spin_until_interrupted, name="p") for _ in range(20)]
            session.clock.sleep(0.02)
            for process in started:
                process.interrupt()
            assert [process.wait(30) for process in started] == [0] * 20
        assert session.processes == [] and session.graph().nodes == [] and session.graph().publishers == {}
        del started, process
        assert count_objects() <= nodes_before
    assert threading.active_count() <= before + 1
