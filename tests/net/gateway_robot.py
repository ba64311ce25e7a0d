"""The robot: a program for the real rclpy. It prints what happens, a line each."""

import os
import time

import rclpy
from geometry_msgs.msg import Twist
from rclpy.action import ActionServer
from rclpy.executors import MultiThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String
from std_srvs.srv import Trigger
from test_msgs.action import Fibonacci


def say(*words):
    print(*words, flush=True)


def main():
    rclpy.init()
    node = rclpy.create_node("robot", namespace="/r1")
    node.declare_parameter("speed", 1.5)
    latched = node.create_publisher(String, "/description", QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL))
    latched.publish(String(data="<robot/>"))
    scan = node.create_publisher(LaserScan, "/scan", qos_profile_sensor_data)
    both = node.create_publisher(String, "/both", 100)
    node.create_subscription(String, "/both", lambda msg: say("both", msg.data), 100)
    node.create_subscription(Twist, "/cmd_vel", lambda msg: say("velocity", msg.linear.x), 10)
    count = iter(range(10**9))
    node.create_timer(0.1, lambda: scan.publish(LaserScan(range_max=float(next(count)), ranges=[0.5] * 20)))
    client = node.create_client(Trigger, "/notebook_trigger")

    def command(msg):
        if msg.data == "call":
            client.call_async(Trigger.Request()).add_done_callback(lambda done: say("answer", done.result().message))
        elif msg.data == "publish":
            while both.get_subscription_count() < 2:  # its own, and the gateway's
                time.sleep(0.01)
            for number in range(20):
                both.publish(String(data=f"same {number % 2}"))
        elif msg.data == "who":
            say("nodes", *sorted(node.get_node_names()))

    node.create_subscription(String, "/command", command, 10)

    def trigger(_request, response):
        response.success, response.message = True, "done by the robot"
        return response

    node.create_service(Trigger, "/trigger", trigger)

    def act(goal):
        feedback = Fibonacci.Feedback()
        for number in range(goal.request.order):
            feedback.sequence = [*feedback.sequence, number]
            goal.publish_feedback(feedback)
        goal.succeed()
        return Fibonacci.Result(sequence=feedback.sequence)

    ActionServer(node, Fibonacci, "/fibonacci", act)
    executor = MultiThreadedExecutor(4)
    executor.add_node(node)
    say("ready")
    try:
        executor.spin()
    finally:
        os._exit(0)


if __name__ == "__main__":
    main()
