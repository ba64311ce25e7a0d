"""No judge takes NaN, infinities, liars, wrong types or endless things for an answer: below full marks, by Wrong alone."""

import math
import random
from pathlib import Path

import pytest

from coursekit.grade.checking import judge_work
from coursekit.grade.exercise import all_exercises
from coursekit.grade.plain import shown
from coursekit.grade.plan import Plan, Seen
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

from .junk import LyingFloat, LyingStr, containers, values

pytestmark = pytest.mark.timeout(120)

EXERCISES = all_exercises()
CALLS_A_FUNCTION = [
    "appb.q1", "appb.q2", "appb.q4", "appc.q1", "appc.q3", "ch02.q1", "ch03.q1", "ch06.q2", "ch07.q1",
    "ch08.q1", "ch08.q2", "ch08.q3", "ch08.q4", "ch09.q1", "ch09.q2", "ch09.q4",
]  # fmt: skip
READS_A_VARIABLE = [
    "appa.q1", "appa.q2", "appa.q3", "ch00.q1", "ch00.q2", "ch00.q3", "ch01.q1", "ch01.q2", "ch01.q3", "ch01.q4",
]  # fmt: skip
JUDGES_A_TRIAL = [
    "appa.q1", "appa.q2", "appb.q3", "ch00.q2", "ch01.q2", "ch01.q3", "ch01.q4", "ch02.q2", "ch02.q3", "ch02.q4", "ch03.q2",
    "ch03.q3", "ch03.q4", "ch04.q2", "ch04.q3", "ch04.q4", "ch05.q1", "ch05.q3", "ch05.q4", "ch06.q3", "ch07.q2", "ch07.q3",
    "ch07.q4", "ch09.q3", "ch02.q5", "ch03.q5", "ch04.q5", "ch05.q5", "ch06.q5",
]  # fmt: skip
JUDGES_A_FILE = ["appc.q2", "ch04.q1", "ch05.q2", "ch06.q1", "ch06.q4"]
GOOD = {
    "command": "topic echo /turtle1/pose --field x --once", "commands": ["node list", "service list", "topic list"],
    "presses": [("left", 1.57), ("up", 2.0)], "moves": [(0.0, 0.785, 1.0), (1.5, 0.0, 3.8)], "dance": [(1.0, 2.0, 1.8)],
}  # fmt: skip


def test_every_exercise_is_fed_with_junk():
    fed = {*CALLS_A_FUNCTION, *READS_A_VARIABLE, *JUDGES_A_TRIAL, *JUDGES_A_FILE}
    assert fed == set(EXERCISES)


class Fed(Work):
    """Work whose functions return, whose variables hold, and whose trials show what they are told to."""

    def __init__(self, *, answer=None, value=None, seen=None):
        super().__init__({}, Path("/nonexistent"))
        self._answer, self._value, self._seen = answer, value, seen

    def function(self, name):
        return lambda *_: self._answer() if callable(self._answer) else self._answer

    def value(self, name, kind):
        if self._value is None:
            return GOOD.get(name, {"holding": False} if kind is dict else kind())
        if type(self._value) is not kind:
            raise Wrong(f"`{name}` as a {kind.__name__}")
        return self._value

    def built(self, package, *of):
        return None

    compiled = built

    def message(self, path):
        from coursekit.interfaces.parser import parse

        return parse("s4_custom_interface", "msg", "Report", "int8 A=1\nint8 a 1\nfloat64[] b\nstring c\nint8 d\n")

    def text(self, path):
        return ""

    def exists(self, path):
        return True

    def installed(self, package, path):
        return True

    def try_out(self, *commands, **plan):
        for _, _, _, fields in plan.get("publish", ()):
            assert not any(isinstance(leaf, float) and not math.isfinite(leaf) for leaf in leaves(fields)), fields
        if self._seen is None:
            raise Wrong("a trial")
        kept = {key: value if key == "seconds" else list(value) for key, value in plan.items()}
        return self._seen(Plan(run=list(commands), **kept))


def leaves(value):
    """The plain values in a tree of dictionaries and lists."""
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else None
    return [value] if inner is None else [leaf for element in inner for leaf in leaves(element)]


def refused(name, work, told):
    """Judge, and demand a verdict below full marks that came from Wrong."""
    exercise = EXERCISES[name]
    with pytest.raises(Wrong) as caught:
        exercise.judge(work)
    assert 0 <= caught.value.share < 1, told
    verdict = judge_work(exercise, work)
    assert verdict.points < verdict.of or not (verdict.of or verdict.passed), told
    assert isinstance(verdict.text(), str) and isinstance(verdict.html(), str)


@pytest.mark.parametrize("name", CALLS_A_FUNCTION)
def test_no_function_s_answer_that_is_no_answer_is_taken(name):
    for value in values():
        refused(name, Fed(answer=value), shown(value))


@pytest.mark.parametrize("name", ["appb.q1", "appb.q2", "appb.q4", "ch03.q1"])
def test_no_message_whose_fields_are_no_numbers_is_taken(name):
    from geometry_msgs.msg import Pose, Pose2D, PoseArray
    from std_srvs.srv import SetBool

    for number in (math.nan, math.inf, LyingFloat(1.0)):
        pose, poses = Pose(), PoseArray()
        for part, names in ((pose.position, "xyz"), (pose.orientation, "xyzw")):
            for field in names:
                setattr(part, field, number)
        poses.poses = [pose] * 3
        flat, said = Pose2D(x=number, y=number, theta=number), SetBool.Response(success=True, message=LyingStr())
        for value in (pose, poses, flat, said):
            refused(name, Fed(answer=value), shown(number))


@pytest.mark.parametrize("name", CALLS_A_FUNCTION)
@pytest.mark.parametrize("error", [ZeroDivisionError("by 0"), RecursionError(), KeyError("x"), StopIteration(), OSError()])
def test_what_a_function_raises_is_told(name, error):
    def answer():
        raise error

    with pytest.raises(Wrong) as caught:
        EXERCISES[name].judge(Fed(answer=answer))
    assert type(error).__name__ in caught.value.got + caught.value.gave + caught.value.cause


def test_a_name_that_is_gone_after_a_restart_is_told_with_the_cure():
    def answer():
        return lost  # noqa: F821

    with pytest.raises(Wrong) as caught:
        EXERCISES["ch02.q1"].judge(Fed(answer=answer))
    assert "name 'lost' is not defined" in caught.value.got and "After a restart" in caught.value.cause


@pytest.mark.parametrize("name", READS_A_VARIABLE)
def test_no_variable_that_is_no_answer_is_taken(name):
    junk = [sample for sample in values() if sample.__class__.__hash__ is not None and not isinstance(sample, (tuple, list))]
    held = [*values(), *([sample] * 3 for sample in values()), *({1: sample, 2: sample, 3: sample} for sample in values())]
    for value in [*held, *({sample: sample} for sample in junk if type(sample).__name__ != "Unshowable")]:
        refused(name, Fed(value=value), shown(value))


class Every(list):
    """A list in which everything is."""

    def __contains__(self, one):
        return True


class Any_(dict):
    """A dictionary that has everything."""

    def __init__(self, value):
        super().__init__({"/any": value, "/vera/pose": value})
        self._value = value

    def __contains__(self, key):
        return True

    def __missing__(self, key):
        return self._value

    def get(self, key, default=None):
        return self._value


FLOATS = ("x", "y", "z", "w", "theta", "linear", "angular", "r", "g", "b")


def message(leaf):
    """A message with the fields that judges look at, all of them `leaf`."""
    vector, header = dict.fromkeys("xyzw", leaf), {"frame_id": leaf, "stamp": {"sec": leaf, "nanosec": leaf}}
    frame = {"header": header, "transform": {"translation": vector, "rotation": vector}}
    known = {"linear": vector, "angular": vector, "position": [leaf] * 4, "point": vector, "header": header, "data": leaf}
    known |= dict.fromkeys((*FLOATS[:5], "r", "g", "b", "sum", "success", "message", "task_stage", "sec"), leaf)
    known |= {"pose": {**vector, "theta": leaf, "pose": {"position": vector, "orientation": vector}}, "name": [leaf] * 4}
    known |= {"transforms": [frame] * 3, "values": [{"type": leaf, "integer_value": leaf}] * 2}
    known |= {"result": {"successful": leaf, "reason": leaf}}
    return known | {"descriptors": [{"floating_point_range": [{"from_value": leaf, "to_value": leaf}]}]}


LEAVES = [math.nan, math.inf, -math.inf, None, True, 10**400, "", "nan", [], {}, "base_link", -1]


def seen_with(messages, responses=None):
    """A trial in which all nodes, topics and services are there, and every message is one of these."""

    def seen(plan):
        topics = plan.record if plan.record != ["*"] else ["/one", "/two"]
        spoken = [(plan.seconds * k / 3000, messages[k % len(messages)]) for k in range(3000)]
        programs = len(plan.run) + len(plan.later)
        observed = Seen(outputs=[""] * programs, exit_codes=[0] * programs, beside=["asked for 1 and 2"] * len(plan.beside))
        observed.nodes, observed.topics, observed.services = (
            Every(),
            Any_(["std_srvs/srv/SetBool"]),
            Any_(["std_srvs/srv/SetBool"]),
        )
        observed.publishers, observed.subscriptions = Any_([{"node": "/x"}]), Any_([{"node": "/x"}])
        observed.messages = {topic: list(spoken) for topic in topics}
        observed.by_course = {topic: [True] * len(spoken) for topic in topics}
        observed.responses = [messages[0] if responses is None else responses] * len(plan.call)
        return observed

    return seen


@pytest.mark.parametrize("name", JUDGES_A_TRIAL)
@pytest.mark.parametrize("leaf", LEAVES, ids=lambda one: shown(one, 12))
def test_no_message_of_junk_is_taken(name, leaf):
    refused(name, Fed(seen=seen_with([message(leaf)])), leaf)


@pytest.mark.parametrize("name", JUDGES_A_TRIAL)
@pytest.mark.parametrize("messages", [[{}], [None], [[]], [""], [{"pose": None, "data": None}], [1.0]], ids=shown)
def test_no_message_without_its_fields_is_taken(name, messages):
    refused(name, Fed(seen=seen_with(messages)), messages)


@pytest.mark.parametrize("name", JUDGES_A_TRIAL)
def test_no_trial_in_which_nothing_was_seen_is_taken(name):
    refused(name, Fed(seen=lambda plan: Seen(responses=[None] * len(plan.call))), "nothing")


@pytest.mark.parametrize("name", ["ch05.q2", "ch04.q1"])
def test_no_file_of_junk_is_taken(name):
    for value in [*LEAVES, *containers()[:5]]:
        work, held = Fed(), {"camera.width": value, "use_sim_time": value}
        work.parameters = lambda path, nodes, held=held: dict.fromkeys(nodes, held)
        refused(name, work, shown(value))


def robots():
    """Robots with numbers that are none, where the reader would let them pass."""
    from coursekit.urdf import parse

    parts = '<link name="base_footprint"/><link name="base_link"/>'
    joint = '<joint name="base_joint" type="fixed"><origin xyz="{} 0 0"/>'
    joint += '<parent link="base_footprint"/><child link="base_link"/></joint>'
    for number in ("0", "1e308"):
        yield parse(f'<robot name="cart">{parts}{joint.format(number)}</robot>')


@pytest.mark.parametrize("name", ["ch06.q1", "ch06.q4", "appc.q2"])
def test_no_robot_without_a_body_is_taken(name):
    for robot in robots():
        work = Fed()
        work.robot = lambda path, robot=robot: robot
        refused(name, work, robot.name)


@pytest.mark.parametrize("seed", range(3))
def test_dice_that_fall_otherwise_do_not_help(seed):
    for name in CALLS_A_FUNCTION:
        work = Fed(answer=math.nan)
        work.dice = lambda of, seed=seed: random.Random(f"{seed} {of}")
        refused(name, work, name)
