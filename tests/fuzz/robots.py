"""Robots, worlds, and what is looked at them with."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .format import MAPS, ROOT, SHARE, XML, YAML, Faults, Format, values_only


def _urdf(path: Path) -> Any:
    from coursekit.urdf import load

    return load(path)


def _urdf_faults() -> Faults:
    from coursekit.sim import WorldError
    from coursekit.urdf import UrdfError

    return UrdfError, WorldError, OSError


XACRO = b"""<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="wide" default="0.5"/>
<xacro:property name="w" value="${2*0.25 + len('ab')}"/>
<xacro:macro name="part" params="name x:=1 *inside"><link name="${name}">
<visual><geometry><box size="${x} $(arg wide) ${w}"/></geometry></visual></link><xacro:insert_block name="inside"/>
</xacro:macro>
<xacro:part name="base"><link name="tool"/></xacro:part><xacro:if value="${w &gt; 1}"><joint name="j" type="fixed">
<parent link="base"/><child link="tool"/></joint></xacro:if></robot>"""


def _sdf(path: Path) -> Any:
    from coursekit.nodes.gazebo.sdf_world import load_sdf

    return load_sdf(path)


SDF = b"""<?xml version="1.0"?><sdf version="1.6"><world name="yard"><gravity>0 0 -9.8</gravity>
<include><uri>model://ground_plane</uri></include>
<model name="box"><static>true</static><pose>3 0 0.5 0 0 0.3</pose><link name="l"><collision name="c"><geometry>
<box><size>1 1 1</size></box></geometry></collision><visual name="v"><geometry><cylinder><radius>1</radius><length>2</length>
</cylinder></geometry></visual></link></model>
<model name="cart"><link name="base"><inertial><mass>1</mass></inertial><collision name="c"><geometry>
<sphere><radius>0.2</radius></sphere></geometry></collision><sensor name="s" type="ray"><ray><scan><horizontal>
<samples>9</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan><range><min>0.1</min><max>9</max></range>
</ray></sensor></link><link name="w"/><link name="v"/>
<joint name="a" type="revolute"><parent>base</parent><child>w</child><axis><xyz>0 1 0</xyz></axis></joint>
<joint name="b" type="revolute"><parent>base</parent><child>v</child><axis><xyz>0 1 0</xyz></axis></joint>
<plugin name="d" filename="libgazebo_ros_diff_drive.so"><left_joint>a</left_joint><right_joint>b</right_joint></plugin>
</model>
<state world_name="yard"><model name="box"><pose>1 2 0 0 0 0</pose></model></state></world></sdf>"""


def _world(path: Path) -> Any:
    from coursekit.sim import load_world

    return load_world(path)


def _rviz(path: Path) -> Any:
    from coursekit.nodes.rviz import config_file

    return config_file.read(path)


def _camera(path: Path) -> Any:
    from camera_info_manager import loadCalibrationFile

    return loadCalibrationFile(str(path), "left")


def _camera_faults() -> Faults:
    from camera_info_manager import CameraInfoError

    return (CameraInfoError,)


CAMERA = b"""image_width: 640
image_height: 480
camera_name: left
camera_matrix: {rows: 3, cols: 3, data: [500, 0, 320, 0, 500, 240, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0.1, -0.2, 0, 0, 0]}
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [500, 0, 320, 0, 0, 500, 240, 0, 0, 0, 1, 0]}
"""


FORMATS = (
    Format("URDF", ".urdf", (SHARE / "coursekit_robots/urdf/r2d2.urdf").read_bytes, _urdf, _urdf_faults, XML),
    Format("xacro", ".urdf.xacro", lambda: XACRO, _urdf, _urdf_faults, XML),
    Format("SDF", ".world", lambda: SDF, _sdf, _urdf_faults, XML),
    Format("world", ".yaml", (MAPS / "worlds" / "robot_world.yaml").read_bytes, _world, _urdf_faults, YAML),
    Format("viewer's configuration", ".rviz", (ROOT / "coursekit/share/nav2_bringup/rviz/nav2_default_view.rviz").read_bytes,
           _rviz, values_only, YAML),
    Format("calibration", ".yaml", lambda: CAMERA, _camera, _camera_faults, YAML),
)  # fmt: skip
