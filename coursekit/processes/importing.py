"""Whether a thread is importing what all programs of this interpreter share.

An exception in the midst of such an import would break the library for every later program: Python takes the module back,
but keeps the parts of it that are complete, and they do not fit the module that the next import makes.
"""

from __future__ import annotations

from types import FrameType

from coursekit.systems.library_files import is_library_file

from .thread_frames import thread_frames


def is_importing(ident: int) -> bool:
    """Return whether a thread executes the import system's own code, or a module that programs share."""
    frame = thread_frames().get(ident)
    if frame is not None and frame.f_code.co_filename.startswith("<frozen importlib"):
        return True
    while frame is not None:
        if _begins_a_shared_module(frame):
            return True
        frame = frame.f_back
    return False


def _begins_a_shared_module(frame: FrameType) -> bool:
    """Whether the frame is a module's first run; a program is no module, and a workspace's modules are its own."""
    code = frame.f_code
    if code.co_name != "<module>" or frame.f_globals.get("__name__") == "__main__":
        return False
    return is_library_file(code.co_filename)
