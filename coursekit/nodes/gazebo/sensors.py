"""`<sensor>` elements as devices."""

from __future__ import annotations

from coursekit.geometry.plane import Array
from coursekit.sim.spherical_coordinates import SphericalCoordinates
from coursekit.urdf.xml_tree import Element

from .devices import BumpDevice, CameraDevice, DepthDevice, Device, ImuDevice, RayDevice
from .model_file import ModelFile, ModelLink
from .ray_messages import CLOUD, LASER, RAY_TYPES
from .ros_names import RosNames, names_of
from .sensor_elements import earth_of, lidar_of, picture_of, shakes_of
from .value_parsing import number, pose

RAYS = ("ray", "gpu_ray", "lidar", "gpu_lidar")
CAMERAS = ("camera", "wideanglecamera", "depth", "depth_camera", "rgbd_camera")
ENCODINGS = {"R8G8B8": "rgb8", "RGB_INT8": "rgb8", "B8G8R8": "bgr8", "BGR_INT8": "bgr8", "L8": "mono8", "L_INT8": "mono8"}
"""Image formats in SDF and in messages."""


def sensed(sensor: Element, link: ModelLink, model: ModelFile, namespace: str, floor: float) -> list[Device]:
    """Return the devices of a sensor on a link, with notes on unsupported parts. `floor` is its z in the model."""
    kind = sensor.get("type") or ""
    plugin = sensor.first("plugin")
    names = names_of(plugin, namespace) if plugin is not None else RosNames(sensor.get("name") or kind, namespace)
    if plugin is None:
        model.note(sensor, "has no plugin: it publishes nothing")
        return []
    frame = plugin.tell("frame_name") or plugin.tell("frameName") or link.name
    rate = number(sensor, "update_rate", 0.0) or {"imu": 100.0, "camera": 30.0}.get(kind, 10.0)
    where = link.pose @ pose(sensor)
    if kind in RAYS:
        return [_ray(sensor, plugin, names, frame, rate, where, model, floor)]
    if kind == "imu":
        topic = names.topic(plugin.tell("topicName") or "~/out")
        return [ImuDevice(topic, frame, rate, names.full_node, *shakes_of(sensor))]
    if kind == "gps":
        usual = SphericalCoordinates(heading=180.0)
        return [earth_of(sensor, names.topic("~/out"), frame, rate, names.full_node, where, floor, usual)]
    if kind in CAMERAS:
        return [_camera(sensor, sensor.first("camera"), "", names, frame, rate, where, model)]
    if kind == "multicamera":
        return [
            _camera(sensor, camera, f"/{camera.get('name') or 'camera'}", names, frame, rate, where, model)
            for camera in sensor.all("camera")
        ]
    if kind == "contact":
        topic = plugin.tell("bumperTopicName") or "bumper_states"
        return [BumpDevice(names.topic(topic), frame, rate, names.full_node, link.name)]
    model.note(sensor, f"of type '{kind}' is not simulated; simulated are ray, imu, camera, depth, contact and gps")
    return []


def _ray(
    sensor: Element, plugin: Element, names: RosNames, frame: str, rate: float, where: Array, model: ModelFile, floor: float
) -> Device:
    ray = sensor.first("ray") or sensor.first("lidar")
    if ray is None:
        raise sensor.error("has no <ray>", "Say <ray><scan><horizontal>... and <range>.")
    output = _output(plugin, model)
    lidar = lidar_of(sensor, ray, rate, where, model, floor)
    old = plugin.tell("topicName")
    sound = plugin.tell("radiation_type").lower() == "ultrasound"
    return RayDevice(names.topic(old or "~/out"), frame, rate, names.full_node, lidar, output, int(not sound))


def _output(plugin: Element, model: ModelFile) -> str:
    """Return the message type of a ray sensor; the plugin's default is a cloud."""
    told = plugin.tell("output_type")
    if told in RAY_TYPES:
        return told
    if told:
        model.note(plugin, f"publishes {told}, which is not simulated: {LASER} is published instead")
    elif "gazebo_ros_ray_sensor" in (plugin.get("filename") or ""):
        model.note(plugin, f"has no <output_type>: it publishes {CLOUD}, as in Gazebo")
        return CLOUD
    return LASER


def _camera(
    sensor: Element, camera: Element | None, eye: str, names: RosNames, frame: str, rate: float, where: Array,
    model: ModelFile,
) -> Device:  # fmt: skip
    """Return a camera; `eye` is a part of its topics if the sensor has several cameras."""
    plugin = sensor.first("plugin")
    assert plugin is not None
    name = plugin.tell("camera_name") or plugin.tell("cameraName") or sensor.get("name") or "camera"
    name += eye
    width, height, fov = picture_of(sensor, camera)
    image, info = (names.topic(f"{name}/{topic}") for topic in ("image_raw", "camera_info"))
    told = camera.tell("image/format") if camera is not None else ""
    if told and told not in ENCODINGS:
        model.note(sensor, f"has pictures of format {told}, which is not simulated: R8G8B8 is published")
    device = CameraDevice(
        image, frame, rate, names.full_node, info, width, height, fov, number(camera, "clip/far", 100.0),
        where @ pose(camera), ENCODINGS.get(told, "rgb8"), number(camera, "noise/stddev", 0.0),
    )  # fmt: skip
    if "depth" not in (sensor.get("type") or "") and sensor.get("type") != "rgbd_camera":
        return device
    depth, depth_info, cloud = (
        names.topic(f"{name}/{topic}") for topic in ("depth/image_raw", "depth/camera_info", "points")
    )
    reach = number(plugin, "min_depth", 0.4), number(plugin, "max_depth", 3.0)
    return DepthDevice(**vars(device), reach=reach, depth_topic=depth, depth_info_topic=depth_info, cloud_topic=cloud)


__all__ = ["sensed"]
