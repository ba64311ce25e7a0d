"""`ros2 run robot_localization navsat_transform_node`: converts positions on the Earth to odometry, and back."""

from __future__ import annotations

from typing import Any

from geographic_msgs.msg import GeoPoint
from geometry_msgs.msg import Point
from nav_msgs.msg import Odometry
from rclpy.node import Node
from rclpy.time import Time
from robot_localization.srv import FromLL, SetDatum, SetUTMZone, ToLL
from sensor_msgs.msg import Imu, NavSatFix, NavSatStatus
from tf2_ros import StaticTransformBroadcaster, TransformException

from coursekit.geometry.pose import IDENTITY, Pose, Quaternion, Vector, compose, inverse, rotate
from coursekit.geometry.rotation import rpy_of
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.robot_localization import messages, parameters
from coursekit.nodes.robot_localization.datum import Bridge, Fix, Plane, is_place, plane_at
from coursekit.nodes.robot_localization.frames import Frames
from coursekit.nodes.robot_localization.geometry import pose_of, quaternion, unit
from coursekit.nodes.robot_localization.navsat_messages import filtered, odometry
from coursekit.nodes.running import run

DEFAULTS: dict[str, Any] = {
    "frequency": 10.0, "delay": 0.0, "magnetic_declination_radians": 0.0, "yaw_offset": 0.0, "zero_altitude": False,
    "broadcast_cartesian_transform": False, "broadcast_cartesian_transform_as_parent_frame": False,
    "broadcast_utm_transform": False, "broadcast_utm_transform_as_parent_frame": False,
    "publish_filtered_gps": True, "use_odometry_yaw": False, "wait_for_datum": False, "use_local_cartesian": False,
    "transform_timeout": 0.0,
}  # fmt: skip


class NavsatTransform(Node):
    """Derives the world's pose on the Earth from the first fix, pose and heading; then converts each fix to a pose."""

    def __init__(self) -> None:
        super().__init__("navsat_transform_node")
        self._given = given = declare(self, DEFAULTS)
        if not given["frequency"] > 0:
            raise ValueError(f"frequency is {given['frequency']}: give Hz, for example 10.0")
        self._frames, self._static = Frames(self), StaticTransformBroadcaster(self)
        self._plane: Plane | None = None
        self._first: Fix | None = None
        self._world: Pose | None = None
        self._heading: Quaternion | None = None
        self._bridge: Bridge | None = None
        self._fix: NavSatFix | None = None
        self._odometry: Odometry | None = None
        self._world_frame, self._base_frame, self._gps_frame, self._zone = "odom", "base_link", "", ""
        self._manual, self._left = bool(given["wait_for_datum"]), round(given["delay"] * given["frequency"])
        datum = parameters.optional(self, "datum")
        if self._manual and datum is not None:
            if len(datum) != 3:
                raise ValueError(f"datum has {len(datum)} numbers: give latitude, longitude and heading")
            self._take_datum((datum[0], datum[1], 0.0), quaternion((0.0, 0.0, datum[2])))
        self._make_topics()

    def _make_topics(self) -> None:
        given = self._given
        self._out = self.create_publisher(Odometry, "odometry/gps", 10)
        self._filtered = self.create_publisher(NavSatFix, "gps/filtered", 10) if given["publish_filtered_gps"] else None
        self.create_subscription(Odometry, "odometry/filtered", self._hear_odometry, 10)
        self.create_subscription(NavSatFix, "gps/fix", self._hear_fix, 10)
        if not given["use_odometry_yaw"] and not self._manual:
            self.create_subscription(Imu, "imu", self._hear_imu, 10)
        self.create_service(SetDatum, "datum", self._serve_datum)
        self.create_service(FromLL, "fromLL", self._serve_from)
        self.create_service(ToLL, "toLL", self._serve_to)
        self.create_service(SetUTMZone, "setUTMZone", self._serve_zone)
        self.create_timer(1.0 / given["frequency"], self._work)

    # -- subscriptions

    def _hear_odometry(self, msg: Odometry) -> None:
        self._world_frame, self._base_frame, self._odometry = msg.header.frame_id, msg.child_frame_id, msg
        if self._bridge is None and not self._manual:
            self._world = pose_of(msg.pose.pose.position, msg.pose.pose.orientation)
            if self._given["use_odometry_yaw"]:
                self._heading = unit(msg.pose.pose.orientation)

    def _hear_fix(self, msg: NavSatFix) -> None:
        if not msg.header.frame_id:
            self.get_logger().error(
                "NavSatFix message has empty frame_id. Will assume navsat device is mounted at robot's origin", once=True
            )
        self._gps_frame, fix = msg.header.frame_id, (msg.latitude, msg.longitude, msg.altitude)
        if msg.status.status == NavSatStatus.STATUS_NO_FIX or not is_place(fix):
            return
        if self._bridge is None and not self._manual:
            self._begin(fix)
        self._fix = msg

    def _hear_imu(self, msg: Imu) -> None:
        """Store the heading, until the world's pose is known."""
        if self._bridge is not None or self._world is None:
            return
        try:
            mount = self._frames.pose(self._base_frame, msg.header.frame_id, Time.from_msg(msg.header.stamp).nanoseconds)
        except TransformException:
            return
        felt: Pose = (0.0, 0.0, 0.0, *unit(msg.orientation))
        self._heading = compose(felt, (0.0, 0.0, 0.0, *inverse(mount)[3:]))[3:]

    def _begin(self, fix: Fix) -> None:
        self._plane = plane_at(fix, local=self._given["use_local_cartesian"], zone=self._zone)
        if fix != self._first:
            self.get_logger().info("Datum (latitude, longitude, altitude) is ({:0.2f}, {:0.2f}, {:0.2f})".format(*fix))
        self._first = fix

    def _take_datum(self, fix: Fix, heading: Quaternion) -> None:
        self._manual, self._bridge, self._world, self._heading = True, None, IDENTITY, heading
        self._begin(fix)

    # -- work

    def _work(self) -> None:
        if self._left > 0:
            self._left -= 1
        elif self._bridge is None:
            self._learn()
        else:
            self._publish(self._bridge)

    def _learn(self) -> None:
        """Compute the plane's pose in the world, once a fix, a pose and a heading are known."""
        if self._plane is None or self._first is None or self._world is None or self._heading is None:
            return
        given, (roll, pitch, yaw) = self._given, rpy_of(self._heading)
        bent = self._plane.convergence(self._first)
        yaw += given["magnetic_declination_radians"] + given["yaw_offset"] + bent
        self.get_logger().info(
            f"Corrected for magnetic declination of {given['magnetic_declination_radians']:g}, user-specified offset of "
            f"{given['yaw_offset']:g} and meridian convergence of {bent:g}. Transform heading factor is now {yaw:g}"
        )
        x, y, z = self._plane.at(self._first)
        if not self._manual:
            arm = rotate(quaternion((roll, pitch, yaw)), self._arm())
            x, y, z = x - arm[0], y - arm[1], z - arm[2]
        seat: Pose = (x, y, z, *quaternion((0.0, 0.0, yaw)))
        self._bridge = Bridge(self._plane, compose(self._world, inverse(seat)))
        if given["broadcast_cartesian_transform"] or given["broadcast_utm_transform"]:
            self._tell_plane(self._bridge)

    def _tell_plane(self, bridge: Bridge) -> None:
        """Broadcast the plane's frame."""
        frames, pose, given = (self._world_frame, bridge.plane.frame), bridge.pose, self._given
        if given["broadcast_cartesian_transform_as_parent_frame"] or given["broadcast_utm_transform_as_parent_frame"]:
            frames, pose = (frames[1], frames[0]), inverse(pose)
        if given["zero_altitude"]:
            pose = (*pose[:2], 0.0, *pose[3:])
        self._static.sendTransform(messages.transform(pose, self.get_clock().now().nanoseconds, *frames))

    def _arm(self) -> Vector:
        """The receiver's position on the robot."""
        try:
            return self._frames.pose(self._base_frame, self._gps_frame, 0)[:3]
        except TransformException:
            if self._gps_frame:
                self.get_logger().error(
                    f"Unable to obtain {self._base_frame}->{self._gps_frame} transform. Will assume navsat device is "
                    "mounted at robot's origin", throttle_duration_sec=5.0,
                )  # fmt: skip
            return (0.0, 0.0, 0.0)

    def _publish(self, bridge: Bridge) -> None:
        fix, heard = self._fix, self._odometry
        if fix is not None and heard is not None:
            self._publish_pose(bridge, fix)
            self._fix = None
        if heard is not None and self._filtered is not None:
            self._filtered.publish(filtered(heard, bridge))
            self._odometry = None

    def _publish_pose(self, bridge: Bridge, fix: NavSatFix) -> None:
        """Publish the position of the robot's origin, from the receiver's fix."""
        stamp = Time.from_msg(fix.header.stamp).nanoseconds
        x, y, z = bridge.to_world((fix.latitude, fix.longitude, fix.altitude))
        try:
            lean = self._frames.pose(self._world_frame, self._base_frame, stamp)[3:]
        except TransformException:
            self.get_logger().error(
                f"Could not obtain {self._world_frame}->{self._base_frame} transform. Will not remove offset of navsat "
                "device from robot's origin.", throttle_duration_sec=5.0,
            )  # fmt: skip
        else:
            arm = rotate(lean, self._arm())
            x, y, z = x - arm[0], y - arm[1], z - arm[2]
        self._out.publish(odometry(self._point((x, y, z)), fix, bridge, self._world_frame))

    def _point(self, point: Vector) -> Point:
        x, y, z = point
        return Point(x=x, y=y, z=0.0 if self._given["zero_altitude"] else z)

    # -- services

    def _serve_datum(self, request: SetDatum.Request, response: SetDatum.Response) -> SetDatum.Response:
        place = request.geo_pose.position
        fix = (place.latitude, place.longitude, place.altitude)
        if is_place(fix):
            self._take_datum(fix, unit(request.geo_pose.orientation))
        else:
            self.get_logger().error(f"({fix[0]}, {fix[1]}, {fix[2]}) is no place on the Earth: the datum stays")
        return response

    def _serve_from(self, request: FromLL.Request, response: FromLL.Response) -> FromLL.Response:
        place = request.ll_point
        if self._bridge is None:
            self.get_logger().error("No transform available (yet)")
        elif is_place((place.latitude, place.longitude, 0.0)):
            response.map_point = self._point(self._bridge.to_world((place.latitude, place.longitude, place.altitude)))
        return response

    def _serve_to(self, request: ToLL.Request, response: ToLL.Response) -> ToLL.Response:
        point = request.map_point
        if self._bridge is None:
            self.get_logger().error("No transform available (yet)")
        else:
            latitude, longitude, altitude = self._bridge.to_earth((point.x, point.y, point.z))
            response.ll_point = GeoPoint(latitude=latitude, longitude=longitude, altitude=altitude)
        return response

    def _serve_zone(self, request: SetUTMZone.Request, response: SetUTMZone.Response) -> SetUTMZone.Response:
        """Use that UTM zone from now on."""
        try:
            plane = plane_at((0.0, 0.0, 0.0), local=False, zone=request.utm_zone)
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return response
        self._zone, self._plane, self._bridge, response.status = request.utm_zone, plane, None, True
        return response


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(NavsatTransform, args, refuses=(ValueError,))
