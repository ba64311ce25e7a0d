"""The common parts of panels that draw in 3D: MeshCat in the page, a stream of changes, a still picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Protocol

from coursekit.view.scene import Scene
from coursekit.view.scene_camera import Camera

from .bundle import with_picture
from .panel import Panel
from .viewer_stream import Stream


class SceneStage(Protocol):
    """The stage of a 3D panel."""

    lock: Any
    """Held while the stage changes."""
    scene: Scene

    def update(self) -> Scene:
        """Bring the scene up to date."""

    def seen(self) -> bool:
        """Whether the object that the camera looks at exists."""

    def camera(self) -> Camera:
        """Return the camera."""

    def images(self) -> list[Any]:
        """Return the displays whose pictures are shown beside the scene."""

    def png(self, width: int = 640, height: int = 400) -> bytes:
        """Return a still picture."""


class ScenePanel(Panel):
    """The base of `viewer` and `world_view`. A subclass sets `stage`, then calls `stream`."""

    stage: SceneStage

    def stream(self) -> None:
        """Start the stream: pages may draw from now on."""
        self._stream = Stream(self)

    def png(self, width: int = 640, height: int = 400) -> bytes:
        """Return a still picture of the current scene."""
        self.stage.update()
        return self.stage.png(width, height)

    def _repr_mimebundle_(self, **options: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**options), self.png)

    def on_library(self, _message: dict[str, Any]) -> None:
        """Handle a page that lacks MeshCat: send its code."""
        import meshcat

        code = Path(meshcat.__file__).parent / "viewer" / "dist" / "main.min.js"
        self.send({"type": "library"}, buffers=[code.read_bytes()])

    def on_open(self, _message: dict[str, Any]) -> None:
        """Handle a page that is ready to draw."""
        self._stream.open()

    def on_home(self, _message: dict[str, Any]) -> None:
        """Handle the home button: reset the camera."""
        self.look_anew()

    def look_anew(self) -> None:
        """Send the camera to the page, also if the user has moved it there."""
        self._stream.look_anew()

    def hurry(self) -> None:
        """Send the texts beside the picture with the next update."""
        self._stream.hurry()

    def follows(self) -> list[float] | None:
        """Return the pose [m, m, m, rad] of the frame that the camera follows; None: it is fixed."""
        return None

    def marked(self) -> int | None:
        """Return the current number of the selected object; None if there is none."""
        return None

    def on_drawn(self, message: dict[str, Any]) -> None:
        """Handle a page's acknowledgement of a drawn message."""
        self._stream.drawn(int(message.get("n", 0)))

    def leave(self) -> None:
        """Stop the stream."""
        self._stream.close()


__all__ = ["ScenePanel", "SceneStage"]
