"""A node beside the newer Gazebo, and robots in its world."""

import pytest

WHEEL = """<link name='{0}_wheel'><collision><origin rpy='1.5707963 0 0'/><geometry>
<cylinder radius='0.05' length='0.02'/></geometry></collision></link>
<joint name='{0}_joint' type='continuous'><parent link='base_link'/><child link='{0}_wheel'/>
<origin xyz='0 {1} 0.05'/><axis xyz='0 1 0'/></joint>"""
CART = """<robot name='cart'><link name='base_footprint'/>
<joint name='foot' type='fixed'><parent link='base_footprint'/><child link='base_link'/></joint>
<link name='base_link'><inertial><mass value='3'/><inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial>
<collision><origin xyz='0 0 0.1'/><geometry><box size='0.3 0.2 0.1'/></geometry></collision></link>
<link name='laser'/>
<joint name='l' type='fixed'><parent link='base_link'/><child link='laser'/><origin xyz='0 0 0.3'/></joint>
""" + WHEEL.format("left", 0.11) + WHEEL.format("right", -0.11) + "{blocks}</robot>"  # fmt: skip
DRIVE = """<gazebo><plugin filename='{}' name='{}'><left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>
<wheel_separation>0.22</wheel_separation><wheel_radius>0.05</wheel_radius><topic>cmd_vel</topic>
<odom_topic>odom</odom_topic><frame_id>odom</frame_id><child_frame_id>base_footprint</child_frame_id>
<tf_topic>/tf</tf_topic></plugin></gazebo>"""
LIDAR = """<gazebo reference='laser'><sensor name='lidar' type='gpu_lidar'><topic>scan</topic><update_rate>10</update_rate>
<lidar><scan><horizontal><samples>36</samples><min_angle>-3.1</min_angle><max_angle>3.1</max_angle></horizontal></scan>
<range><min>0.1</min><max>8</max></range></lidar>{}</sensor></gazebo>"""
SENSORS = "<plugin filename='gz-sim-sensors-system' name='gz::sim::systems::Sensors'/>"
WORLD = """<sdf version='1.9'><world name='yard'>{plugins}<model name='post'><static>true</static><pose>2 0 0.5 0 0 0</pose>
<link name='l'><collision name='c'><geometry><box><size>1 1 1</size></box></geometry></collision></link></model>
</world></sdf>"""


@pytest.fixture
def yard(tmp_path):
    """A world's file; `plugins` are those of the world."""

    def write(plugins=SENSORS):
        file = tmp_path / "yard.sdf"
        file.write_text(WORLD.format(plugins=plugins))
        return str(file)

    return write


@pytest.fixture
def cart(tmp_path):
    """A robot's file, with blocks of <gazebo>."""

    def write(*blocks):
        file = tmp_path / "cart.urdf"
        file.write_text(CART.format(blocks="".join(blocks)))
        return str(file)

    return write


@pytest.fixture
def gz(session, run):
    """gz("sim", "-r", WORLD) runs a command of the newer Gazebo."""
    from coursekit.cli.gz_commands import carry_out

    def start(*words):
        return session.start(lambda: carry_out(words), name="gz", argv=words)

    return start
