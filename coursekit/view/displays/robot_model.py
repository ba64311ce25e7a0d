"""RobotModel: a robot's shapes from its description, each link at its tf pose."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.nodes.gazebo.sdf_description import described
from coursekit.nodes.rviz.config import DisplayConfig
from coursekit.urdf import MeshError, Robot, UrdfError
from coursekit.urdf.shapes import link_surfaces, notes_of
from coursekit.view.scene import Pose, Scene, Thing
from coursekit.view.scene_shapes import Triangles, simpler

from .display import Display, NoTransform
from .facts import Fact, pose_facts

if TYPE_CHECKING:
    import numpy as np

    from coursekit.view.scene_stage import Stage


MOST_FACES = 10_000
"""The maximum number of faces per surface: CAD models have a hundred times more than the eye and a notebook need."""


class RobotModel(Display):
    """One robot."""

    kind = "RobotModel"

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self.robot: Robot | None = None
        self.poses: dict[str, Pose] = {}
        """The poses of the links that could be placed"""
        self._text = ""
        self._drawn: set[str] = set()

    def forget(self) -> None:
        """Forget the robot."""
        self.robot, self.poses, self._text, self._drawn = None, {}, "", set()

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Read a new description; place the links."""
        for msg in self.taken()[-1:]:
            if msg.data != self._text:
                self._read(msg.data, scene)
        if self.robot is not None:
            self._place(stage, scene)

    def redraw(self, scene: Scene) -> None:
        """Rebuild the shapes."""
        if self._text:
            self._read(self._text, scene)

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return the link, its joint and its pose."""
        joints = self.robot.joints.values() if self.robot is not None else ()
        held = [("Joint", f"{joint.name} ({joint.type})") for joint in joints if joint.child == name]
        return [("Link", name), *held, ("Frame", stage.fixed_frame), *pose_facts(thing.pose)]

    def _read(self, text: str, scene: Scene) -> None:
        scene.clear(self.key)
        self.forget()
        self._text = text
        try:
            self.robot = described(text, self.config.topic)
        except UrdfError as error:
            self.say("URDF", "Error", f"{error}")
            self.unsay("Links")
            return
        self.say("URDF", "Ok", "URDF parsed OK")
        if self.robot.faults:
            self.say("URDF", "Warn", f"{self.robot.faults[0]}")
        faults = [fault for link in self.robot.links if (fault := self._shape(link, scene))]
        if faults:
            self.say("URDF", "Error", faults[0])
        elif plain := self._plain():
            self.say("URDF", "Warn", plain[0] + (f" (and {len(plain) - 1} more)" if len(plain) > 1 else ""))

    def _plain(self) -> list[str]:
        """Return notes about meshes that are drawn without their textures."""
        assert self.robot is not None
        links = self.robot.links.values() if self.options["visual_enabled"] else ()
        shapes = [visual.geometry for link in links for visual in link.visuals]
        return [note for shape in dict.fromkeys(shapes) for note in notes_of(shape, self.robot.file)]

    def _shape(self, link: str, scene: Scene) -> str:
        assert self.robot is not None
        fault = ""
        kinds = [other for other in (False, True) if self.options["collision_enabled" if other else "visual_enabled"]]
        shapes: list[Any] = []
        for collision in kinds:
            try:
                surfaces = link_surfaces(self.robot, link, collision=collision)
            except MeshError as error:
                fault = str(error)
                continue
            for surface in surfaces:
                colour = (*surface.colour[:3], surface.colour[3] * self.options["alpha"])
                shapes.append(Triangles(*simpler((surface.vertices, surface.faces), MOST_FACES), colour))
        self._shapes = getattr(self, "_shapes", {})
        self._shapes[link] = tuple(shapes)
        return fault

    def prefix(self, stage: Stage) -> str:
        """Return the tf prefix of the links: as set, else the topic's namespace if only that exists in tf."""
        assert self.robot is not None
        told = self.options["tf_prefix"]
        if told:
            return told if told.endswith("/") else f"{told}/"
        space = self.config.topic.rpartition("/")[0].strip("/")
        root = self.robot.root
        known = stage.buffer.frames
        return f"{space}/" if space and root not in known and f"{space}/{root}" in known else ""

    def _place(self, stage: Stage, scene: Scene) -> None:
        assert self.robot is not None
        prefix, missing = self.prefix(stage), {}
        for link in self.robot.links:
            try:
                pose = stage.pose(prefix + link)
            except NoTransform as error:
                missing[prefix + link] = str(error)
                self.poses.pop(link, None)
                scene.remove(self.key, link)
                continue
            self.poses[link] = pose
            if not scene.has(self.key, link):
                scene.put(self.key, link, *self._shapes[link], pose=pose, solid=self.key)
            else:
                scene.place(self.key, link, pose)
        self._tell(missing)

    def _tell(self, missing: dict[str, str]) -> None:
        assert self.robot is not None
        total = len(self.robot.links)
        if not missing:
            self.say("Links", "Ok", f"{self.robot.name}: {total} of {total} links placed")
            return
        first, text = next(iter(missing.items()))
        more = f". The same holds for {len(missing) - 1} more of {total} links." if len(missing) > 1 else ""
        self.say("Links", "Error", text + more if first else text)
