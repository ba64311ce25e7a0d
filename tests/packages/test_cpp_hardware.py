"""Hardware that a package brings as a C++ class: it is built by colcon, and the controller manager runs it."""

from __future__ import annotations

import re
import shutil

import pytest
import yaml

from coursekit.cpp.age import MARK
from tests.needs import compiler_or_skip
from tests.packages.hardware_told import faulty, resources, told
from tests.packages.pip_tools import pip_tools_or_skip
from tests.packages.test_cpp_workspace import ENV, SOURCES, colcon, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]


@pytest.fixture(scope="module", params=["own tools", "pip's tools"])
def workspace(request, tmp_path_factory):
    compiler_or_skip()
    env = pip_tools_or_skip(tmp_path_factory.mktemp("bin")) if request.param == "pip's tools" else ENV
    folder = tmp_path_factory.mktemp("hardware_ws")
    shutil.copytree(SOURCES.parent.parent / "hardware_ws" / "src", folder / "src")
    built = colcon(folder, "build", env=env)
    assert built.returncode == 0 and "1 package finished" in built.stdout, built.stdout + built.stderr
    assert "stderr" not in built.stdout + built.stderr
    return folder


LIFE = [
    "Loading hardware 'cart'",
    "Initialize hardware 'cart'",
    "left: 1 command, 2 states, at most 9.5 red",
    "right: 1 command, 2 states, at most 9.5 green",
    "init from unknown",
    "Successful initialization of hardware 'cart'",
    "'configure' hardware 'cart'",
    "configure from unconfigured",
    "Successful 'configure' of hardware 'cart'",
    "'activate' hardware 'cart'",
    "activate from inactive",
    "Successful 'activate' of hardware 'cart'",
]
END = ["destroyed"]  # by Ctrl-C, without a transition


def test_a_launch_file_drives_the_driver_through_its_life(workspace):
    said = sourced(workspace, "COURSEKIT_STOP_AFTER=2 ros2 launch k_cart cart.launch.py").stdout
    lines = re.sub(r"^\[ros2_control_node-2\] (.*?)\[\d+\.\d+\] ", r"\1", said, flags=re.MULTILINE)
    assert resources(lines) == LIFE + END
    assert "Configured and activated drive" in said and "process has died" not in said


@pytest.mark.parametrize("virtual", [True, False])
def test_a_velocity_goes_in_and_joint_states_come_out(workspace, virtual):
    body = """
    spawn("joint_state_broadcaster", "drive")
    drive(0.5)
    before = joints[-1]
    while joints[-1].position[0] <= before.position[0]:
        rclpy.spin_once(node)
    drive(0.0)
    print(sorted(joints[-1].name), [round(speed, 6) for speed in joints[-1].velocity])
    """
    said = told(workspace, body, virtual=virtual)
    assert "['left', 'right'] [0.0, 0.0]" in said and "ended 0" in said
    assert resources(said) == LIFE + END, said


def test_a_driver_sleeps_and_has_a_node(workspace):
    body = """
    from std_msgs.msg import Float64
    spawn("joint_state_broadcaster", "drive")
    print("at", session.clock.now() // 10**6)
    drive(0.5)
    gain = node.create_publisher(Float64, "/gain", 1)
    while joints[-1].velocity[0] != 5.0:
        gain.publish(Float64(data=1.0))
        rclpy.spin_once(node)
    print("cart_io" in node.get_node_names())
    """
    gain = '<param name="gain">2.0</param>'
    said = told(workspace, body, changes={gain: f'{gain}<param name="slow">1.25</param>'})
    assert "at 1700000001250\nTrue\nended 0" in said.replace("spawned 0\n", "")
    assert resources(said) == LIFE + END


def test_the_command_lists_hardware_and_interfaces(workspace):
    body = """
    spawn("joint_state_broadcaster", "drive")
    ros2("control", "list_hardware_components")
    ros2("control", "list_hardware_interfaces")
    """
    said = told(workspace, body)
    assert "name: cart\n\ttype: system\n\tplugin name: k_cart/Cart\n\tstate: id=3 label=active" in said
    assert "\t\tleft/velocity [available] [claimed]" in said
    assert "command interfaces\n\tleft/velocity [available] [claimed]\n\tright/velocity [available] [claimed]" in said
    assert "state interfaces\n\tleft/position\n\tleft/velocity\n\tright/position\n\tright/velocity" in said


def test_hardware_is_brought_to_other_states(workspace):
    body = """
    bring("active")
    bring("unconfigured")
    spawn("drive")
    bring("inactive")
    spawn("drive")
    bring("finalized")
    bring("active")
    """
    said = told(workspace, body, words=["-p", "hardware_components_initial_state.inactive:=[cart]"])
    assert [line for line in said.splitlines() if re.match("(active|inactive|unconfigured|finalized|spawned) ", line)] == [
        "active True active", "unconfigured True unconfigured", "spawned 1", "inactive True inactive", "spawned 0",
        "finalized True finalized", "active False finalized",
    ]  # fmt: skip
    assert "Can't activate controller 'drive': command interface 'left/velocity' is not available." in said
    assert resources(said)[9:15] == [
        "'activate' hardware 'cart'", "activate from inactive", "Successful 'activate' of hardware 'cart'",
        "'deactivate' hardware 'cart'", "deactivate from active", "Successful 'deactivate' of hardware 'cart'",
    ]  # fmt: skip
    assert {"cleanup from inactive", "Successful 'cleanup' of hardware 'cart'"} <= set(resources(said))
    assert resources(said)[-2:] == ["hardware 'cart' is in finalized state and can be only destroyed.", "destroyed"], said


MISSING = (
    "The published robot description file (urdf) seems not to be genuine. The following error was caught: "
    "Wrong state or command interface configuration.\nmissing state interfaces:\n{}\nmissing command interfaces:\n{}"
)
ALL_STATES = "".join(f"' {side}/{kind} '\t" for side in ("left", "right") for kind in ("position", "velocity"))
COMMANDS = "' left/velocity '\t' right/velocity '\t"


@pytest.mark.parametrize(
    ("fault", "lines"),
    [
        (
            "init",
            [
                "[INFO] [resource_manager]: Failed to initialize hardware 'cart'",
                "[WARN] [resource_manager]: System hardware component 'cart' from plugin 'k_cart/Cart' failed to "
                "initialize.",
                MISSING.format(ALL_STATES, COMMANDS),
            ],
        ),
        (
            "throw in init",
            [
                "[ERROR] [resource_manager]: Exception of type : St13runtime_error occurred while initializing hardware "
                "'cart': no battery"
            ],
        ),
        ("no velocity", [MISSING.format("' left/velocity '\t' right/velocity '\t", "")]),
        (
            "configure",
            [
                "[INFO] [Cart]: error from unconfigured",
                "[ERROR] [resource_manager]: Failed to 'configure' hardware 'cart'",
            ],
        ),
        (
            "throw in activate",
            [
                "[ERROR] [resource_manager]: Exception of type : St13runtime_error occurred while activating hardware "
                "'cart': no battery"
            ],
        ),
    ],
)
def test_what_fails_at_the_start_is_said(workspace, fault, lines):
    said = told(workspace, "spawn('joint_state_broadcaster')", changes=faulty(fault))
    assert [line for line in lines if line not in said] == []
    assert "spawned" in said and "ended 0" in said, "the controller manager lives"


def test_missing_interfaces_of_a_parameter_end_the_manager(workspace):
    urdf = (workspace / "src/k_cart/urdf/cart.urdf").read_text()
    urdf = urdf.replace("\n", "").replace("2.0</param>", '2.0</param><param name="fault">no velocity</param>')
    text = yaml.dump({"controller_manager": {"ros__parameters": {"robot_description": urdf}}})
    (workspace / "wrong.yaml").write_text(text)
    said = sourced(workspace, "ros2 run controller_manager ros2_control_node --ros-args --params-file wrong.yaml")
    assert said.returncode not in (0, None)
    assert "terminate called after throwing an instance of 'std::runtime_error'\n  what():  Wrong state or" in said.stderr


def test_an_error_of_read_deactivates_the_controllers(workspace):
    body = """
    spawn("joint_state_broadcaster", "drive")
    while "error from active" not in control.output:
        rclpy.spin_once(node, timeout_sec=0.1)
    ros2("control", "list_controllers")
    ros2("control", "list_hardware_components")
    bring("active")
    """
    said = told(workspace, body, words=["-p", "update_rate:=20"], changes=faulty("read"))
    assert re.search(
        r"drive\s+diff_drive_controller/DiffDriveController\s+inactive", re.sub("\x1b\\[[0-9;]*m|[][]", " ", said)
    )
    assert "label=unconfigured" in said and "[unavailable]" in said
    assert "active True active" in said


@pytest.mark.parametrize(
    ("fault", "code", "text"),
    [
        ("throw", -6, "no wheel"),
        ("crash", -6, ""),
        ("exit", 3, ""),
    ],
)
@pytest.mark.parametrize("virtual", [True, False])
def test_the_end_of_the_driver_is_the_end_of_the_manager(workspace, fault, code, text, virtual):
    said = told(workspace, "print('died', control.wait(20.0))", virtual=virtual, changes=faulty(fault))
    assert f"died {code}\n" in said
    assert text in said


def test_a_mode_that_the_driver_refuses_is_not_switched_to(workspace):
    said = told(workspace, "spawn('drive')", changes=faulty("refuse"))
    assert (
        "[resource_manager]: Component 'cart' did not accept new command resource combination: \n Start interfaces: \n[\n"
        in said
    )
    assert "Could not switch controllers since prepare command mode switch was rejected." in said
    assert "spawned 1" in said


@pytest.mark.parametrize(
    ("plugin", "text"),
    [
        (
            "k_cart/Truck",
            "According to the loaded plugin descriptions the class k_cart/Truck with base class type "
            "hardware_interface::SystemInterface does not exist. Declared types are  mock_components/GenericSystem "
            "fake_components/GenericSystem k_cart/Cart k_cart/Ghost",
        ),
        ("k_cart/Ghost", "Could not create instance of type k_cart::Ghost"),
    ],
)
def test_a_class_that_is_not_there_is_said(workspace, plugin, text):
    said = told(workspace, "spawn('joint_state_broadcaster')", changes={"k_cart/Cart": plugin})
    assert re.search(r"Caught exception of type : \S+ while loading hardware 'cart': ", said) and text in said
    assert "spawned 0" in said and "ended 0" in said


def test_a_program_of_another_version_is_not_run(workspace):
    path = workspace / "install/k_cart/lib/k_cart/__plugins_k_cart"
    data = path.read_bytes()
    at = data.index(MARK) + len(MARK)
    path.write_bytes(data[:at] + b"0" * 16 + data[at + 16 :])
    try:
        assert "Build its workspace again: `colcon build`." in told(workspace, "spawn('drive')")
    finally:
        path.write_bytes(data)


OTHERS = """</ros2_control>
<ros2_control name="lift" type="actuator"><hardware><plugin>k_cart/Lift</plugin></hardware>
<joint name="lift"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>
<ros2_control name="scale" type="sensor"><hardware><plugin>k_cart/Scale</plugin></hardware>
<sensor name="scale"><state_interface name="mass"/></sensor></ros2_control></robot>"""


def test_actuators_and_sensors_are_run(workspace):
    body = """
    from control_msgs.msg import DynamicJointState
    from std_msgs.msg import Float64MultiArray
    spawn("joint_state_broadcaster", "lifter")
    heard = []
    node.create_subscription(DynamicJointState, "/dynamic_joint_states", heard.append, 10)
    goal = node.create_publisher(Float64MultiArray, "/lifter/commands", 10)
    def values():
        return {f"{joint}/{name}": value for joint, one in zip(heard[-1].joint_names, heard[-1].interface_values)
                for name, value in zip(one.interface_names, one.values)} if heard else {}
    while values().get("lift/position") != 0.25 or values().get("scale/mass") != 3.0:
        goal.publish(Float64MultiArray(data=[0.25]))
        rclpy.spin_once(node)
    ros2("control", "list_hardware_components")
    """
    (workspace / "lifter.yaml").write_text(
        "controller_manager: {ros__parameters: {lifter: {type: position_controllers/JointGroupPositionController}}}\n"
        "lifter: {ros__parameters: {joints: [lift]}}\n"
    )
    said = told(workspace, body, words=["--params-file", "lifter.yaml"], changes={"</ros2_control>\n</robot>": OTHERS})
    assert "name: lift\n\ttype: actuator\n\tplugin name: k_cart/Lift" in said
    assert "name: scale\n\ttype: sensor\n\tplugin name: k_cart/Scale" in said


@pytest.mark.parametrize("virtual", [True, False])
def test_a_controller_in_cpp_commands_and_hears(workspace, virtual):
    body = """
    from std_msgs.msg import Float64
    spawn("speeds")
    heard = []
    node.create_subscription(Float64, "/speeds/mean", heard.append, 10)
    speed = node.create_publisher(Float64, "/speeds/speed", 10)
    while not heard or heard[-1].data != 3.0:
        speed.publish(Float64(data=1.5))
        rclpy.spin_once(node)
    print("nodes", sorted(node.get_node_names()))
    ros2("control", "list_controllers")
    ros2("control", "list_controller_types")
    ros2("control", "list_hardware_interfaces")
    ros2("param", "get", "/speeds", "wheels")
    ros2("control", "unload_controller", "speeds")
    ros2("control", "switch_controllers", "--deactivate", "speeds")
    ros2("control", "unload_controller", "speeds")
    print("nodes", sorted(node.get_node_names()))
    """
    said = told(workspace, body, virtual=virtual)
    assert "nodes ['cart_io', 'controller_manager', 'driver', 'robot_state_publisher', 'speeds']" in said
    assert "nodes ['cart_io', 'controller_manager', 'driver', 'robot_state_publisher']" in said
    assert "k_cart/Speeds" in said and "k_cart/Turns" in said and "right/velocity [available] [claimed]" in said
    assert "String values are: ['right', 'left']" in said
    assert re.findall(r"\[speeds\]: (.*)", said) == [
        "configured from unconfigured", "activated with 2 commands, 4 states", "deactivated",
    ]  # fmt: skip
    assert "ended 0" in said


def test_a_chainable_controller_in_cpp_runs_alone(workspace):
    body = """
    spawn("joint_state_broadcaster", "turns")
    while not joints or abs(joints[-1].position[joints[-1].name.index("right")] - 1.0) > 1e-3:
        rclpy.spin_once(node)
    """
    assert "ended 0" in told(workspace, body)


def test_a_chainable_controller_in_cpp_is_commanded_by_another(workspace):
    body = """
    from std_msgs.msg import Float64MultiArray
    spawn("joint_state_broadcaster", "turns")
    spawn("outer")
    goal = node.create_publisher(Float64MultiArray, "/outer/commands", 10)
    def right():
        return joints[-1].position[joints[-1].name.index("right")] if joints else 0.0
    while abs(right() + 0.5) > 1e-3:
        goal.publish(Float64MultiArray(data=[-0.5]))
        rclpy.spin_once(node)
    ros2("control", "list_controllers", "-v")
    ros2("control", "list_hardware_interfaces")
    ros2("control", "switch_controllers", "--deactivate", "turns")
    ros2("control", "switch_controllers", "--deactivate", "outer")
    while abs(right() - 1.0) > 1e-3:
        rclpy.spin_once(node)
    print("alone again")
    """
    (workspace / "outer.yaml").write_text(
        "controller_manager: {ros__parameters: {outer: {type: forward_command_controller/ForwardCommandController}}}\n"
        "outer: {ros__parameters: {joints: [turns/right], interface_name: position}}\n"
    )
    said = told(workspace, body, words=["--params-file", "outer.yaml"])
    assert "\tchained to interfaces:\n\t\tright/position      \n" in said
    assert "\texported reference interfaces:\n\t\tright/position\n" in said
    assert "\tturns/right/position [available] [claimed]" in said
    assert "because preceding controller with name 'outer' is active and will not be deactivated." in said
    assert "alone again\nended 0" in said


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("nameless", "Controller 'nameless' is chainable, but does not export any reference interfaces."),
        ("nameless", "The name of the interface 'somebody/right/position' does not begin with the controller's name."),
        ("broken", "[ERROR] [controller_manager]: Could not initialize the controller named 'broken'"),
        ("wheelless", "After configuring, controller 'wheelless' is in state 'unconfigured' , expected inactive."),
    ],
)
def test_a_controller_in_cpp_that_fails_is_said(workspace, name, text):
    said = told(workspace, f"spawn('{name}')")
    assert text in said and "spawned 1" in said and "ended 0" in said
