"""The newer Gazebo's files, those of ros2_control, and meshes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from .format import ROOT, TEXT, XML, YAML, Faults, Format, values_only
from .robots import _urdf_faults

SOURCE = ROOT / "tests" / "fixtures" / "gz_ws" / "src"
OBJ = b"mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl red\nf 1/1/1 2/1/1 3/1/1\n"
ARM = b"""<robot name="arm"><link name="base"/><link name="tip"/><joint name="j" type="revolute"><parent link="base"/>
<child link="tip"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<ros2_control name="s" type="system"><hardware><plugin>mock_components/GenericSystem</plugin>
<param name="position_state_following_offset">1</param></hardware>
<joint name="j"><command_interface name="position"><param name="min">-1</param></command_interface>
<state_interface name="position"><param name="initial_value">0.5</param></state_interface></joint>
<joint name="k"><param name="mimic">j</param><param name="multiplier">2</param><state_interface name="position"/></joint>
</ros2_control></robot>"""


def _newer_world(path: Path) -> Any:
    from coursekit.nodes.gazebo.sdf_world import load_sdf

    return load_sdf(path, newer=True)


def _newer_model(path: Path) -> Any:
    from coursekit.nodes.gazebo.sdf_world import read_entity

    return read_entity(path.read_text("utf-8", "replace"), "", path, "yard", "burger")


def _control(path: Path) -> Any:
    from coursekit.nodes.control.description import read_hardware
    from coursekit.nodes.control.hardware import GenericSystem

    _, infos = read_hardware(path.read_text("utf-8", "replace"), str(path))
    for info in infos:
        GenericSystem(info).read(0.01)
    return infos


CONTROLLED = """<robot name="c"><link name="b"/><link name="l"/><link name="r"/>
<joint name="left_wheel_joint" type="continuous"><parent link="b"/><child link="l"/></joint>
<joint name="right_wheel_joint" type="continuous"><parent link="b"/><child link="r"/></joint>
<gazebo><plugin filename="gz_ros2_control-system" name="x"><parameters>{}</parameters></plugin></gazebo></robot>"""


def _controllers(path: Path) -> Any:
    from coursekit.nodes.gazebo.sdf_world import read_entity

    return read_entity(CONTROLLED.format(path), "", None, "yard", "c")


def _bridge(path: Path) -> Any:
    from coursekit.nodes.gz.bridge_config import of_file

    return of_file(str(path))


TYPED = b"""name: "box" id: 3, pose { position: {x: -0.5 y: 1e-2} orientation <w: 1> } # what people type
sdf: '<sdf/>' "\\n" allow_renaming: true;"""


def _typed(path: Path) -> Any:
    from ros_gz_interfaces.msg import Entity, EntityFactory

    from coursekit.nodes.gz.text_format import fill

    messages = EntityFactory(), Entity()
    fill(path.read_text("utf-8", "replace"), "gz.msgs.EntityFactory", *messages)
    return messages


def _no_message() -> Faults:
    from coursekit.nodes.gz.text_format import GzTextError

    return (GzTextError,)


def _nothing() -> Faults:
    return ()


def _mesh(path: Path) -> Any:
    from coursekit.urdf import Mesh
    from coursekit.urdf.shapes import surfaces_of

    return surfaces_of(Mesh(str(path)))


_cart, _scout = SOURCE / "cart_bringup", SOURCE / "scout_gz"
_burger = SOURCE / "burger_gazebo/models/burger/model.sdf"
_pieces = (*TEXT, "{", "<", "x: ", "MODEL", "1e999", "[" * 200)
_faces = ("f 9 9 9", "v nan 0 0", "f 1/", "mtllib /etc/passwd", "#")
FORMATS = (
    Format("newer Gazebo's world", ".sdf", (_cart / "worlds/empty.world").read_bytes, _newer_world, _urdf_faults, XML),
    Format("newer Gazebo's model", ".sdf", _burger.read_bytes, _newer_model, _urdf_faults, XML),
    Format("ros2_control", ".urdf", lambda: ARM, _control, _urdf_faults, XML),
    Format("controllers", ".yaml", (_cart / "config/my_controllers.yaml").read_bytes, _controllers, _urdf_faults, YAML),
    Format("bridge", ".yaml", (_scout / "config/bridge_config.yaml").read_bytes, _bridge, _nothing, YAML),
    Format("newer Gazebo's message", ".txt", lambda: TYPED, _typed, _no_message, _pieces),
    Format("mesh", ".dae", (ROOT / "robots/meshes/rdk_x3/camera.dae").read_bytes, _mesh, values_only, XML),
    Format("mesh of OBJ", ".obj", lambda: OBJ, _mesh, values_only, _faces),
)
