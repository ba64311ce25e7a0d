"""Lookups in chains of frames that all move, by ours and by C++ tf2 (Debian's python3-tf2); prints JSON, microseconds.

`latest` asks for the newest time after new data has come, `again` asks once more, `between` asks for a time at which every
edge is interpolated, again and again between the same samples, as who transforms a scan's points does; `once` asks each time
between other samples.
"""

import itertools
import json
import random
import subprocess
import sys
import timeit
from pathlib import Path

from geometry_msgs.msg import TransformStamped
from rclpy.time import Time
from tf2_ros import Buffer

sys.path.insert(0, str(Path(__file__).parents[2]))  # this runs as a script, from elsewhere
from tests.tf.trees import S, random_pose

CPP = Path(__file__).parents[1] / "tf" / "cpp_tf2.py"
COUNT = 3000


def chain(depth: int) -> list[tuple[str, str, int, tuple[float, ...], bool]]:
    """Three seconds at 30 Hz of a chain of moving frames."""
    dice = random.Random(depth)
    return [
        (f"f{place}", f"f{place + 1}", tick * S // 30, random_pose(dice), False)
        for tick in range(1, 91)
        for place in range(depth)
    ]


def stamped(parent: str, child: str, stamp: int, pose: tuple[float, ...], _static: bool) -> TransformStamped:
    """The message."""
    msg = TransformStamped(child_frame_id=child)
    msg.header.frame_id, msg.header.stamp = parent, Time(nanoseconds=stamp).to_msg()
    t, r = msg.transform.translation, msg.transform.rotation
    t.x, t.y, t.z, r.x, r.y, r.z, r.w = pose
    return msg


def best(function) -> float:  # type: ignore[no-untyped-def]
    """The fastest of five runs, per call."""
    return min(timeit.repeat(function, number=COUNT, repeat=5)) / COUNT * 1e6


def ours(depth: int) -> dict[str, float]:
    """Our three times."""
    buffer = Buffer()
    for data in chain(depth):
        buffer.set_transform(stamped(*data), "bench")
    target, source = "f0", f"f{depth}"
    newest, middle = Time(), Time(nanoseconds=2 * S + 1000)
    elsewhere = itertools.cycle([Time(nanoseconds=tick * S // 30 + 1000) for tick in range(1, 90)])
    frames = buffer._frames

    def fresh(time: Time) -> None:
        frames.version += 1  # as new data would
        buffer.lookup_transform(target, source, time)

    return {
        "latest": best(lambda: fresh(newest)),
        "again": best(lambda: buffer.lookup_transform(target, source, newest)),
        "between": best(lambda: fresh(middle)),
        "once": best(lambda: fresh(next(elsewhere))),
    }


def theirs(depth: int) -> dict[str, float] | None:
    """The times of the C++ library; None where it is not installed."""
    questions = [("f0", f"f{depth}", 0), ("f0", f"f{depth}", 2 * S + 1000)]
    job = json.dumps({"data": chain(depth), "questions": questions})
    try:
        done = subprocess.run(
            ["/usr/bin/python3", str(CPP), "time"], input=job, capture_output=True, encoding="utf-8", env={}, cwd="/"
        )
    except OSError:
        return None
    if done.returncode:
        return None
    latest, between = json.loads(done.stdout)
    return {"latest": latest, "again": latest, "between": between, "once": between}


if __name__ == "__main__":
    print(json.dumps({depth: {"ours": ours(depth), "peer": theirs(depth)} for depth in (5, 15)}))
