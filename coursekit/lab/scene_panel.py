"""The common parts of panels that draw in 3D: MeshCat in the page, a stream of changes to it, a still picture."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Protocol

from coursekit.view.scene import Scene
from coursekit.view.scene_camera import Camera

from .bundle import with_picture
from .panel import Panel
from .viewer_stream import Stream


class SceneStage(Protocol):
    """The stage of such a panel."""

    lock: Any
    """Held while it changes."""
    scene: Scene

    def update(self) -> Scene:
        """Bring the scene up to date."""

    def seen(self) -> bool:
        """Whether what one looks at is there."""

    def camera(self) -> Camera:
        """From where to look."""

    def images(self) -> list[Any]:
        """Displays with pictures that are shown beside the scene."""

    def png(self, width: int = 640, height: int = 400) -> bytes:
        """A still picture."""


class ScenePanel(Panel):
    """The base of `viewer` and `world_view`. A subclass sets `stage`, then calls `stream`."""

    stage: SceneStage

    def stream(self) -> None:
        """From now on pages may draw."""
        self._stream = Stream(self)

    def png(self, width: int = 640, height: int = 400) -> bytes:
        """A still picture of what is shown now."""
        self.stage.update()
        return self.stage.png(width, height)

    def _repr_mimebundle_(self, **options: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**options), self.png)

    def on_library(self, _message: dict[str, Any]) -> None:
        """The page has no MeshCat yet."""
        import meshcat

        code = Path(meshcat.__file__).parent / "viewer" / "dist" / "main.min.js"
        self.send({"type": "library"}, buffers=[code.read_bytes()])

    def on_open(self, _message: dict[str, Any]) -> None:
        """A page is ready to draw."""
        self._stream.open()

    def on_home(self, _message: dict[str, Any]) -> None:
        """The camera goes back to where it was at first."""
        self.look_anew()

    def look_anew(self) -> None:
        """Tell the page where to look from, also when a hand has moved its camera."""
        self._stream.look_anew()

    def hurry(self) -> None:
        """Tell the page the texts beside the picture with the next one."""
        self._stream.hurry()

    def follows(self) -> list[float] | None:
        """The place [m, m, m, rad] of what the camera goes with; None: it does not move."""
        return None

    def marked(self) -> int | None:
        """The number of the thing that was clicked, as it is now; None: nothing."""
        return None

    def on_drawn(self, message: dict[str, Any]) -> None:
        """A page has drawn."""
        self._stream.drawn(int(message.get("n", 0)))

    def leave(self) -> None:
        """Send no more."""
        self._stream.close()


__all__ = ["ScenePanel", "SceneStage"]
