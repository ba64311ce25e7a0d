"""Controllers that command other controllers."""

import math

import pytest
from control_msgs.msg import MultiDOFCommand, MultiDOFStateStamped
from controller_manager_msgs.srv import ListControllers, ListHardwareInterfaces, SwitchController
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray
from std_srvs.srv import SetBool

from coursekit.nodes.control.chains import Chains
from coursekit.nodes.control.controller import ControlError, Controller
from coursekit.nodes.control.loaded_controller import Loaded
from coursekit.nodes.control.pid import Gains, Pid
from tests.nodes.control.test_controllers import CART
from tests.nodes.control.test_steering import ACKERMANN, FOUR, car, joints  # noqa: F401 (a fixture)

PARAMETERS = """controller_manager:
  ros__parameters:
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
    turn: {type: pid_controller/PidController}
    outer: {type: forward_command_controller/ForwardCommandController}
    other: {type: forward_command_controller/ForwardCommandController}
    direct: {type: forward_command_controller/ForwardCommandController}
    typo: {type: forward_command_controller/ForwardCommandController}
    refless: {type: forward_command_controller/ForwardCommandController}
    both: {type: pid_controller/PidController}
    outside: {type: pid_controller/PidController}
    wrong: {type: pid_controller/PidController}
both:
  ros__parameters:
    dof_names: [left]
    command_interface: velocity
    reference_and_state_interfaces: [position, velocity]
    gains: {left: {p: 2.0, d: 0.5}}
outside:
  ros__parameters:
    dof_names: [right]
    command_interface: velocity
    reference_and_state_dof_names: [course]
    reference_and_state_interfaces: [position]
    use_external_measured_states: true
    gains: {right: {p: 2.0}}
wrong: {ros__parameters: {dof_names: [left], command_interface: speed, reference_and_state_interfaces: [position]}}
turn:
  ros__parameters:
    dof_names: [left, right]
    command_interface: velocity
    reference_and_state_interfaces: [position]
    gains: {left: {p: 4.0, feedforward_gain: 1.0}, right: {p: 4.0, angle_wraparound: true}}
outer: {ros__parameters: {joints: [turn/left, turn/right], interface_name: position}}
other: {ros__parameters: {joints: [turn/left], interface_name: position}}
direct: {ros__parameters: {joints: [left], interface_name: velocity}}
typo: {ros__parameters: {joints: [turn/middle], interface_name: position}}
refless: {ros__parameters: {joints: [direct/left], interface_name: position}}
"""

PILOT = "pilot: {ros__parameters: {joint: car, interface_names: [linear/velocity, angular/position]}}"


@pytest.fixture
def cart(managed):
    return managed(CART, PARAMETERS)


def load(run, *names):
    assert run("controller_manager", "spawner", *names, "--inactive").wait(20) == 0


def switch(friend, start=(), stop=(), strict=True):
    kind = SwitchController.Request
    how = kind.STRICT if strict else kind.BEST_EFFORT
    words = {"activate_controllers": list(start), "deactivate_controllers": list(stop), "strictness": how}
    return friend.ask(SwitchController, "/controller_manager/switch_controller", **words).ok


def controllers(friend):
    return {each.name: each for each in friend.ask(ListControllers, "/controller_manager/list_controllers").controller}


def command_until(friend, states, topic, values, joint, goal):
    """Command until a joint's position is the goal."""
    out = friend.node.create_publisher(Float64MultiArray, topic, 10)
    for _ in range(100):
        out.publish(Float64MultiArray(data=values))
        friend.spin(0.1)
        if states and abs(joints(states)[joint][0] - goal) < 1e-3:
            return
    raise AssertionError(joints(states))


def test_a_controller_commands_another_that_commands_the_hardware(cart, run, friend):
    load(run, "states", "outer", "turn")
    states = friend.hear(JointState, "/joint_states")
    assert switch(friend, ["states", "outer", "turn"])
    command_until(friend, states, "/outer/commands", [0.5, -0.25], "left", 0.5)
    assert joints(states)["right"][0] == pytest.approx(-0.25, abs=1e-2)
    outer, turn = (controllers(friend)[name] for name in ("outer", "turn"))
    assert (turn.is_chainable, turn.is_chained, outer.is_chainable, outer.is_chained) == (True, True, False, False)
    assert list(turn.reference_interfaces) == ["left/position", "right/position"]
    [link] = outer.chain_connections
    assert (link.name, list(link.reference_interfaces)) == ("turn", ["left/position", "right/position"])
    listed = friend.ask(ListHardwareInterfaces, "/controller_manager/list_hardware_interfaces").command_interfaces
    assert ("turn/left/position", True, True) in [(each.name, each.is_available, each.is_claimed) for each in listed]


def test_a_controller_that_begins_to_be_commanded_is_started_again_and_then_hears_its_topic_again(cart, run, friend):
    load(run, "states", "outer", "turn")
    states, told = friend.hear(JointState, "/joint_states"), friend.hear(MultiDOFStateStamped, "/turn/controller_state")
    assert switch(friend, ["states", "turn"]) and switch(friend, ["outer"])
    assert controllers(friend)["turn"].is_chained and cart.output.count("[turn]: activate successful") == 2
    command_until(friend, states, "/outer/commands", [0.5, 0.5], "left", 0.5)
    assert switch(friend, stop=["outer"])
    assert not controllers(friend)["turn"].is_chained and cart.output.count("[turn]: activate successful") == 3
    friend.spin(0.1)
    assert math.isnan(told[-1].dof_states[0].reference), "the other's commands are forgotten"
    topic = friend.node.create_publisher(MultiDOFCommand, "/turn/reference", 10)
    for _ in range(40):
        topic.publish(MultiDOFCommand(dof_names=["right", "left"], values=[0.0, 1.0]))
        friend.spin(0.1)
    assert joints(states)["left"][0] == pytest.approx(1.0, abs=1e-3)


def test_what_is_commanded_must_be_active(cart, run, friend):
    load(run, "outer", "turn")
    assert not switch(friend, ["outer"])
    assert "The following controller with name 'turn' is not active and will not be activated." in cart.output
    assert "Aborting, no controller is switched! (::STRICT switch)" in cart.output
    assert switch(friend, ["turn", "outer"])
    assert not switch(friend, stop=["turn"])
    assert (
        "Could not deactivate controller with name 'turn' because preceding controller with name 'outer' is active and "
        "will not be deactivated." in cart.output
    )
    assert switch(friend, stop=["outer", "turn"])
    assert not controllers(friend)["turn"].is_chained


def test_one_commander_takes_the_place_of_another(cart, run, friend):
    load(run, "states", "outer", "other", "turn")
    assert switch(friend, ["states", "outer", "turn"])
    assert not switch(friend, ["other"])
    assert "Command interface 'turn/left/position' is already claimed." in cart.output
    assert switch(friend, ["other"], ["outer"])
    assert controllers(friend)["turn"].is_chained
    assert cart.output.count("[turn]: activate successful") == 1, "it was commanded all the time"
    command_until(friend, friend.hear(JointState, "/joint_states"), "/other/commands", [0.75], "left", 0.75)


def test_references_that_are_not_there_are_told(cart, run, friend):
    load(run, "typo", "refless", "turn", "direct")
    assert not switch(friend, ["typo", "turn"])
    assert "command interface 'turn/middle/position' does not exist" in cart.output
    assert not switch(friend, ["refless", "direct"])
    assert (
        "No reference interface 'direct/left/position' exist, since the following controller with name 'direct' "
        "is not chainable." in cart.output
    )
    assert switch(friend, ["typo", "turn"], strict=False) is True
    assert controllers(friend)["turn"].state == "active" and controllers(friend)["typo"].state == "inactive"


def test_a_loop_feeds_forward_and_takes_the_short_way_round(cart, run, friend):
    load(run, "states", "turn")
    told = friend.hear(MultiDOFStateStamped, "/turn/controller_state")
    assert switch(friend, ["states", "turn"])
    topic = friend.node.create_publisher(MultiDOFCommand, "/turn/reference", 10)
    topic.publish(MultiDOFCommand(dof_names=["left", "right"], values=[0.5, 6.0]))
    friend.spin(0.1)
    assert friend.ask(SetBool, "/turn/set_feedforward_control", data=True).success
    friend.spin(0.5)
    left, right = told[-1].dof_states
    assert left.output == pytest.approx(4 * left.error + 0.5)
    assert -0.5 < right.error < 0, "6 rad are 0.28 rad back"
    topic.publish(MultiDOFCommand(dof_names=["left"], values=[0.5]))
    friend.spin(0.1)
    assert "reference: has ['left'] with 1 values; it needs ['left', 'right'], one each" in cart.output


def test_a_loop_takes_the_derivative_too(cart, run, friend):
    load(run, "states", "both")
    told = friend.hear(MultiDOFStateStamped, "/both/controller_state")
    assert switch(friend, ["states", "both"])
    topic = friend.node.create_publisher(MultiDOFCommand, "/both/reference", 10)
    topic.publish(MultiDOFCommand(dof_names=["left"], values=[1.0], values_dot=[0.2]))
    friend.spin(0.1)
    [left] = told[-1].dof_states
    assert left.error_dot == pytest.approx(0.2 - left.feedback_dot)
    assert left.output == pytest.approx(2 * left.error + 0.5 * left.error_dot)


def test_a_loop_takes_its_state_from_a_topic(cart, run, friend):
    load(run, "states", "outside")
    states = friend.hear(JointState, "/joint_states")
    assert switch(friend, ["states", "outside"])
    for topic, value in (("reference", 1.0), ("measured_state", 0.25)):
        out = friend.node.create_publisher(MultiDOFCommand, f"/outside/{topic}", 10)
        out.publish(MultiDOFCommand(dof_names=["course"], values=[value]))
    friend.spin(0.2)
    assert joints(states)["right"][1] == pytest.approx(1.5)


def test_a_loop_of_an_unknown_interface_is_not_configured(cart, run):
    assert run("controller_manager", "spawner", "wrong", "--inactive").wait(20) == 1
    assert "interface 'speed' is not one of position, velocity, acceleration, effort" in cart.output


def test_a_car_is_commanded_by_another_controller(car, run, friend, tmp_path):  # noqa: F811
    car(ACKERMANN, FOUR)
    (tmp_path / "pilot.yaml").write_text(PILOT)
    words = ("-t", "forward_command_controller/MultiInterfaceForwardCommandController", "-p", str(tmp_path / "pilot.yaml"))
    assert run("controller_manager", "spawner", "states", "car").wait(20) == 0
    assert run("controller_manager", "spawner", "pilot", *words).wait(20) == 0
    states = friend.hear(JointState, "/joint_states")
    out = friend.node.create_publisher(Float64MultiArray, "/pilot/commands", 10)
    for _ in range(10):
        out.publish(Float64MultiArray(data=[0.5, 0.0]))
        friend.spin(0.1)
    assert joints(states)["rear_left"][1] == pytest.approx(5.0, abs=1e-3)
    assert switch(friend, stop=["pilot"])
    friend.spin(0.2)
    assert joints(states)["rear_left"][1] == 0.0


class Nothing(Controller):
    """A controller by its commands alone."""

    def __init__(self, *commands):
        self._commands = list(commands)

    def command_names(self):
        return self._commands


def chains(**commands):
    return Chains({name: Loaded(name, "", Nothing(*names), "inactive") for name, names in commands.items()})


def test_commands_arrive_in_the_same_step():
    order = chains(inner=["wheel/velocity"], alone=["arm/position"], outer=["middle/a"], middle=["inner/b"]).in_order()
    assert [loaded.name for loaded in order] == ["outer", "middle", "inner", "alone"]


def test_a_circle_has_some_order():
    assert sorted(loaded.name for loaded in chains(a=["b/x"], b=["a/x"]).in_order()) == ["a", "b"]


def test_an_integral_is_limited():
    windup, anti = (Pid(Gains(i=2.0, i_max=1.0, i_min=-1.0, antiwindup=how)) for how in (False, True))
    assert [loop.command(1.0, 1.0) for loop in (windup, anti) for _ in range(3)] == [1.0] * 6
    assert (windup.command(-1.0, 1.0), anti.command(-1.0, 1.0)) == (1.0, -1.0), "without it, the integral has run away"
    assert Pid(Gains(d=1.0)).command(0.5, 0.1, rate=3.0) == 3.0
    with pytest.raises(ControlError, match="i_clamp_min"):
        Gains(i_max=-1.0)
