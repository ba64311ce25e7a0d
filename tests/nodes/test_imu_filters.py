"""Orientations from gyroscope, gravity and north, on the virtual clock."""

import math

import pytest
from sensor_msgs.msg import Imu, MagneticField
from tf2_msgs.msg import TFMessage

from coursekit.geometry.rotation import rpy_of
from tests.nodes.friend import Friend

MADGWICK = "imu_filter_madgwick", "imu_filter_madgwick_node"
COMPLEMENTARY = "imu_complementary_filter", "complementary_filter_node"


class Unit(Friend):
    """An inertial unit that measures a hundred times a second."""

    def __init__(self, session):
        super().__init__(session)
        self.found = self.hear(Imu, "imu/data")

    def measure(self, seconds, turn=(0.0, 0.0, 0.0), roll=0.0, north=None):
        for _ in range(round(seconds * 100)):
            msg = Imu()
            msg.header.frame_id, msg.header.stamp = "imu_link", self.node.get_clock().now().to_msg()
            msg.angular_velocity.x, msg.angular_velocity.y, msg.angular_velocity.z = turn
            msg.linear_acceleration.y, msg.linear_acceleration.z = 9.81 * math.sin(roll), 9.81 * math.cos(roll)
            if north is not None:
                field = MagneticField(header=msg.header)
                field.magnetic_field.x, field.magnetic_field.y, field.magnetic_field.z = *north, -3e-5
                self.say("imu/mag", field)
                self.spin(0.001)
            self.say("imu/data_raw", msg)
            self.spin(0.01)
        q = self.found[-1].orientation if self.found else None
        return q and [round(angle, 2) for angle in rpy_of((q.x, q.y, q.z, q.w))]


@pytest.fixture
def start(session, run):
    """start((package, executable), parameter, ...) is a unit, and the filter's process."""

    def make(program, *parameters):
        process = run(*program, "--ros-args", *(word for parameter in parameters for word in ("-p", parameter)))
        unit = Unit(session)
        unit.spin(0.2)
        return unit, process

    return make


@pytest.mark.parametrize("program", [MADGWICK, COMPLEMENTARY])
def test_turns_add_up_and_gravity_tells_what_is_level(start, program):
    unit, _ = start(program, "use_mag:=false")
    assert unit.measure(2.0, turn=(0.0, 0.0, 0.5), roll=0.0) == pytest.approx([0.0, 0.0, 1.0], abs=0.02)
    assert unit.measure(4.0, roll=0.4)[0] == pytest.approx(0.4, abs=0.02)


def test_madgwick_s_gain_is_a_pace(start):
    unit, _ = start(MADGWICK, "use_mag:=false", "gain:=0.05")
    unit.measure(0.1)
    assert unit.measure(1.0, roll=0.4)[0] == pytest.approx(0.1, abs=0.01)


@pytest.mark.parametrize(("world", "yaw"), [("enu", math.pi / 2), ("nwu", 0.0)])
def test_north_tells_the_heading(start, world, yaw):
    unit, process = start(MADGWICK, f"world_frame:={world}")
    assert unit.measure(0.1) is None and "use_mag:=false" in process.output
    assert unit.measure(0.2, north=(3e-5, 0.0))[2] == pytest.approx(yaw, abs=0.02)
    assert unit.measure(8.0, north=(0.0, 3e-5))[2] == pytest.approx(yaw - math.pi / 2, abs=0.02)


def test_tf_is_published_either_way_round_and_gravity_is_taken_out(start):
    unit, _ = start(MADGWICK, "use_mag:=false", "fixed_frame:=map", "reverse_tf:=true", "remove_gravity_vector:=true")
    tf = unit.hear(TFMessage, "/tf")
    unit.measure(0.5, roll=0.3)
    frames = tf[-1].transforms[0]
    assert (frames.header.frame_id, frames.child_frame_id) == ("imu_link", "map")
    assert frames.transform.rotation.x == pytest.approx(-math.sin(0.15), abs=1e-3)
    assert unit.found[-1].orientation.x == pytest.approx(math.sin(0.15), abs=1e-3)
    felt = unit.found[-1].linear_acceleration
    assert (felt.x, felt.y, felt.z) == pytest.approx((0.0, 0.0, 0.0), abs=0.02)


def test_a_world_that_is_none_is_told(start):
    _, process = start(MADGWICK, "world_frame:=esd")
    assert "The parameter world_frame was set to invalid value 'esd'. Valid values are enu, nwu, ned." in process.output
