"""Twelve processes with a node each at 30 Hz that publish and listen: how much faster than time the virtual clock is."""

import time

from coursekit.processes.session import Session

_clock = time.perf_counter  # before the virtual clock takes its place


def main_of(number: int) -> None:
    """One program: a timer at 30 Hz, a publisher, a subscription to its neighbour."""
    import rclpy
    from geometry_msgs.msg import PoseStamped

    rclpy.init(args=[])
    node = rclpy.create_node(f"node_{number}")
    publisher = node.create_publisher(PoseStamped, f"pose_{number}", 10)
    node.create_subscription(PoseStamped, f"pose_{(number + 1) % 12}", lambda msg: None, 10)

    def step() -> None:
        msg = PoseStamped()
        msg.header.stamp = node.get_clock().now().to_msg()
        publisher.publish(msg)

    node.create_timer(1 / 30, step)
    rclpy.spin(node)


def seconds_for(virtual_seconds: float) -> float:
    """Real seconds that this much virtual time takes."""
    with Session(virtual=True).use() as session:
        for number in range(12):
            session.start(lambda number=number: main_of(number), name=f"node_{number}")
        session.clock.sleep(0.1)
        begun = _clock()
        session.clock.sleep(virtual_seconds)
        return _clock() - begun


if __name__ == "__main__":
    print(60 / seconds_for(60))
