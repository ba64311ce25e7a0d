"""What a viewer of fifteen moving links at 30 Hz costs; prints JSON (CPU % of one core), the peer with its server."""

import json
import math
import resource
import sys
import threading
import time

LINKS, RATE, SECONDS = 15, 30, 6.0


def cpu(who: int = resource.RUSAGE_SELF) -> float:
    """CPU seconds used so far."""
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def share(step: object) -> float:
    """The CPU share [%] of calling `step(number)` thirty times a second, what it does in other threads included."""
    start, begin = cpu(), time.perf_counter()
    for number in range(round(SECONDS * RATE)):
        step(number)  # type: ignore[operator]
        time.sleep(max(0.0, begin + (number + 1) / RATE - time.perf_counter()))
    return (cpu() - start) / (time.perf_counter() - begin) * 100


def robot() -> str:
    """Boxes around a base, each on a joint."""
    text = '<robot name="many"><link name="l0"/>'
    for number in range(1, LINKS + 1):
        text += (
            f'<link name="l{number}"><visual><geometry><box size="0.1 0.1 0.1"/></geometry></visual></link>'
            f'<joint name="j{number}" type="continuous"><parent link="l0"/><child link="l{number}"/></joint>'
        )
    return text + "</robot>"


def ours() -> float:
    """A Viewer whose page acknowledges at once; reading /tf and packing included."""
    from geometry_msgs.msg import TransformStamped
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String
    from tf2_msgs.msg import TFMessage

    from coursekit.lab.panel_node import HiddenNode
    from coursekit.lab.viewer import viewer
    from coursekit.processes.session import Session

    with Session().use():
        node = HiddenNode("robot").node
        lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        node.create_publisher(String, "/robot_description", lasting).publish(String(data=robot()))
        tf = node.create_publisher(TFMessage, "/tf", 10)
        frames = [TransformStamped(child_frame_id=f"l{number}") for number in range(1, LINKS + 1)]

        def step(number: int) -> None:
            stamp = node.get_clock().now().to_msg()
            for index, msg in enumerate(frames):
                angle = 0.05 * number + index
                msg.header.frame_id, msg.header.stamp = "l0", stamp
                msg.transform.translation.x, msg.transform.translation.y = math.cos(angle), math.sin(angle)
            tf.publish(TFMessage(transforms=frames))

        step(0)
        panel = viewer(fixed_frame="l0", displays=["RobotModel"])
        sent = []

        def send(message: dict[str, object], buffers: object = None) -> None:
            sent.append(len(buffers[0]) if buffers else 0)  # type: ignore[index]
            if message["type"] == "scene":
                panel.on_drawn({"n": message["n"]})

        panel.send = send
        panel.on_open({})
        time.sleep(2.0)  # the first frame brings the shapes and imports what makes them
        used = share(step)
        frames_sent = sum(size >= LINKS * 88 for size in sent)
        assert frames_sent > SECONDS * RATE * 0.6, f"only {frames_sent} of {SECONDS * RATE:.0f} frames were sent"
        panel.close()
    return used


def peer() -> float | None:
    """meshcat-python with its own server, a process of its own on loopback, and a page that takes what comes."""
    try:
        import meshcat
        import numpy as np
        from tornado.websocket import websocket_connect
    except ImportError:
        return None
    try:
        shown = meshcat.Visualizer()
    except Exception:  # it starts a server, which may fail in as many ways as there are computers
        return None
    import asyncio

    async def page() -> None:
        socket = await websocket_connect(shown.url().replace("http", "ws").replace("/static/", ""))
        while await socket.read_message() is not None:
            pass

    threading.Thread(target=lambda: asyncio.run(page()), daemon=True).start()
    for index in range(LINKS):
        shown[f"l{index}"].set_object(meshcat.geometry.Box([0.1, 0.1, 0.1]))
    matrices = [np.eye(4) for _ in range(LINKS)]

    def step(number: int) -> None:
        for index, matrix in enumerate(matrices):
            matrix[:2, 3] = math.cos(0.05 * number + index), math.sin(0.05 * number + index)
            shown[f"l{index}"].set_transform(matrix)

    process = shown.window.server_proc
    before = server_seconds(process.pid)
    begin = time.perf_counter()
    used = share(step)
    server = (server_seconds(process.pid) - before) / (time.perf_counter() - begin) * 100
    process.kill()
    process.wait()
    return used + server


def server_seconds(pid: int) -> float:
    """CPU seconds of a process so far (Linux)."""
    import os

    with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


if __name__ == "__main__":
    print(json.dumps(ours() if sys.argv[1:] == ["ours"] else peer()))
