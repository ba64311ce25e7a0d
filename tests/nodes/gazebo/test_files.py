"""Gazebo's files: what stands where, what drives and senses, what is listed, what is refused."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.gazebo.devices import CameraDevice, ImuDevice, JointDevice, OdometryDevice, RayDevice, TruthDevice
from coursekit.nodes.gazebo.sdf_world import load_sdf, read_entity
from coursekit.sim import Disc, Lidar, Simulation, WorldError
from coursekit.urdf import UrdfError

HEAD = "<?xml version='1.0'?><sdf version='{}'><world name='yard'>"
FEET = "</world></sdf>"
BOX = "<collision name='c'><geometry><box><size>{}</size></box></geometry></collision>"


@pytest.fixture
def world(tmp_path):
    def write(body, version="1.6"):
        file = tmp_path / "yard.world"
        file.write_text(HEAD.format(version) + body + FEET)
        return load_sdf(file).world

    return write


def model(name, body, pose="0 0 0 0 0 0", static=True):
    link = f"<link name='l'>{body}</link>"
    return f"<model name='{name}'><static>{str(static).lower()}</static><pose>{pose}</pose>{link}</model>"


def ahead(world, height=0.3, place=Pose2D()):
    return float(Lidar(beams=1, angle_max=0.0, range_max=50.0, range_min=0.0).look(world.cut(height), place)[0])


@pytest.mark.parametrize(
    ("body", "distance"),
    [
        (model("m", BOX.format("1 1 1"), "3 0 0.5 0 0 0"), 2.5),
        (model("m", BOX.format("1 1 1"), "3 0 0.5 0 0 0.7853981633974483"), 3 - 0.5**0.5),
        (model("m", BOX.format("1 1 4"), "3 0 0 0 1.5707963267948966 0"), 1.0),
        (model("m", BOX.format("1 1 1"), "3 0 2 0 0 0"), math.inf),
        (model("m", "<collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry></collision>",
               "3 0 0.9 0 0 0"), 3 - 0.8),
        (model("m", "<collision name='c'><geometry><cylinder><radius>0.5</radius><length>2</length></cylinder></geometry>"
               "</collision>", "3 0 0 0 0 0"), 2.5),
        (model("m", "<collision name='c'><geometry><cylinder><radius>0.5</radius><length>2</length></cylinder></geometry>"
               "</collision>", "3 0 0.3 0 1.5707963267948966 0"), 2.0),
        (model("m", "<collision name='c'><geometry><polyline><point>2 -1</point><point>4 -1</point><point>4 1</point>"
               "<point>2 1</point><height>1</height></polyline></geometry></collision>"), 2.0),
        (model("m", f"<pose>1 0 0 0 0 0</pose>{BOX.format('1 1 1')}", "2 0 0.5 0 0 0"), 2.5),
    ],
    ids=["box", "turned box", "lying box", "box above", "sphere", "cylinder", "lying cylinder", "polyline", "link pose"],
)  # fmt: skip
def test_shapes_stand_where_the_file_puts_them(world, body, distance):
    assert ahead(world(body)) == pytest.approx(distance, abs=0.01)


def test_poses_are_nested_and_may_be_relative_to_named_frames(world):
    inner = f"<model name='in'><pose>1 0 0 0 0 0</pose><link name='l'>{BOX.format('1 1 1')}</link></model>"
    outer = f"<model name='out'><static>1</static><pose>0 2 0.5 0 0 -1.5707963267948966</pose>{inner}</model>"
    assert ahead(world(outer, "1.7"), place=Pose2D(-3, 1)) == pytest.approx(2.5)
    frames = (
        "<model name='m'><static>1</static><frame name='f'><pose>2 0 0.5 0 0 0</pose></frame>"
        f"<link name='l'><pose relative_to='f'>1 0 0 0 0 0</pose>{BOX.format('1 1 1')}</link></model>"
    )
    assert ahead(world(frames, "1.8")) == pytest.approx(2.5)
    turned = model("m", BOX.format("4 1 1"), "5 0 0.5 0 0 0").replace(
        "<pose>5 0 0.5 0 0 0", "<pose degrees='true'>5 0 0.5 0 0 90"
    )
    assert ahead(world(turned, "1.9")) == pytest.approx(4.5)


def test_a_saved_state_wins(world):
    state = "<state world_name='yard'><model name='m'><pose>6 0 0.5 0 0 0</pose></model></state>"
    assert ahead(world(model("m", BOX.format("1 1 1"), "3 0 0.5 0 0 0") + state)) == pytest.approx(5.5)


def test_models_are_included_from_the_model_path(world, tmp_path, monkeypatch):
    folder = tmp_path / "shop" / "crate"
    folder.mkdir(parents=True)
    (folder / "model.config").write_text("<model><sdf version='1.6'>crate.sdf</sdf></model>")
    (folder / "crate.sdf").write_text(f"<sdf version='1.6'>{model('crate', BOX.format('1 1 1'))}</sdf>")
    include = "<include><uri>model://crate</uri><name>a</name><pose>3 0 0.5 0 0 0</pose></include>"
    ground = "<include><uri>model://ground_plane</uri></include><include><uri>model://sun</uri></include>"
    lonely = world(include + model("m", BOX.format("1 1 1"), "5 0 0.5 0 0 0"))
    assert "GAZEBO_MODEL_PATH" in lonely.notes[0] and ahead(lonely) == pytest.approx(4.5)
    monkeypatch.setenv("GAZEBO_MODEL_PATH", str(tmp_path / "shop"))
    loaded_world = world(ground + include)
    assert ahead(loaded_world) == pytest.approx(2.5) and list(loaded_world.models) == ["ground_plane", "sun", "a"]


def test_meshes_are_cut_at_the_lidar_s_height(world, tmp_path):
    import trimesh

    cone = trimesh.creation.cone(radius=1.0, height=2.0, sections=256)
    cone.export(tmp_path / "cone.stl")
    mesh = "<collision name='c'><geometry><mesh><uri>cone.stl</uri></mesh></geometry></collision>"
    loaded_world = world(model("m", mesh, "3 0 0 0 0 0"))
    assert ahead(loaded_world, 0.5) == pytest.approx(3 - 0.75, abs=1e-3) and ahead(loaded_world, 1.5) == pytest.approx(
        3 - 0.25, abs=1e-3
    )
    assert math.isinf(ahead(loaded_world, 2.5))


def test_models_that_are_not_static_can_be_pushed(world):
    loaded_world = world(
        model("m", f"<inertial><mass>2</mass></inertial>{BOX.format('0.4 0.4 0.4')}", "1 0 0.2 0 0 0", static=False)
    )
    assert loaded_world.thing("m").mass == 2.0 and Simulation(loaded_world).pose_of("m").x == 1.0


BURGER = """<sdf version='1.6'><model name='burger'><pose>0 0 0 0 0 0</pose><link name='base_footprint'/>
<link name='base_link'><inertial><mass>0.8</mass></inertial>
 <collision name='c'><pose>-0.032 0 0.07 0 0 0</pose><geometry>
  <box><size>0.14 0.14 0.14</size></box></geometry></collision></link>
<link name='base_scan'><pose>-0.032 0 0.171 0 0 0</pose><sensor name='lds' type='ray'><update_rate>5</update_rate>
 <ray><scan><horizontal><samples>360</samples><resolution>1</resolution>
 <min_angle>0</min_angle><max_angle>6.28</max_angle>
 </horizontal></scan><range><min>0.12</min><max>3.5</max></range>
 <noise><type>gaussian</type><mean>0</mean><stddev>0.01</stddev>
 </noise></ray><plugin name='laser' filename='libgazebo_ros_ray_sensor.so'><ros><remapping>~/out:=scan</remapping></ros>
 <frame_name>base_scan</frame_name></plugin></sensor></link>
<link name='wheel_left_link'><pose>0 0.08 0.023 -1.57 0 0</pose>
 <collision name='c'><geometry><cylinder><radius>0.033</radius>
 <length>0.018</length></cylinder></geometry></collision></link>
<link name='wheel_right_link'/>
<joint name='wheel_left_joint' type='revolute'><parent>base_link</parent><child>wheel_left_link</child></joint>
<joint name='wheel_right_joint' type='revolute'><parent>base_link</parent><child>wheel_right_link</child></joint>
<plugin name='drive' filename='libgazebo_ros_diff_drive.so'><ros><namespace>tb</namespace></ros><update_rate>30</update_rate>
 <left_joint>wheel_left_joint</left_joint><right_joint>wheel_right_joint</right_joint><wheel_separation>0.16</wheel_separation>
 <wheel_diameter>0.066</wheel_diameter><publish_odom>true</publish_odom><publish_odom_tf>true</publish_odom_tf></plugin>
<plugin name='strange' filename='libstrange.so'/><plugin name='truth' filename='libgazebo_ros_p3d.so'>
 <ros><remapping>odom:=truth</remapping></ros></plugin></model></sdf>"""


def test_a_robot_in_sdf_drives_and_senses():
    entity = read_entity(BURGER)
    ray, drive, truth = (
        next(device for device in entity.devices if isinstance(device, kind))
        for kind in (RayDevice, OdometryDevice, TruthDevice)
    )
    assert (ray.topic, ray.frame, ray.rate, ray.lidar.beams, ray.lidar.range_max) == ("/scan", "base_scan", 5.0, 360, 3.5)
    assert ray.lidar.mount.x == pytest.approx(-0.032) and ray.lidar.height == pytest.approx(0.171, abs=0.011)
    assert (drive.topic, drive.command_topic, drive.exact) == ("/tb/odom", "/tb/cmd_vel", True)
    assert entity.robot.drive.separation == 0.16 and truth.topic == "/truth"
    assert any("libstrange.so" in note for note in entity.notes)


def test_a_namespace_of_the_spawner_wins():
    topics = {device.topic for device in read_entity(BURGER, "r1").devices}
    assert topics == {"/r1/scan", "/r1/odom", "/r1/truth"}


def test_tf_goes_where_a_drive_remaps_it():
    moved = BURGER.replace("<ros><namespace>tb</namespace></ros>", "<ros><remapping>/tf:=tf</remapping></ros>")
    for text, topic in ((BURGER, "/tf"), (moved, "/r1/tf")):
        drive = next(device for device in read_entity(text, "r1").devices if isinstance(device, OdometryDevice))
        assert drive.tf_topic == topic


URDF = """<robot name='r'><link name='base'><collision><geometry><cylinder radius='0.2' length='0.2'/></geometry></collision>
</link><link name='eye'/><joint name='j' type='fixed'><parent link='base'/><child link='eye'/>
<origin xyz='0.1 0 0.3' rpy='{rpy}'/></joint>
<gazebo reference='eye'>{sensor}</gazebo><gazebo>{plugin}</gazebo></robot>"""


def test_urdf_blocks_give_planar_drives_joint_states_imus_and_cameras():
    plugin = (
        "<plugin name='p' filename='libgazebo_ros_planar_move.so'><ros><remapping>cmd_vel:=go</remapping></ros></plugin>"
        "<plugin name='q' filename='libgazebo_ros_joint_state_publisher.so'><joint_name>j</joint_name></plugin>"
    )
    sensor = (
        "<sensor name='i' type='imu'><update_rate>50</update_rate><imu><angular_velocity><z><noise><stddev>0.01</stddev>"
        "</noise></z></angular_velocity></imu><plugin name='i' filename='libgazebo_ros_imu_sensor.so'/></sensor>"
        "<sensor name='c' type='camera'><camera><image><width>320</width><height>200</height></image></camera>"
        "<plugin name='c' filename='libgazebo_ros_camera.so'/></sensor><sensor name='s' type='sonar'>"
        "<plugin name='s'/></sensor>"
    )
    entity = read_entity(URDF.format(rpy="0 0 0", sensor=sensor, plugin=plugin))
    kinds = {type(device): device for device in entity.devices}
    assert entity.robot.drive.kind == "planar" and kinds[OdometryDevice].command_topic == "/go"
    assert kinds[ImuDevice].topic == "/i/out" and kinds[ImuDevice].turn_noise == 0.01 and kinds[ImuDevice].rate == 50
    assert kinds[CameraDevice].topic == "/c/image_raw" and kinds[CameraDevice].frame == "eye"
    assert kinds[JointDevice].joints == ("j",) and any("'sonar'" in note for note in entity.notes)


def test_a_lidar_on_its_head_turns_the_other_way():
    sensor = (
        "<sensor name='l' type='ray'><ray><scan><horizontal><samples>5</samples><min_angle>-1</min_angle>"
        "<max_angle>1</max_angle></horizontal></scan><range><min>0.1</min><max>9"
        "</max></range></ray><plugin name='l' filename='x'/></sensor>"
    )
    for rpy, flipped in (("0 0 0", False), ("3.141592653589793 0 0", True)):
        entity = read_entity(URDF.format(rpy=rpy, sensor=sensor, plugin=""))
        assert entity.devices[0].lidar.upside_down is flipped
        assert entity.devices[0].lidar.height == pytest.approx(0.4)
        assert isinstance(entity.robot.parts[0], Disc) and entity.robot.parts[0].low == 0.0


WRONG = {
    "<model": "XML parser error",
    model("m", BOX.format("1 1")): "is not 3 finite numbers",
    model("m", BOX.format("1 1 nan")): "is not 3 finite numbers",
    model("m", BOX.format("1 1 -1")): "must be more than 0",
    model("m", BOX.format("1 1 1"), "1 2 3"): "is not 6 finite numbers",
    model("m", "<collision name='c'><geometry/></collision>"): "has no <geometry>",
    model("m", "<collision name='c'><geometry><polyline><point>0 0</point><point>1 0</point><height>1</height></polyline>"
          "</geometry></collision>"): "is open",
    "<model name='m'><link name='l'><pose relative_to='x'>0 0 0 0 0 0</pose></link></model>": "which does not exist",
    "<model name='m'><frame name='f'><pose relative_to='f'>0 0 0 0 0 0</pose></frame><link name='l'>"
    "<pose relative_to='f'>0 0 0 0 0 0</pose></link></model>": "relative to itself",
    "<model name='m'>" * 30 + "</model>" * 30: "models inside each other",
}  # fmt: skip


@pytest.mark.parametrize("body", WRONG)
def test_faults_are_told_with_file_and_cure(world, body):
    with pytest.raises((UrdfError, WorldError)) as caught:
        world(body)
    assert WRONG[body] in str(caught.value) and "yard.world" in str(caught.value) and caught.value.cure


def test_other_versions_and_other_files_are_refused(world, tmp_path):
    with pytest.raises(UrdfError, match="version '3.0'"):
        world("", "3.0")
    with pytest.raises(WorldError, match="cannot be read"):
        load_sdf(tmp_path / "nothing.world")
    with pytest.raises(UrdfError, match="no SDF"):
        read_entity("<html/>")


def test_what_is_not_understood_is_listed(world):
    body = model("m", "<collision name='c'><geometry><heightmap/></geometry></collision>") + "<population name='crowd'/>"
    notes = " ".join(world(body).notes)
    assert "heightmap" in notes and "crowd" in notes


@settings(max_examples=80, deadline=None, derandomize=True)
@given(st.integers(0, len(BURGER)), st.integers(0, 40), st.sampled_from(["", "<", "&", "nan", "-1", "'", "1e999", "<a>"]))
def test_a_damaged_robot_never_does_worse_than_a_clear_error(start, length, other):
    try:
        entity = read_entity(BURGER[:start] + other + BURGER[start + length :])
    except (UrdfError, WorldError) as error:
        assert str(error)
    else:
        assert np.isfinite(entity.robot.mass) if entity.robot else True


def test_a_sensor_on_a_joint_or_on_nothing_does_not_keep_a_robot_out_of_the_world():
    link, joint = "<link name='{}'/>", "<joint name='wrist' type='fixed'><parent link='arm'/><child link='hand'/></joint>"
    sensor = "<gazebo reference='{}'><sensor name='force' type='force_torque'/></gazebo>"
    links = link.format("arm") + link.format("hand") + joint
    force, lost = (
        read_entity(f"<robot name='r'>{links}{sensor.format(place)}</robot>").notes for place in ("wrist", "hnd")
    )
    assert len(force) == 1 and force[0].endswith("is not simulated: it sits on a joint")
    assert "there is no link 'hnd'. Did you mean 'hand'?" in lost[0]
