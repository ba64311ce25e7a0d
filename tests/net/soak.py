"""`python -m tests.net.soak [MINUTES]`: an image at 30 Hz and a topic at 1 kHz through a router, from process to process.

Nothing may grow: it fails when a process holds more at the end than after the first minute, by more than GROWTH_MB.
"""

from __future__ import annotations

import array
import os
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

import psutil
import rclpy
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image
from std_msgs.msg import String

WARM_SECONDS = 60.0
"""By then each has what it needs [s]."""
GROWTH_MB = 5.0
WIDTH, HEIGHT = 640, 480
KINDS = {"image": (Image, 30.0, qos_profile_sensor_data), "string": (String, 1000.0, 10)}
"""Of each topic its type, messages a second, and quality of service."""


def say() -> None:
    """Publish both until this process is ended."""
    node = rclpy.create_node("mouth")
    picture = Image(
        height=HEIGHT, width=WIDTH, encoding="bgr8", step=3 * WIDTH, data=array.array("B", bytes(3 * WIDTH * HEIGHT))
    )
    messages = {"image": picture, "string": String(data="x" * 20)}
    for name, (kind, rate, quality) in KINDS.items():
        publisher = node.create_publisher(kind, name, quality)
        node.create_timer(1 / rate, lambda publisher=publisher, name=name: publisher.publish(messages[name]))
    rclpy.spin(node)


def hear() -> None:
    """Count both, and say each second how many there were."""
    node, counts = rclpy.create_node("ears"), dict.fromkeys(KINDS, 0)

    def count(name: str) -> None:
        counts[name] += 1

    for name, (kind, _, quality) in KINDS.items():
        node.create_subscription(kind, name, lambda _msg, name=name: count(name), quality)
    node.create_timer(1.0, lambda: print(*counts.values(), flush=True))
    rclpy.spin(node)


def watch(minutes: float) -> int:
    """Start both, and look at what they and the router hold; the exit code."""
    from coursekit.net.zenoh_session import open_router
    from coursekit.systems.ports import free_port

    address = f"tcp/127.0.0.1:{free_port()}"
    router = open_router([address])
    env = dict(os.environ, COURSEKIT_NETWORK=address, COURSEKIT_ALONE="1", ROS_DOMAIN_ID="45")
    words = [sys.executable, "-m", "tests.net.soak"]
    ears = subprocess.Popen([*words, "hear"], env=env, stdout=subprocess.PIPE, text=True, cwd=Path(__file__).parents[2])
    mouth = subprocess.Popen([*words, "say"], env=env, cwd=Path(__file__).parents[2])
    try:
        return report({"router": os.getpid(), "says": mouth.pid, "hears": ears.pid}, ears, minutes * 60.0)
    finally:
        for child in (mouth, ears):
            child.kill()
            child.wait()
        router.close()


def report(pids: dict[str, int], ears: subprocess.Popen[str], seconds: float) -> int:
    """Print what each process holds, once a minute, until the time is over; 1 when one of them has grown."""
    begin, warm, now, minute = time.monotonic(), {}, {}, 0
    for line in ears.stdout or ():
        passed = time.monotonic() - begin
        if passed // 60 > minute or passed >= seconds:
            minute = int(passed // 60)
            now = {name: psutil.Process(pid).memory_info().rss / 1e6 for name, pid in pids.items()}
            warm = warm or (now if passed >= WARM_SECONDS else {})
            held = ", ".join(f"{name} {size:.1f} MB" for name, size in now.items())
            print(f"{passed / 60:5.1f} min: heard {line.strip()}; {held}", flush=True)
        if passed >= seconds:
            break
    grown = {name: now[name] - warm[name] for name in warm if now[name] - warm[name] > GROWTH_MB}
    print(f"grown: {grown}" if grown else "flat" if warm else "too short to tell")
    return 1 if grown or not warm else 0


def main(words: Sequence[str]) -> int:
    """Be one of the processes, or watch them."""
    if words and words[0] in ("say", "hear"):
        rclpy.init(args=[])
        say() if words[0] == "say" else hear()
        return 0
    return watch(float(words[0]) if words else 30.0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
