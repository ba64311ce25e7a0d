"""A node beside the ones under test."""

import rclpy
from geometry_msgs.msg import Twist

PATIENCE = 10.0
"""Timeout for a service and its response, on the virtual clock [s]."""


class Friend:
    """Publishes and subscribes, calls services, and lets time pass."""

    def __init__(self, session, name="friend"):
        self.session = session
        self.context = rclpy.context.Context()
        rclpy.init(context=self.context)
        self.node = rclpy.create_node(name, context=self.context)
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

    def spin(self, seconds=0.1):
        until = self.session.clock.steady() + round(seconds * 1e9)
        while (left := until - self.session.clock.steady()) > 0:
            self.executor.spin_once(timeout_sec=left * 1e-9)

    def go(self, seconds, forward, turn=0.0, topic="cmd_vel"):
        twist = Twist()
        twist.linear.x, twist.angular.z = forward, turn
        self.say(topic, twist)
        self.spin(seconds)

    def ask(self, kind, service, /, **request):
        client = self.node.create_client(kind, service)
        assert client.wait_for_service(timeout_sec=PATIENCE), service
        future = client.call_async(kind.Request(**request))
        self.executor.spin_until_future_complete(future, timeout_sec=PATIENCE)
        return future.result()
