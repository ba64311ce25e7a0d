"""How-To: synchronous calls are safe beside an executor, and never return from within its callbacks."""

import threading

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.node import Node

SUM = AddTwoInts.Request(a=41, b=1)


class Adder(Node):
    """Adds, in a process of its own."""

    def __init__(self):
        super().__init__("adder")
        self.create_service(AddTwoInts, "add", self.add)

    def add(self, request, response):
        response.sum = request.a + request.b
        return response


def serve():
    rclpy.init()
    try:
        rclpy.spin(Adder())
    except KeyboardInterrupt:
        pass


def call_beside_an_executor():
    rclpy.init()
    node = rclpy.create_node("sync")
    client = node.create_client(AddTwoInts, "add")
    client.wait_for_service()
    threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
    print("sum", client.call(SUM).sum)
    rclpy.shutdown()


def call_in_a_callback():
    rclpy.init()
    node = rclpy.create_node("stuck")
    client = node.create_client(AddTwoInts, "add")
    client.wait_for_service()

    def ring():
        print("asking")
        print("sum", client.call(SUM).sum)

    node.create_timer(0.1, ring)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass


def test_a_call_in_the_main_thread_and_one_in_a_callback(session):
    session.start(serve, name="serve")
    good = session.start(call_beside_an_executor, name="good")
    assert good.wait(5) == 0 and good.output == "sum 42\n"
    stuck = session.start(call_in_a_callback, name="stuck")
    session.clock.sleep(3.0)
    assert stuck.output == "asking\n" and stuck.exit_code is None
    stuck.interrupt()
    assert stuck.wait(5) is not None
