"""Chapter 7."""

_SEEN = "import math\n\ndef seen(me, other):\n    {lines}"
_STAGES = """%%write src/s7_py_client_robot/s7_py_client_robot/stages.py
import math

def next_step(x, y, theta, stage, pickup, delivery):
    goal_x, goal_y, yaw = {goal}
    far = math.hypot(goal_x - x, goal_y - y)
    if stage in (1, 4):
        part = {part}
        return x + part * (goal_x - x), y + part * (goal_y - y), theta, stage + ({there})
    if stage in (0, 3):
        yaw = math.atan2(goal_y - y, goal_x - x)
    rest = {rest}
    if abs(rest) <= math.radians(1):
        return x, y, {end}, stage + 1
    return x, y, theta + math.copysign({turn}, rest), stage
"""
_WATCH = """%%write src/s7_py_robot_task_monitoring/s7_py_robot_task_monitoring/watch.py
class Watch:
    def __init__(self):
        self.stage, self.silent = {first}, 0

    def hear(self, stage):
        self.stage = stage
        {heard}

    def cycle(self):
        self.silent += 1
        {answer}
"""
_CHOICE = (
    "%%write src/s7_py_task_manager/s7_py_task_manager/choice.py\nimport math\nfrom geometry_msgs.msg import Pose2D\n\n"
)
_CHOICE += "def choose(start, others, draw):\n    {lines}\n"
_PART, _REST = "min(1.0, 0.01 / max(far, 1e-9))", "math.remainder(yaw - theta, 2 * math.pi)"


def _stages(
    *,
    goal="pickup if stage < 3 else delivery",
    part=_PART,
    there="part == 1.0",
    rest=_REST,
    end="yaw",
    turn="math.radians(1)",
):
    return _STAGES.format(goal=goal, part=part, there=there, rest=rest, end=end, turn=turn)


def _watch(*, first="8", heard="self.silent = 0", answer="return 7 if self.silent > 29 and self.stage != 8 else self.stage"):
    return _WATCH.format(first=first, heard=heard, answer=answer)


WRONG = {
    "ch07.q1": [
        _SEEN.format(lines="return tuple(b - a for a, b in zip(me, other))"),
        _SEEN.format(
            lines="c, s = math.cos(me[2]), math.sin(me[2])\n    x, y = other[0] - me[0], other[1] - me[1]\n"
            "    return c * x - s * y, s * x + c * y, other[2] - me[2]"
        ),
        _SEEN.format(
            lines="c, s = math.cos(me[2]), math.sin(me[2])\n    x, y = other[0] - me[0], other[1] - me[1]\n"
            "    return c * x + s * y, c * y - s * x, other[2] - me[2]"
        ),
        _SEEN.format(lines="return 0"),
        _SEEN.format(lines="return math.nan, math.nan, math.nan"),
        _SEEN.format(lines="return [math.inf] * 3"),
    ],
    "ch07.q2": [
        _stages(goal="pickup"),
        _stages(rest="yaw - theta"),
        _stages(part="0.01 / far", there="far < 0.01"),
        _stages(end="theta"),
        _stages(turn="0.1"),
        _stages(part="1.0"),
        _stages(goal="pikcup"),
    ],
    "ch07.q3": [
        _watch(answer="return 7 if self.silent > 30 else self.stage"),
        _watch(answer="return self.stage"),
        _watch(answer="return 7 if self.silent > 30 and self.stage != 8 else self.stage"),
        _watch(answer="return 7 if self.silent >= 29 and self.stage != 8 else self.stage"),
        _watch(heard="pass"),
        _watch(answer="return 7 if self.silent > 3 and self.stage != 8 else self.stage"),
        _watch(answer="return 7 if self.silent > 30 and self.stage != 8 else self.stage or 8"),
    ],
    "ch07.q4": [
        _CHOICE.format(lines="return draw(), draw()"),
        _CHOICE.format(lines="return Pose2D(x=start[0], y=start[1]), Pose2D(x=start[0], y=start[1])"),
        _CHOICE.format(
            lines="for _ in range(300):\n        two = draw(), draw()\n"
            "        if all(math.dist((one.x, one.y), p) > 0.6 for one in two for path in others for p in path):\n"
            "            return two\n    return two"
        ),
        _CHOICE.format(lines="return drow(), draw()"),
    ],
}
