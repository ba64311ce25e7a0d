"""Loads Python launch files."""

from __future__ import annotations

import os
import sys
import traceback
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from types import ModuleType

from ..invalid_launch_file_error import InvalidLaunchFileError
from ..launch_description import LaunchDescription


class InvalidPythonLaunchFileError(InvalidLaunchFileError):
    """Raised if a Python launch file has no `generate_launch_description`, or if that returns no LaunchDescription."""

    def __init__(self, message: str) -> None:
        Exception.__init__(self, message)


def load_python_launch_file_as_module(python_launch_file_path: str | os.PathLike[str]) -> ModuleType:
    """Return the launch file as a module; no bytecode is written."""
    loader = SourceFileLoader("python_launch_file", os.fspath(python_launch_file_path))
    spec = spec_from_loader(loader.name, loader)
    assert spec is not None
    module = module_from_spec(spec)
    keep, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    try:
        loader.exec_module(module)
    finally:
        sys.dont_write_bytecode = keep
    return module


def get_launch_description_from_python_launch_file(
    python_launch_file_path: str | os.PathLike[str],
) -> LaunchDescription:
    """Return the result of the file's `generate_launch_description()`.

    Raises:
        InvalidPythonLaunchFileError: if the file has no such function, or if it returns no LaunchDescription.
        RuntimeError: if the file fails; the message contains the line.
    """
    path = str(python_launch_file_path)
    try:
        module = load_python_launch_file_as_module(path)
        generate = getattr(module, "generate_launch_description", None)
        if generate is None:
            raise InvalidPythonLaunchFileError(
                f"launch file at '{path}' does not contain the required function "
                "'generate_launch_description()'"
            )
        description = generate()
    except (InvalidLaunchFileError, SyntaxError, FileNotFoundError):
        raise
    except Exception as error:
        raise PythonLaunchFileFailure(error, path) from error
    if not isinstance(description, LaunchDescription):
        raise InvalidPythonLaunchFileError(
            f"'generate_launch_description()' of '{path}' must return a LaunchDescription, "
            f"got {type(description).__name__}"
        )
    return description


class PythonLaunchFileFailure(RuntimeError):
    """Raised if a Python launch file raises an exception; the message contains the line and the exception."""

    def __init__(self, error: Exception, path: str) -> None:
        name = os.path.basename(path)
        lines = [
            frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == path
        ]
        place = f"{name}:{lines[-1]}" if lines else name
        super().__init__(f"{place}: {type(error).__name__}: {error}")
