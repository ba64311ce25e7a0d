"""Sensors of the newer Gazebo, which publish without a plugin on their own topics."""

from __future__ import annotations

from coursekit.geometry.plane import Array
from coursekit.urdf.xml_tree import Element

from .devices import CameraDevice, DepthDevice, Device, ImuDevice, RayDevice, TouchDevice
from .gz_plugins import NODE, GzNames
from .model_file import ModelFile, ModelLink
from .ray_messages import CLOUD
from .sensor_elements import EARTH, earth_of, lidar_of, picture_of, shakes_of
from .value_parsing import number, pose

LIDARS, CAMERAS = ("gpu_lidar", "lidar", "ray", "gpu_ray"), ("camera", "depth_camera", "depth", "rgbd_camera", "rgbd")


def devices_of(sensor: Element, link: ModelLink, model: ModelFile, floor: float) -> list[Device]:
    """Return the devices of a sensor on a link, with notes on unsupported parts. `floor` is its z in the model."""
    kind, name = sensor.get("type") or "", sensor.get("name") or "sensor"
    names = GzNames(model.newer or "default", model.name)
    body = model.lumped.get(link.name, link.name)
    frame = sensor.tell("gz_frame_id") or sensor.tell("ignition_frame_id") or f"{model.name}/{body}/{name}"
    rate = number(sensor, "update_rate", 0.0) or {"imu": 100.0, "camera": 30.0}.get(kind, 10.0)
    usual = names.sensor(body, name)
    told = sensor.tell("topic").strip("/")
    where = link.pose @ pose(sensor)
    if kind in LIDARS:
        return _lidar(sensor, f"/{told}" if told else f"{usual}/scan", frame, rate, where, model, floor)
    if kind == "imu":
        return [ImuDevice(f"/{told}" if told else f"{usual}/imu", frame, rate, NODE, *shakes_of(sensor))]
    if kind in EARTH:
        return [earth_of(sensor, f"/{told}" if told else f"{usual}/{kind}", frame, rate, NODE, where, floor)]
    if kind in CAMERAS:
        return [_camera(sensor, kind, told, usual, frame, rate, where)]
    if kind == "contact":
        topic = sensor.tell("contact/topic").strip("/") or told
        return [TouchDevice(f"/{topic}" if topic else f"{usual}/contact", frame, rate, NODE, link.name)]
    known = ", ".join(("gpu_lidar", "imu", "camera", "depth_camera", "contact", *(name for name in EARTH if name != "gps")))
    model.note(sensor, f"of type '{kind}' is not simulated; simulated are {known}")
    return []


def _lidar(
    sensor: Element, topic: str, frame: str, rate: float, where: Array, model: ModelFile, floor: float
) -> list[Device]:
    ray = sensor.first("lidar") or sensor.first("ray")
    if ray is None:
        raise sensor.error("has no <lidar>", "Say <lidar><scan><horizontal>... and <range>.")
    lidar = lidar_of(sensor, ray, rate, where, model, floor)
    return [RayDevice(topic, frame, rate, NODE, lidar), RayDevice(f"{topic}/points", frame, rate, NODE, lidar, CLOUD)]


def _camera(sensor: Element, kind: str, told: str, usual: str, frame: str, rate: float, where: Array) -> Device:
    camera = sensor.first("camera")
    width, height, fov = picture_of(sensor, camera)
    frame = (camera.tell("optical_frame_id") if camera is not None else "") or frame
    both, depth = kind.startswith("rgbd"), kind.startswith("depth")
    base = f"/{told}" if told else usual
    picture = f"{base}/image" if both or not told else base
    depths = f"{base}/depth_image" if both or not told else base
    info = f"{base}/camera_info" if both or not told else f"{base.rpartition('/')[0]}/camera_info"
    named = camera.tell("camera_info_topic").strip("/") if camera is not None else ""
    device = CameraDevice(
        picture, frame, rate, NODE, f"/{named}" if named else info, width, height, fov, number(camera, "clip/far", 100.0),
        where @ pose(camera), "rgb8", number(camera, "noise/stddev", 0.0),
    )  # fmt: skip
    if not (both or depth):
        return device
    reach = number(camera, "clip/near", 0.1), number(camera, "clip/far", 100.0)
    cloud = f"{base}/points" if both else f"{depths}/points"
    words = {**vars(device), "topic": "" if depth else device.topic}
    return DepthDevice(**words, reach=reach, depth_topic=depths, depth_info_topic="", cloud_topic=cloud)


def lumped(parents: dict[str, tuple[str, str, str]], kept: frozenset[str] = frozenset()) -> dict[str, str]:
    """Map each link to the link into which fixed joints merge it, as sdformat does with URDF.

    `parents` has (joint, its type, parent) of each link; joints in `kept` are not merged.

    >>> lumped({"base": ("a", "fixed", "foot"), "laser": ("b", "fixed", "base"), "wheel": ("c", "continuous", "base")})
    {'base': 'foot', 'laser': 'foot', 'wheel': 'wheel'}
    """
    lumped: dict[str, str] = {}
    for link in parents:
        at = link
        while at in parents and parents[at][1] == "fixed" and parents[at][0] not in kept and parents[at][2] != "world":
            at = parents[at][2]
        lumped[link] = at
    return lumped


__all__ = ["devices_of", "lumped"]
