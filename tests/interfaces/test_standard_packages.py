"""The standard packages say what Humble's say."""

import subprocess
import sys

import pytest
from catkin_pkg.package import parse_package
from rosbags.typesys import Stores, get_typestore

from coursekit.interfaces import interface_of, load
from coursekit.interfaces.find import UNDERLAY, known_interfaces, known_packages

STORE = get_typestore(Stores.ROS2_HUMBLE)
FOREIGN = ("rosbag2_interfaces",)
SHARED = sorted(name for name in STORE.fielddefs if name.split("/")[0] not in FOREIGN)
PACKAGES = [name for name in known_packages() if (UNDERLAY / "share" / name / "package.xml").is_file()]


def ours(kind):
    base = "uint8" if kind.base == "char" else kind.base
    return f"{base}[{'<=' if kind.is_upper_bound else ''}{kind.size or ''}]" if kind.is_array else base


def theirs(description):
    node, argument = description
    if node.name == "NAME":
        return argument
    if node.name == "BASE":
        return "uint8" if argument[0] == "char" else argument[0]
    bound = f"<={argument[1]}" if node.name == "SEQUENCE" and argument[1] else argument[1] or ""
    return f"{theirs(argument[0])}[{bound}]"


@pytest.mark.parametrize("name", SHARED)
def test_fields_and_constants_are_humbles(name):
    constants, fields = STORE.fielddefs[name]
    message = interface_of(name)
    dummy = "structure_needs_at_least_one_member"
    assert [(f.name, ours(f.type)) for f in message.fields] == [
        (n, theirs(t)) for n, t in fields if n != dummy
    ]
    assert [(c.name, c.value) for c in message.constants] == [(n, v) for n, _, v in constants]


def test_every_interface_makes_classes():
    for name in known_interfaces():
        assert name == load(name)._TYPE_NAME


@pytest.mark.parametrize("name", PACKAGES)
def test_every_package_has_a_valid_manifest_and_index(name):
    package = parse_package(str(UNDERLAY / "share" / name))
    index = UNDERLAY / "share" / "ament_index" / "resource_index"
    files = sorted(
        p.parent.name + "/" + p.name
        for k in ("msg", "srv", "action")
        for p in (UNDERLAY / "share" / name / k).glob("*")
    )
    assert package.name == name
    assert (index / "packages" / name).is_file()
    assert (index / "rosidl_interfaces" / name).read_text().splitlines() == files


def test_every_package_can_be_imported_by_its_name():
    code = "import importlib, sys\nfor n in sys.argv[1:]: importlib.import_module(n)"
    names = [
        f"{p}.{k}"
        for p in PACKAGES
        for k in ("msg", "srv", "action")
        if (UNDERLAY / "share" / p / k).is_dir()
    ]
    subprocess.run([sys.executable, "-c", code, *names], check=True)


def test_defaults_that_matter_are_there():
    assert load("geometry_msgs/Pose")().orientation.w == 1.0
    assert load("rcl_interfaces/ParameterDescriptor").READ_ONLY__DEFAULT is False


def test_packages_that_workspaces_depend_on_are_there():
    goal = load("control_msgs/action/FollowJointTrajectory")
    assert goal.Result.GOAL_TOLERANCE_VIOLATED == -5 and goal.Result(error_string="late").error_string == "late"
    assert list(goal.Goal.get_fields_and_field_types())[:2] == ["trajectory", "multi_dof_trajectory"]
    assert load("control_msgs/JointComponentTolerance").ROTATION == 5
    switch = load("controller_manager_msgs/srv/SwitchController").Request
    assert (switch.BEST_EFFORT, switch.STRICT) == (1, 2)
    assert switch.get_fields_and_field_types()["timeout"] == "builtin_interfaces/Duration"
    assert load("vision_msgs/Detection2D")().bbox.center.position.x == 0.0
    assert load("vision_msgs/ObjectHypothesis")(class_id="cat").class_id == "cat"
    assert len(load("geographic_msgs/GeoPoseWithCovariance")().covariance) == 36
    loading = load("composition_interfaces/srv/LoadNode")
    assert "error_message" in loading.Response.get_fields_and_field_types()


def test_what_programs_for_a_turtlebot_4_send_and_hear_is_there():
    lights = load("irobot_create_msgs/LightringLeds")(override_system=True)
    assert len(lights.leds) == 6 and lights.leds[0].red == 0
    drive = load("irobot_create_msgs/action/DriveDistance").Goal(distance=0.5)
    assert drive.max_translation_speed == pytest.approx(0.3)
    assert load("irobot_create_msgs/action/WallFollow").Goal.FOLLOW_RIGHT == -1
    note = load("irobot_create_msgs/AudioNote")(frequency=440)
    assert load("irobot_create_msgs/action/AudioNoteSequence").Goal().iterations == 1
    assert load("irobot_create_msgs/AudioNoteVector")(notes=[note]).notes[0].frequency == 440
    assert load("irobot_create_msgs/HazardDetection").WHEEL_DROP == 4


def test_what_drivers_of_cameras_radars_and_buses_send_is_there():
    tag = load("apriltag_msgs/AprilTagDetection")(family="36h11", id=3)
    assert len(tag.corners) == 4 and tag.corners[0].x == tag.centre.y == 0.0 and len(tag.homography) == 9
    assert load("apriltag_msgs/AprilTagDetectionArray")(detections=[tag]).detections[0].id == 3
    assert len(load("can_msgs/Frame")(id=0x123, dlc=8).data) == 8
    assert load("radar_msgs/RadarScan")(returns=[load("radar_msgs/RadarReturn")(range=2.0)]).returns[0].range == 2.0
    assert load("radar_msgs/RadarTracks")().get_fields_and_field_types()["tracks"] == "sequence<radar_msgs/RadarTrack>"
    assert load("radar_msgs/RadarTrack").DYNAMIC == 2
    assert len(load("velodyne_msgs/VelodynePacket")().data) == 1206


def test_what_receivers_of_satellites_tell_beyond_a_fix_is_there():
    fix = load("gps_msgs/GPSFix")(latitude=48.1, track=90.0, err_horz=1.5)
    assert fix.position_covariance_type == fix.COVARIANCE_TYPE_UNKNOWN and len(fix.position_covariance) == 9
    assert fix.status.status == fix.status.STATUS_FIX and fix.status.STATUS_NO_FIX == -1
    assert list(load("gps_msgs/GPSStatus")(satellite_used_prn=[3, 7]).satellite_used_prn) == [3, 7]


@pytest.mark.parametrize(
    ("package", "names"),
    [
        (
            "gazebo_msgs",
            "ContactState ContactsState EntityState LinkState LinkStates ModelState ModelStates ODEJointProperties "
            "ODEPhysics PerformanceMetrics SensorPerformanceMetric WheelSlip WorldState ApplyBodyWrench ApplyJointEffort "
            "ApplyLinkWrench BodyRequest DeleteEntity DeleteLight DeleteModel GetEntityState GetJointProperties "
            "GetLightProperties GetLinkProperties GetLinkState GetModelList GetModelProperties GetModelState "
            "GetPhysicsProperties GetWorldProperties JointRequest LinkRequest SetEntityState SetJointProperties "
            "SetJointTrajectory SetLightProperties SetLinkProperties SetLinkState SetModelConfiguration SetModelState "
            "SetPhysicsProperties SpawnEntity SpawnModel",
        ),
        (
            "ros_gz_interfaces",
            "Altimeter Contact Contacts Dataframe Entity EntityFactory EntityWrench Float32Array GuiCamera JointWrench "
            "Light LogPlaybackStatistics MaterialColor ParamVec SensorNoise StringVec TrackVisual VideoRecord WorldControl "
            "WorldReset WorldStatistics ControlWorld DeleteEntity SetEntityPose SpawnEntity",
        ),
    ],
)
def test_a_simulators_interfaces_are_all_that_humble_has(package, names):
    """Programs import them together with those they need, so one that lacks stops the whole program."""
    assert {name.rpartition("/")[2] for name in known_interfaces() if name.split("/")[0] == package} == set(names.split())


def test_a_simulators_older_words_have_humbles_fields():
    state = load("gazebo_msgs/ModelState")(model_name="cart", reference_frame="world")
    assert load("gazebo_msgs/srv/SetModelState").Request(model_state=state).model_state.model_name == "cart"
    answer = load("gazebo_msgs/srv/GetModelProperties").Response
    assert list(answer.get_fields_and_field_types())[:4] == [
        "parent_model_name", "canonical_body_name", "body_names", "geom_names",
    ]  # fmt: skip
    assert load("gazebo_msgs/srv/GetJointProperties").Response.UNIVERSAL == 5
    assert load("gazebo_msgs/srv/SpawnModel").Request(robot_namespace="r").robot_namespace == "r"
    assert load("ros_gz_interfaces/GuiCamera")().track.min_dist == 0.0
    assert load("ros_gz_interfaces/SensorNoise").GAUSSIAN_QUANTIZED == 3
