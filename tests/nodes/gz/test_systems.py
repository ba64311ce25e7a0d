"""Systems and sensors of the newer Gazebo, one by one: drives, motors, poses, cameras, contacts."""

import math

import pytest
from builtin_interfaces.msg import Duration
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from ros_gz_interfaces.msg import Contacts
from sensor_msgs.msg import CameraInfo, Image, JointState, PointCloud2
from std_msgs.msg import Float32, Float64
from tf2_msgs.msg import TFMessage
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from coursekit.nodes.gazebo.sdf_world import read_entity
from coursekit.urdf import UrdfError
from tests.nodes.gz.conftest import CART, DRIVE

SYSTEM = "<gazebo><plugin filename='gz-sim-{}-system' name='x'>{}</plugin></gazebo>"
SENSOR = "<gazebo reference='laser'><sensor name='s' type='{}'>{}</sensor></gazebo>"
WHEELS = "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>"
DIFF = DRIVE.format("gz-sim-diff-drive-system", "gz::sim::systems::DiffDrive")


@pytest.fixture
def put(gz, run, yard, cart):
    """Put a cart with these blocks into the yard, and bridge these words."""

    def start(*blocks, bridge=(), at="0"):
        server = gz("sim", "-r", yard())
        run("ros_gz_bridge", "parameter_bridge", *bridge)
        words = ("-file", cart(*blocks), "-name", "cart", "-x", at)
        assert run("ros_gz_sim", "create", *words).wait(20) == 0, server.output
        return server

    return start


def test_topics_and_frames_that_are_not_named_are_gazebo_s_own():
    scan = "<lidar><scan><horizontal><samples>9</samples><max_angle>1</max_angle></horizontal></scan></lidar>"
    block = SYSTEM.format("diff-drive", WHEELS) + SENSOR.format("gpu_lidar", scan)
    entity = read_entity(CART.format(blocks=block), "", None, "yard", "my_bot")
    odometry, lidar, cloud = entity.devices
    assert (odometry.topic, odometry.command_topic, odometry.tf_topic) == tuple(
        f"/model/my_bot/{topic}" for topic in ("odometry", "cmd_vel", "tf")
    )
    assert (odometry.frame, odometry.base_frame) == ("my_bot/odom", "my_bot/base_footprint")
    usual = "/world/yard/model/my_bot/link/base_footprint/sensor/s/scan"
    assert (lidar.topic, cloud.topic, lidar.frame) == (usual, f"{usual}/points", "my_bot/base_footprint/s")


def test_a_joint_that_stays_a_joint_keeps_its_link():
    kept = "<gazebo reference='l'><preserveFixedJoint>true</preserveFixedJoint></gazebo>"
    entity = read_entity(CART.format(blocks=kept + SENSOR.format("imu", "")), "", None, "yard", "c")
    assert entity.devices[0].frame == "c/laser/s"


@pytest.mark.parametrize(
    ("block", "says"),
    [
        (SYSTEM.format("diff-drive", WHEELS.replace(">left_joint", ">none")), "joint [none] not found"),
        (SYSTEM.format("diff-drive", ""), "needs as many <left_joint> as <right_joint>"),
        (SYSTEM.format("diff-drive", WHEELS + "<wheel_radius>0</wheel_radius>"), "has wheels of radius 0 m"),
        (SYSTEM.format("diff-drive", WHEELS + "<wheel_radius>big</wheel_radius>"), "'big' is not 1 finite number"),
        (SENSOR.format("gpu_lidar", ""), "has no <lidar>"),
        (SENSOR.format("camera", "<camera><image><width>3</width></image></camera>"), "has pictures of 3x240"),
    ],
)
def test_what_cannot_work_is_told_with_its_line(block, says):
    with pytest.raises(UrdfError) as caught:
        read_entity(CART.format(blocks=block), "", None, "yard", "cart")
    assert says in str(caught.value) and caught.value.line


def test_plugins_of_the_other_gazebo_are_told_in_both_worlds():
    classic = "<gazebo><plugin filename='libgazebo_ros_diff_drive.so' name='x'/></gazebo>"
    (note,) = read_entity(CART.format(blocks=classic), "", None, "yard", "cart").notes
    assert "is Gazebo Classic's" in note
    (note,) = read_entity(CART.format(blocks=DIFF)).notes
    assert "start its world with ros_gz_sim" in note


def test_odometry_publisher_tells_the_truth(put, friend):
    named = "<odom_topic>truth</odom_topic><robot_base_frame>base</robot_base_frame>"
    publisher = SYSTEM.format("odometry-publisher", named)
    words = "/truth@nav_msgs/msg/Odometry[gz.msgs.Odometry", "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist"
    put(DIFF, publisher, bridge=words, at="-1")
    truth = friend.hear(Odometry, "/truth")
    friend.go(2.0, 0.2)
    assert truth[-1].pose.pose.position.x == pytest.approx(-0.6, abs=0.05) and truth[-1].child_frame_id == "base"


def test_a_car_turns_as_fast_as_it_is_told(put, friend):
    steering = "".join(f"<{side}_steering_joint>{side}_joint</{side}_steering_joint>" for side in ("left", "right"))
    sizes = "<wheel_base>0.3</wheel_base><wheel_separation>0.22</wheel_separation><wheel_radius>0.05</wheel_radius>"
    words = WHEELS + steering + sizes + "<topic>cmd_vel</topic><odom_topic>odom</odom_topic>"
    bridge = "/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry", "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist"
    put(SYSTEM.format("ackermann-steering", words), bridge=bridge)
    odometry = friend.hear(Odometry, "/odom")
    friend.go(2.0, 0.3, 0.4)
    assert odometry[-1].twist.twist.angular.z == pytest.approx(0.4, rel=0.1)


def test_a_joint_goes_where_its_controller_is_told(put, friend):
    motor = SYSTEM.format("joint-position-controller", "<joint_name>left_joint</joint_name><topic>arm</topic>")
    motor += SYSTEM.format("joint-controller", "<joint_name>right_joint</joint_name>")
    motor += SYSTEM.format("joint-state-publisher", "")
    words = (
        "/arm@std_msgs/msg/Float64]gz.msgs.Double",
        "/model/cart/joint/right_joint/cmd_vel@std_msgs/msg/Float64]gz.msgs.Double",
        "/world/yard/model/cart/joint_state@sensor_msgs/msg/JointState[gz.msgs.Model",
    )  # fmt: skip
    put(motor, bridge=words)
    states = friend.hear(JointState, "/world/yard/model/cart/joint_state")
    friend.spin(0.2)
    for topic, value in (("/arm", 1.2), ("/model/cart/joint/right_joint/cmd_vel", 0.5)):
        friend.node.create_publisher(Float64, topic, 10).publish(Float64(data=value))
    friend.spin(2.0)
    at = dict(zip(states[-1].name, states[-1].position, strict=True))
    assert at["left_joint"] == pytest.approx(1.2) and at["right_joint"] == pytest.approx(1.0, abs=0.05)


FOLLOWS = "joint-trajectory-controller"
FOLLOWED = (
    "/way@trajectory_msgs/msg/JointTrajectory]gz.msgs.JointTrajectory",
    "/way_progress@std_msgs/msg/Float32[gz.msgs.Float",
    "/world/yard/model/cart/joint_state@sensor_msgs/msg/JointState[gz.msgs.Model",
)


def way(*points, names=("left_joint", "right_joint")):
    """Positions of the joints, each with its time [s]."""
    trajectory_points = [
        JointTrajectoryPoint(positions=list(map(float, at)), time_from_start=Duration(sec=time)) for at, time in points
    ]
    return JointTrajectory(joint_names=list(names), points=trajectory_points)


def test_joints_follow_a_trajectory_point_by_point_and_progress_is_told(put, friend):
    words = "<topic>way</topic><joint_name>left_joint</joint_name><joint_name>right_joint</joint_name>"
    put(SYSTEM.format(FOLLOWS, words) + SYSTEM.format("joint-state-publisher", ""), bridge=FOLLOWED)
    states, progress = friend.hear(JointState, "/world/yard/model/cart/joint_state"), friend.hear(Float32, "/way_progress")
    out = friend.node.create_publisher(JointTrajectory, "/way", 10)
    friend.spin(0.3)
    out.publish(way(([0.5, -0.5], 1), ([1.0, 0.25], 2)))
    for seconds, wanted, told in ((0.6, (0.5, -0.5), []), (1.0, (1.0, 0.25), [0.5]), (1.0, (1.0, 0.25), [0.5, 1.0])):
        friend.spin(seconds)
        at = dict(zip(states[-1].name, states[-1].position, strict=True))
        assert (at["left_joint"], at["right_joint"]) == pytest.approx(wanted)
        assert [message.data for message in progress] == told
    out.publish(way(([9.0], 1), names=["left_joint"]))
    friend.spin(0.5)
    assert dict(zip(states[-1].name, states[-1].position, strict=True))["left_joint"] == pytest.approx(9.0)


def test_a_trajectory_without_its_joints_or_times_is_told_and_moves_nothing(put, friend):
    server = put(SYSTEM.format(FOLLOWS, "<topic>way</topic>") + SYSTEM.format("joint-state-publisher", ""), bridge=FOLLOWED)
    states = friend.hear(JointState, "/world/yard/model/cart/joint_state")
    out = friend.node.create_publisher(JointTrajectory, "/way", 10)
    friend.spin(0.3)
    for bad in (
        way(([1.0], 1)), way(([1.0, math.nan], 1)), way(([1.0, 1.0], 2), ([1.0, 1.0], 1)), way(([1.0], 1), names=["elbow"]),
    ):  # fmt: skip
        out.publish(bad)
        friend.spin(0.5)
    assert max(map(abs, states[-1].position)) == 0.0
    assert server.output.count("JointTrajectoryController of cart") == 4, server.output


def test_a_pose_publisher_tells_model_and_links(put, friend):
    put(DIFF, SYSTEM.format("pose-publisher", "<publish_model_pose>true</publish_model_pose>"),
        bridge=["/model/cart/pose@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V"], at="-1")  # fmt: skip
    poses = friend.hear(TFMessage, "/model/cart/pose")
    friend.spin(1.0)
    frames = {transform.child_frame_id: transform for transform in poses[-1].transforms}
    assert frames["cart"].header.frame_id == "yard" and frames["cart"].transform.translation.x == pytest.approx(-1.0)
    turned = frames["cart/left_wheel"].transform.rotation
    assert frames["cart/laser"].transform.translation.z == pytest.approx(0.3) and math.isfinite(turned.w)


def test_what_never_moves_has_a_topic_of_its_own(put, friend):
    told = "<publish_link_pose>true</publish_link_pose><static_publisher>true</static_publisher>"
    kept = "<gazebo reference='l'><preserveFixedJoint>true</preserveFixedJoint></gazebo>"
    words = [f"/model/cart/{topic}@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V" for topic in ("pose", "pose_static")]
    put(SYSTEM.format("pose-publisher", told + "<static_update_frequency>2</static_update_frequency>"), kept, bridge=words)
    moving, static = friend.hear(TFMessage, "/model/cart/pose"), friend.hear(TFMessage, "/model/cart/pose_static")
    friend.spin(1.2)
    frames = [{transform.child_frame_id for transform in msgs[-1].transforms} for msgs in (moving, static)]
    assert {"cart/left_wheel", "cart/right_wheel"} <= frames[0] and "cart/laser" in frames[1] and not frames[0] & frames[1]
    assert len(moving) > 20 and len(static) in (2, 3)


def test_cameras_publish_where_gazebo_s_do(put, friend, run):
    depth = SENSOR.format("rgbd_camera", "<topic>eye</topic><update_rate>5</update_rate><camera><image><width>64</width>"
                          "<height>48</height></image></camera>")  # fmt: skip
    info = "/eye/camera_info@sensor_msgs/msg/CameraInfo[gz.msgs.CameraInfo"
    cloud = "/eye/points@sensor_msgs/msg/PointCloud2[gz.msgs.PointCloudPacked"
    put(depth, bridge=[info, cloud])
    run("ros_gz_image", "image_bridge", "/eye/image", "/eye/depth_image")
    friend.spin(1.0)
    kinds = ("image", Image), ("depth_image", Image), ("camera_info", CameraInfo), ("points", PointCloud2)
    heard = [friend.hear(kind, f"/eye/{topic}") for topic, kind in kinds]
    friend.spin(3.0)
    assert [msgs[-1].width for msgs in heard] == [64] * 4
    assert [heard[0][-1].encoding, heard[1][-1].encoding] == ["rgb8", "32FC1"]


def test_the_optical_frame_that_a_camera_names_is_that_of_its_pictures():
    told = "<gz_frame_id>laser</gz_frame_id><camera><optical_frame_id>eye_optical</optical_frame_id></camera>"
    entity = read_entity(
        CART.format(blocks=SENSOR.format("camera", told) + SENSOR.format("imu", told)), "", None, "yard", "c"
    )
    assert [device.frame for device in entity.devices] == ["eye_optical", "laser"]


def test_a_contact_sensor_tells_what_is_touched(put, friend):
    touch = SENSOR.format("contact", "<contact><collision>c</collision><topic>bump</topic></contact>")
    bridge = "/bump@ros_gz_interfaces/msg/Contacts[gz.msgs.Contacts", "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist"
    put(DIFF, touch, bridge=bridge, at="1")
    contacts = friend.hear(Contacts, "/bump")
    friend.go(0.5, 0.1)
    assert not contacts
    friend.go(5.0, 0.5)
    assert contacts[-1].contacts[0].collision2.name == "post"


def test_a_planar_robot_goes_aside(put, friend):
    bridge = "/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry", "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist"
    put(SYSTEM.format("mecanum-drive", "<topic>cmd_vel</topic><odom_topic>odom</odom_topic>"), bridge=bridge)
    odometry = friend.hear(Odometry, "/odom")
    twist = Twist()
    twist.linear.y = 0.2
    friend.say("cmd_vel", twist)
    friend.spin(2.0)
    assert odometry[-1].pose.pose.position.y == pytest.approx(0.4, abs=0.05)
