"""An arm with six joints and a gripper whose second finger mimics the first, and who controls it."""

import pytest

JOINTS = [f"joint{number}" for number in range(1, 7)]
PARTS = "".join(
    f"""<link name='link{n}'><inertial><mass value='0.5'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' iyz='0'/>
</inertial><collision><origin xyz='0 0 0.05'/><geometry><cylinder radius='0.03' length='0.1'/></geometry></collision></link>
<joint name='joint{n}' type='revolute'><parent link='{f"link{n - 1}" if n > 1 else "base_link"}'/><child link='link{n}'/>
<origin xyz='0 0 0.1'/><axis xyz='{"0 0 1" if n in (1, 4, 6) else "0 1 0"}'/>
<limit lower='-3' upper='3' effort='10' velocity='3'/></joint>"""
    for n in range(1, 7)
)
FINGERS = """<link name='left'/><link name='right'/>
<joint name='finger' type='prismatic'><parent link='link6'/><child link='left'/><axis xyz='0 1 0'/>
<limit lower='0' upper='0.04' effort='5' velocity='0.5'/></joint>
<joint name='finger2' type='prismatic'><parent link='link6'/><child link='right'/><axis xyz='0 -1 0'/>
<limit lower='0' upper='0.04' effort='5' velocity='0.5'/><mimic joint='finger' multiplier='1'/></joint>"""
JOINT = """<joint name='{}'><command_interface name='position'/>
<state_interface name='position'><param name='initial_value'>{}</param></state_interface>
<state_interface name='velocity'/></joint>"""
STATES = "".join(JOINT.format(name, 0.2 if name == "joint2" else 0.0) for name in [*JOINTS, "finger"])
STATES += "<joint name='finger2'><state_interface name='position'/><state_interface name='velocity'/></joint>"
ARM = f"""<robot name='arm'><link name='world'/><joint name='fixed' type='fixed'><parent link='world'/>
<child link='base_link'/></joint><link name='base_link'><collision><geometry><box size='0.2 0.2 0.1'/></geometry></collision>
</link>{PARTS}{FINGERS}
<ros2_control name='arm_system' type='system'><hardware><plugin>{{plugin}}</plugin>{{settings}}</hardware>
{STATES}</ros2_control>{{blocks}}</robot>"""
PARAMETERS = f"""controller_manager:
  ros__parameters:
    update_rate: 100
    joint_state_broadcaster: {{type: joint_state_broadcaster/JointStateBroadcaster}}
    arm_controller: {{type: joint_trajectory_controller/JointTrajectoryController}}
    forward: {{type: forward_command_controller/ForwardCommandController}}
    gripper: {{type: position_controllers/GripperActionController}}
arm_controller:
  ros__parameters:
    joints: {JOINTS}
    command_interfaces: [position]
    state_interfaces: [position, velocity]
    constraints: {{goal_time: 0.5, joint1: {{trajectory: 0.5, goal: 0.01}}}}
forward:
  ros__parameters:
    joints: {JOINTS}
    interface_name: position
gripper:
  ros__parameters:
    joint: finger
"""


@pytest.fixture
def files(tmp_path):
    """The arm's description and its parameters, as files."""

    def write(plugin="mock_components/GenericSystem", blocks="", parameters=PARAMETERS, settings=""):
        (tmp_path / "arm.yaml").write_text(parameters)
        (tmp_path / "arm.urdf").write_text(ARM.format(plugin=plugin, blocks=blocks, settings=settings))
        return tmp_path / "arm.urdf", tmp_path / "arm.yaml"

    return write


@pytest.fixture
def managed(run, tmp_path):
    """managed(description, parameters) is the process of a robot's controller manager."""

    def start(description, parameters):
        urdf, yaml = tmp_path / "robot.urdf", tmp_path / "robot.yaml"
        urdf.write_text(description)
        yaml.write_text(parameters)
        run("robot_state_publisher", "robot_state_publisher", str(urdf))
        return run("controller_manager", "ros2_control_node", "--ros-args", "--params-file", str(yaml))

    return start


@pytest.fixture
def manager(managed, files):
    """The controller manager of the arm with hardware that is none."""
    return lambda **words: managed(*(path.read_text() for path in files(**words)))
