"""A node beside the programs that drive."""

import pytest
import rclpy


class Friend:
    """Says and hears topics, and lets time pass."""

    def __init__(self, session):
        self.session = session
        self.context = rclpy.context.Context()
        rclpy.init(context=self.context)
        self.node = rclpy.create_node("friend", context=self.context)
        self.executor = rclpy.executors.SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)
        self._out = {}

    def hear(self, kind, topic, qos=50):
        heard = []
        self.node.create_subscription(kind, topic, heard.append, qos)
        return heard

    def say(self, topic, msg):
        if topic not in self._out:
            self._out[topic] = self.node.create_publisher(type(msg), topic, 10)
        self._out[topic].publish(msg)

    def spin(self, seconds):
        until = self.session.clock.steady() + round(seconds * 1e9)
        while (left := until - self.session.clock.steady()) > 0:
            self.executor.spin_once(timeout_sec=left * 1e-9)

    def ask(self, kind, name, **request):
        client = self.node.create_client(kind, name)
        assert client.wait_for_service(timeout_sec=2.0)
        future = client.call_async(kind.Request(**request))
        self.executor.spin_until_future_complete(future, timeout_sec=2.0)
        return future.result()


@pytest.fixture
def friend(session):
    new_friend = Friend(session)
    yield new_friend
    rclpy.shutdown(context=new_friend.context)
