"""Cars: gazebo_ros_ackermann_drive."""

import math

import pytest

from coursekit.nodes.gazebo.devices import OdometryDevice
from coursekit.nodes.gazebo.sdf_world import read_entity
from coursekit.sim import Simulation
from coursekit.sim.world import World
from coursekit.urdf import UrdfError

WHEEL = """<link name='{0}'><pose>{1} {2} 0.3 1.5707963 0 0</pose><collision name='c'><geometry>
<cylinder><radius>0.3</radius><length>0.2</length></cylinder></geometry></collision></link>
<joint name='{0}_joint' type='revolute'><parent>body</parent><child>{0}</child></joint>"""
PLACES = {"fl": (1.6, 0.7), "fr": (1.6, -0.7), "rl": (-0.9, 0.7), "rr": (-0.9, -0.7)}
CAR = """<sdf version='1.6'><model name='car'><link name='body'><inertial><mass>900</mass></inertial><collision name='c'>
<pose>0.3 0 0.7 0 0 0</pose><geometry><box><size>3.6 1.5 0.8</size></box></geometry></collision></link>{0}
<joint name='steer_joint' type='revolute'><parent>body</parent><child>fl</child></joint>
<plugin name='drive' filename='libgazebo_ros_ackermann_drive.so'><front_left_joint>fl_joint</front_left_joint>
<front_right_joint>fr_joint</front_right_joint><rear_left_joint>rl_joint</rear_left_joint>
<rear_right_joint>rr_joint</rear_right_joint><left_steering_joint>steer_joint</left_steering_joint>
<max_steer>0.5</max_steer><max_speed>5</max_speed><publish_odom>true</publish_odom></plugin></model></sdf>"""


def car(places):
    return CAR.format("".join(WHEEL.format(name, *place) for name, place in places.items()))


def test_a_car_goes_round_as_its_front_wheels_say():
    entity = read_entity(car(PLACES), "taxi")
    device = next(candidate for candidate in entity.devices if isinstance(candidate, OdometryDevice))
    assert (device.topic, device.command_topic, device.base_frame) == ("/taxi/odom", "/taxi/cmd_vel", "base_link")
    simulation = Simulation(World("yard"))
    robot = simulation.spawn(entity.robot, "car")
    robot.command(2.0, 9.9)
    radius = 2.5 / math.tan(0.5)
    simulation.advance(math.pi * radius / 2.0)
    assert robot.angles["steer_joint"] == 0.5, "no farther than they go"
    assert robot.place.y == pytest.approx(2 * radius, rel=0.1) and abs(robot.place.theta) == pytest.approx(math.pi, abs=0.15)
    robot.command(0.0, 0.3)
    simulation.advance(2.0)
    before = robot.place.theta
    simulation.advance(1.0)
    assert robot.place.theta == pytest.approx(before, abs=1e-6), "a car that stands does not turn"


def test_a_car_without_wheels_is_told():
    with pytest.raises(UrdfError, match="all in one place"):
        read_entity(car(dict.fromkeys(PLACES, (0.0, 0.0))))
    with pytest.raises(UrdfError, match="not found"):
        read_entity(car(PLACES).replace("<rear_left_joint>rl_joint", "<rear_left_joint>none"))
