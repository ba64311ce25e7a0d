"""generate_parameter_module(), which a package's setup.py calls."""

from __future__ import annotations

import os
import sys
from itertools import pairwise
from pathlib import Path

from .generate_python_module import run

_DEVELOP, _BUILD = "--build-directory", "--build-base"
"""What colcon tells setup.py of its folder: with --symlink-install, and without."""


def generate_parameter_module(module_name: str, yaml_file: str, validation_module: str = "") -> None:
    """Write the module of a YAML file of parameters into the package that colcon builds.

    `validation_module` has the file's own checks. Called for anything but a build, it does nothing, as in ROS.
    """
    if folder := _folder(sys.argv):
        run(os.path.join(folder, f"{module_name}.py"), yaml_file, validation_module)


def _folder(words: list[str]) -> str:
    """Return the package's folder in the build: where setup.py install takes it from, or where its links are.

    >>> _folder(["setup.py", "build", "--build-base", "/ws/build/arm/build", "install"]).replace(os.sep, "/")
    '/ws/build/arm/build/lib/arm'
    >>> _folder(["setup.py", "develop", "--build-directory", "/ws/build/arm/build"]).replace(os.sep, "/")
    '/ws/build/arm/arm'
    """
    for word, folder in pairwise(words):
        build = Path(folder)
        if word == _DEVELOP:
            return str(build.parent / build.parent.name)
        if word == _BUILD:
            return str(build / "lib" / build.parent.name)
    return ""
