"""The first mistakes with `self`, callbacks and futures: the advice names what to write."""

import pytest

from coursekit.grade.exception_advice import DIED, cause_of

MAKES = 'self.subscription = self.create_subscription(String, "words",'
SAID = {
    f"NameError: name 'heard' is not defined (line 8 of ear.py: {MAKES} heard, 10))": "`self.heard`",
    "NameError: name 'create_timer' is not defined (line 8 of ear.py: create_timer(0.5, self.speak))": "`self.create_timer`",
    "NameError: name 'get_logger' is not defined (line 8 of ear.py: get_logger().info(text))": "`self.get_logger`",
    f"NameError: name 'Int32' is not defined (line 8 of ear.py: {MAKES.replace('String', 'Int32')} self.heard, 10))": (
        "`Int32` is not imported"
    ),
    f"TypeError: Ear.heard() missing 1 required positional argument: 'msg' (line 8 of ear.py: {MAKES} self.heard(), 10))": (
        "without brackets: `self.heard`"
    ),
    "TypeError: Node.create_subscription() missing 1 required positional argument: 'qos_profile' "
    f"(line 8 of ear.py: {MAKES} self.heard))": "for example 10",
    "AttributeError: 'Future' object has no attribute 'sum' (line 11 of gate.py: self.client.call_async(ab).sum)": "`await`",
    "AttributeError: 'NoneType' object has no attribute 'to_label' (line 30 of camera.py: rclpy.spin(node))": (
        "`return TransitionCallbackReturn.SUCCESS`"
    ),
    "ValueError: invalid literal for int() with base 10: '/ws/install/p/lib/p/client_exe' (line 8 of main.py: a, b = "
    "map(int, sys.argv))": "sys.argv[1]",
    "AttributeError: module 's4_py_apps.ear' has no attribute 'Ear' (line 8 of mains.py: run(module.Ear))": (
        "`ear` defines no `Ear`"
    ),
    "TypeError: work() missing 1 required positional argument: 'goal_handle'": "leave `self` out",
    "TypeError: work() missing 1 required positional argument: 'goal_handle' (line 9 of running.py: rclpy.spin(node))": (
        "leave `self` out"
    ),
    "TypeError: 'NoneType' object is not callable (line 9 of running.py: rclpy.spin(node))": "without brackets: `self.tick`",
    "TypeError: Clock.tick() missing 1 required positional argument: 'msg' (line 9 of running.py: rclpy.spin(node))": (
        "`def tick(self):`"
    ),
    "TypeError: Ear.heard() missing 1 required positional argument: 'extra' (line 9 of ear.py: rclpy.spin_once(node))": (
        "a subscription's with `def heard(self, msg):`"
    ),
    "TypeError: Clock.tick() missing 1 required positional argument: 'self' (line 9 of running.py: rclpy.spin(node))": (
        "give the callback as `self.tick`"
    ),
    "TypeError: tick() missing 1 required positional argument: 'self' (line 9 of running.py: rclpy.spin(node))": (
        "leave `self` out"
    ),
    "TypeError: tick() missing 1 required positional argument: 'msg' (line 9 of running.py: rclpy.spin(node))": (
        "a timer's begins with `def tick():`"
    ),
    "TypeError: Gate.add() takes 2 positional arguments but 3 were given (line 9 of running.py: rclpy.spin(node))": (
        "`def add(self, request, response):`"
    ),
    "TypeError: Expected <class 'std_msgs.msg._string.String'>, got <class 'NoneType'> (line 13 of a.py: publish(made()))": (
        "does the function that makes it end with `return`?"
    ),
    "TypeError: 'bool' object is not callable (line 6 of fetching.py: if goal_handle.is_cancel_requested():)": (
        "a value and no function: leave the brackets out"
    ),
    "TypeError: 'float' object is not callable (line 6 of a.py: print(self.level()))": "leave the brackets out",
    "TypeError: 'str' object is not callable (line 6 of a.py: number = str(5))": "no variable the name of a function",
    "TypeError: 'int' object is not callable (line 6 of a.py: top = max(self.level(), 2))": "the name of a function",
    "TypeError: 'list' object is not callable (line 6 of a.py: near = ranges(0))": "an element of it with square ones",
    "TypeError: 'array.array' object is not callable (line 6 of a.py: near = msg.ranges(0))": "with square ones",
    "TypeError: 'int' object is not callable (line 9 of running.py: rclpy.spin(node))": "without brackets: `self.tick`",
}


@pytest.mark.parametrize("died", SAID)
def test_a_first_mistake_is_named_with_its_cure(died):
    assert SAID[died] in cause_of(died)


@pytest.mark.parametrize(
    "died",
    [
        "NameError: name 'speed' is not defined (line 8 of ear.py: return speed * 2)",
        "TypeError: area() missing 1 required positional argument: 'width' (line 8 of ear.py: return area(2))",
        "ValueError: invalid literal for int() with base 10: 'x' (line 8 of main.py: a = int(sys.argv[1]))",
        "TypeError: Robot.spin() missing 1 required positional argument: 'speed' (line 8 of robot.py: self.spin())",
        "TypeError: Robot.walk() missing 1 required positional argument: 'speed' (line 8 of robot.py: done = self.walk())",
        "TypeError: 'NoneType' object is not callable (line 8 of ear.py: self.tick()())",
        "AttributeError: module 'os.path' has no attribute 'joined' (line 8 of ear.py: os.path.joined('a'))",
        "AttributeError: module 'rclpy.node' has no attribute 'Nod' (line 8 of ear.py: class Ear(rclpy.node.Nod):)",
        "AttributeError: module 'std_msgs.msg' has no attribute 'Strng' (line 8 of ear.py: std_msgs.msg.Strng())",
        "AttributeError: module 'numpy.linalg' has no attribute 'nrm' (line 8 of ear.py: numpy.linalg.nrm(a))",
        "AttributeError: module 'math' has no attribute 'PI' (line 8 of ear.py: math.PI)",
    ],
)
def test_where_the_cause_is_not_known_none_is_claimed(died):
    assert cause_of(died) == DIED


@pytest.mark.parametrize(
    ("died", "no_cure"),
    [
        ("Ear.heard() missing 1 required positional argument: 'extra'", "with nothing"),
        ("tick() missing 1 required positional argument: 'msg'", "`self`"),
        ("add() missing 1 required positional argument: 'response'", "`self`"),
        ("'list' object is not callable (line 6 of a.py: near = ranges(0))", "leave the brackets out"),
        ("'str' object is not callable (line 6 of a.py: str(5))", "leave the brackets out"),
        ("'int' object is not callable (line 6 of a.py: max(self.level(), 2))", "leave the brackets out"),
        ("'bool' object is not callable (line 9 of a.py: rclpy.spin(node))", "leave the brackets out"),
    ],
)
def test_a_cure_for_another_mistake_is_not_given(died, no_cure):
    assert no_cure not in cause_of(f"TypeError: {died}")


def test_a_package_of_the_workspace_is_no_installed_one_where_it_can_be_imported(tmp_path, monkeypatch):
    (tmp_path / "s9_own").mkdir()
    (tmp_path / "s9_own" / "__init__.py").touch()
    monkeypatch.syspath_prepend(tmp_path)
    died = "AttributeError: module 's9_own.ear' has no attribute 'Ear' (line 8 of mains.py: run(ear.Ear))"
    assert "`ear` defines no `Ear`" in cause_of(died)
