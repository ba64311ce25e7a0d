"""Sensors of the Earth: where a robot is on it, how high, its magnetism, its air; in both Gazebos."""

import pytest
from ros_gz_interfaces.msg import Altimeter, Light
from sensor_msgs.msg import FluidPressure, MagneticField, NavSatFix

from coursekit.nodes.gazebo.sdf_world import load_sdf
from coursekit.nodes.gz.bridge_types import carried_by
from coursekit.sim.spherical_coordinates import SphericalCoordinates, pressure
from coursekit.urdf import UrdfError
from tests.nodes.gz.conftest import DRIVE, WORLD

SYSTEMS = "".join(f"<plugin filename='gz-sim-{system}-system' name='x'/>"
                  for system in ("navsat", "altimeter", "magnetometer", "air-pressure"))  # fmt: skip
EARTH = """<spherical_coordinates><surface_model>EARTH_WGS84</surface_model>
<world_frame_orientation>ENU</world_frame_orientation>
<latitude_deg>48.1</latitude_deg><longitude_deg>11.6</longitude_deg><elevation>500</elevation><heading_deg>0</heading_deg>
</spherical_coordinates><magnetic_field>1e-5 2e-5 -4e-5</magnetic_field>"""
SENSOR = """<gazebo reference='laser'><sensor name='{0}' type='{0}'><topic>{0}</topic><update_rate>10</update_rate>{1}
</sensor></gazebo>"""
KINDS = {"navsat": (NavSatFix, "NavSat"), "altimeter": (Altimeter, "Altimeter"),
         "magnetometer": (MagneticField, "Magnetometer"), "air_pressure": (FluidPressure, "FluidPressure")}  # fmt: skip


@pytest.fixture
def heard(gz, run, friend, yard, cart):
    """The last message of each sensor, after a drive to the north and a turn."""

    def start(earth=EARTH, systems=SYSTEMS, blocks=None):
        file = yard(systems + earth)
        server = gz("sim", "-r", file)
        words = [f"/{topic}@{kind.__module__.split('.')[0]}/msg/{kind.__name__}[gz.msgs.{gazebo}"
                 for topic, (kind, gazebo) in KINDS.items()]  # fmt: skip
        run("ros_gz_bridge", "parameter_bridge", "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist", *words)
        drive = DRIVE.format("gz-sim-diff-drive-system", "x")
        cart_file = cart(drive, *(blocks or [SENSOR.format(sensor, "") for sensor in KINDS]))
        assert run("ros_gz_sim", "create", "-file", cart_file, "-name", "cart", "-Y", "1.5707963").wait(20) == 0, (
            server.output
        )
        got = {topic: friend.hear(kind, f"/{topic}") for topic, (kind, _) in KINDS.items()}
        friend.go(4.0, 0.5)
        return server, got

    return start


def test_a_robot_knows_where_on_the_earth_it_is(heard):
    _, got = heard()
    fixes = got["navsat"]
    there = SphericalCoordinates(48.1, 11.6, 500.0).fix(0.0, 1.9)
    assert fixes[0].latitude == pytest.approx(48.1, abs=1e-6) and fixes[0].altitude == pytest.approx(500.3, abs=0.01)
    assert (fixes[-1].latitude, fixes[-1].longitude) == pytest.approx(there[:2], abs=2e-6)
    assert fixes[-1].header.frame_id == "cart/base_footprint/navsat" and fixes[-1].status.status == 0
    assert got["altimeter"][-1].vertical_reference == pytest.approx(0.3)
    assert got["altimeter"][-1].vertical_position == 0.0
    assert got["air_pressure"][-1].fluid_pressure == pytest.approx(pressure(0.3), abs=0.1)


def test_magnetism_turns_with_the_robot(heard):
    _, got = heard()
    field = got["magnetometer"][-1].magnetic_field
    assert (field.x, field.y, field.z) == pytest.approx((2e-5, -1e-5, -4e-5), abs=1e-8)


def test_without_a_place_on_the_earth_there_are_no_fixes_and_it_is_said(heard):
    server, got = heard(earth="")
    assert not got["navsat"] and got["altimeter"]
    assert "navsat publishes nothing, as in Gazebo: add <spherical_coordinates> to the <world>" in server.output


def test_without_its_system_each_is_silent_and_says_which_line_is_missing(heard):
    server, got = heard(systems="")
    assert not any(got.values())
    for system, name in (("navsat", "NavSat"), ("air-pressure", "AirPressure")):
        assert f'<plugin filename="gz-sim-{system}-system" name="gz::sim::systems::{name}"/>' in server.output


def test_noise_is_in_metres(heard):
    noise = "<navsat><position_sensing><horizontal><noise type='gaussian'><stddev>{}</stddev></noise></horizontal>{}"
    more = "<vertical><noise type='gaussian'><stddev>2.0</stddev></noise></vertical></position_sensing></navsat>"
    _, got = heard(blocks=[SENSOR.format("navsat", noise.format("0.5", more))])
    fixes = got["navsat"]
    away = [abs(fix.longitude - 11.6) * 74_000 for fix in fixes]
    assert 0.05 < sum(away) / len(away) < 2.0 and max(abs(fix.altitude - 500.3) for fix in fixes) > 0.5


def test_numbers_that_are_none_are_told(tmp_path):
    (tmp_path / "w.sdf").write_text(WORLD.format(plugins=EARTH.replace("48.1", "north")))
    with pytest.raises(UrdfError, match="'north' is not 1 finite number"):
        load_sdf(tmp_path / "w.sdf", newer=True)
    (tmp_path / "w.sdf").write_text(WORLD.format(plugins=EARTH.replace("48.1", "120")))
    with pytest.raises(UrdfError, match="latitude_deg of 120"):
        load_sdf(tmp_path / "w.sdf", newer=True)


def test_lights_and_heights_are_bridged():
    assert carried_by("ros_gz_interfaces/msg/Altimeter", "ignition.msgs.Altimeter").endswith("Altimeter")
    assert carried_by("ros_gz_interfaces/msg/Light", "gz.msgs.Light").endswith("Light")
    assert (Light.POINT, Light.SPOT, Light.DIRECTIONAL) == (0, 1, 2) and Light().intensity == 0.0


def test_a_receiver_of_gazebo_classic(run, friend, cart, tmp_path):
    plugin = """<gazebo reference='laser'><sensor name='gps' type='gps'><update_rate>5</update_rate>
    <gps><position_sensing><horizontal><noise type='gaussian'><mean>0.0</mean><stddev>0.01</stddev></noise></horizontal>
    </position_sensing></gps><plugin name='receiver' filename='libgazebo_ros_gps_sensor.so'><ros><namespace>/gps</namespace>
    <remapping>~/out:=fix</remapping></ros></plugin></sensor></gazebo>"""
    (tmp_path / "w.world").write_text(WORLD.format(plugins=EARTH))
    for world, latitude in (((), 0.0), ((str(tmp_path / "w.world"),), 48.1)):
        server = run("gazebo_ros", "gzserver", *world)
        assert run("gazebo_ros", "spawn_entity.py", "-file", cart(plugin), "-entity", "cart").wait(20) == 0
        fixes = friend.hear(NavSatFix, "/gps/fix")
        friend.spin(1.0)
        assert fixes[-1].latitude == pytest.approx(latitude, abs=1e-5) and fixes[-1].header.frame_id == "laser"
        assert fixes[-1].position_covariance[0] == pytest.approx(1e-4)
        server.interrupt()
        server.wait(5)


@pytest.mark.parametrize(("newer", "heading", "east", "north"), [(True, 0, 10, 0), (True, 90, 0, 10), (False, 180, 10, 0),
                                                                 (False, 0, -10, 0), (False, 90, 0, 10)])  # fmt: skip
def test_classic_turns_its_world_on_the_earth_by_half_a_circle(tmp_path, newer, heading, east, north):
    """Ten metres along x, for the newer one's and Classic's <heading_deg>."""
    (tmp_path / "w.world").write_text(WORLD.format(plugins=EARTH.replace("<heading_deg>0", f"<heading_deg>{heading}")))
    globe = load_sdf(tmp_path / "w.world", newer=newer).world.globe
    there = SphericalCoordinates(48.1, 11.6, 500.0).place(*globe.fix(10.0, 0.0))
    assert there[:2] == pytest.approx((east, north), abs=1e-6)
