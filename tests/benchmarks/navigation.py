"""Random goals in the warehouse, among boxes that come and go, on the virtual clock: reached, and touched."""

import json
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2]))

_clock = time.perf_counter  # before the virtual clock takes its place
WAYS = {
    "cart_1": ((0.0, 1.1), (10.0, 1.1)),
    "cart_2": ((13.9, -1.0), (13.9, 7.0)),
    "cart_3": ((-0.5, 8.3), (10.5, 8.3)),
}
WARY = 0.7
"""Whoever pushes the boxes stops when the robot is so near in front [m]."""


def carts(stage, speed):
    """Boxes of half a metre that go to and fro."""
    from coursekit.geometry.plane import Pose2D
    from coursekit.sim import Prism
    from coursekit.sim.world import Thing
    from tests.nodes.nav2_stage import Mover

    square = ((-0.25, -0.25), (0.25, -0.25), (0.25, 0.25), (-0.25, 0.25))
    for name, ends in WAYS.items():
        stage.simulation.add(Thing(name, (Prism(square, 0.0, 0.6),), Pose2D(*ends[0], 0.0), mass=30.0))
        stage.movers.append(Mover(name, ends, speed, WARY))


def measure(goals, seed, speed=0.2, world="tec_warehouse"):
    """Drive to random goals; what came of it."""
    from nav2_msgs.action import NavigateToPose
    from rclpy.action import ActionClient

    from coursekit.geometry.plane import Pose2D
    from coursekit.processes.session import Session
    from tests.nodes.nav2_stage import Stage

    with tempfile.TemporaryDirectory() as folder, Session(virtual=True).use() as session:
        stage = Stage(session, Path(folder), world)
        if world == "tec_warehouse":
            carts(stage, speed)
        stage.tell_pose(Pose2D(*stage.robot.place))
        client = ActionClient(stage.node, NavigateToPose, "navigate_to_pose")
        client.wait_for_server(timeout_sec=5.0)
        begin, wall, reached, touches, missed = session.clock.steady(), _clock(), 0, [], []
        for goal in stage.free_places(0.45, goals, seed):
            stage.touched = {}
            handle = stage.until(client.send_goal_async(NavigateToPose.Goal(pose=stage.stamped(goal))))
            answer = stage.until(handle.get_result_async(), 400.0) if handle is not None and handle.accepted else None
            good = answer is not None and answer.status == 4 and stage.distance_to(goal) < 0.5
            reached += good
            touches += [f"{name} at {when:.1f} s" for name, when in stage.touched.items()]
            if not good:
                why = stage.launch.output[-1500:] if "-v" in sys.argv else ""
                place = [round(part, 2) for part in stage.robot.place]
                missed.append(f"({goal.x:.2f}, {goal.y:.2f}): status {answer and answer.status}, at {place} {why}")
            if "-v" in sys.argv:
                print(len(missed), reached, touches[-3:], "" if good else missed[-1], file=sys.stderr, flush=True)
        seconds = (session.clock.steady() - begin) * 1e-9
        stage.close()
        return {
            "goals": goals, "reached": reached, "collisions": len(touches), "touched": touches, "missed": missed,
            "minutes": seconds / 60, "speed": seconds / (_clock() - wall),
        }  # fmt: skip


if __name__ == "__main__":
    numbers = [int(argument) for argument in sys.argv[1:3]]
    worlds = [argument for argument in sys.argv[3:] if not argument.startswith("-")]
    print(json.dumps(measure(*(numbers or [100, 7]), **({"world": worlds[0]} if worlds else {}))))
