"""Appendix C: the file behind a name, a package that brings its meshes, portable names."""

from __future__ import annotations

import os
import posixpath
import re
from pathlib import Path
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.plain import called, shown, text
from coursekit.grade.stopped_function import error_of
from coursekit.grade.verdict import NO_HINT, Wrong
from coursekit.grade.work import Work

PACKAGE = "c_signs"
FLAT = "data_files copies files flat into the folder in front of them. Did you build after the change?"
OLDER = "In install/ it is a file of an older build, which colcon leaves there: is it still in data_files?"
URIS = (
    "package://coursekit_robots/meshes/rdk_x3/tyre.stl",
    "package://turtlesim/package.xml",
    "package://urdf_tutorial/urdf/01-myfirst.urdf",
)


@exercise(
    "appc.q1",
    "Do it yourself",
    points=1,
    hints=(
        "Cut the text in two at the first slash after package://. Which ROS function knows the folder of the first part?",
        "str.partition returns the parts before and after the first slash.",
    ),
)
def where(work: Work) -> None:
    """Check for the same file as the library finds, and a ValueError for other schemes."""
    from coursekit.urdf.resources import find_file

    function = work.function("where")
    for uri in URIS:
        wanted = f"the file that {uri} means"
        got = text(called(function, uri, told=f"where({uri!r})"), f"where({uri!r}) as a str")
        if not _is_file(got, find_file(uri)):
            path = got.replace(os.sep, "/")
            tail = shown("/".join(path.split("/")[-3:]), 80)
            whole = "The path after NAME is kept whole."
            cause = whole if "/share/" in path else "A package's files are in its share folder, not in its prefix."
            raise Wrong(wanted, gave=f"...{tail}, which is not it", cause=cause, hint=0)
    for uri in ("file:///tmp/tyre.stl", "meshes/package://tyre.stl"):
        _expect_value_error(function, (uri,), f"a ValueError from where({uri!r})")


def _is_file(path: str, right: Path) -> bool:
    try:
        return Path(path).is_absolute() and Path(path).is_file() and Path(path).samefile(right)
    except (OSError, ValueError):
        return False


def _expect_value_error(function: Any, given: tuple[str, ...], wanted: str, hint: int = NO_HINT) -> None:
    try:
        got = function(*given)
    except ValueError:
        return
    except NotImplementedError:
        raise
    except Exception as error:
        raise Wrong(wanted, error_of(error), share=0.5, hint=hint) from None
    raise Wrong(wanted, gave=shown(got), share=0.5, hint=hint)


@exercise(
    "appc.q2",
    "The large cone",
    points=2,
    hints=(
        "Each target folder needs a pair of its own: meshes/ and meshes/large/ are two.",
        "After a change in setup.py build again, and look with %show install/c_signs/share/c_signs",
    ),
)
def large_cone(work: Work) -> None:
    """Check that everything is installed, and that the installed descriptions find their meshes in that package."""
    work.built(PACKAGE)
    wanted = ("urdf/cone.urdf", "urdf/large_cone.urdf", "meshes/cone.stl", "meshes/large/cone.stl")
    places = [f"install/{folder}share/{PACKAGE}/" for folder in (f"{PACKAGE}/", "")]
    share = next((place for place in places if work.exists(place + "package.xml")), places[0])
    there = [file for file in wanted if work.installed(PACKAGE, file)]
    for file in wanted:
        if file not in there:
            older = work.exists(share + file)
            raise Wrong(
                f"share/{PACKAGE}/{file}, installed",
                f"of the four files the last build installed: {', '.join(there) or 'none'}",
                OLDER if older else FLAT,
                share=0.5 if len(there) >= 3 else 0.0,
                hint=1 if len(there) >= 3 else 0,
            )
    work.robot(share + "urdf/large_cone.urdf")
    names = re.findall(r'filename\s*=\s*["\']([^"\']*)', work.text(share + "urdf/large_cone.urdf"))
    if names != [f"package://{PACKAGE}/meshes/large/cone.stl"]:
        raise Wrong("large_cone.urdf with the large mesh", shown(names), "Was the cell that writes it run?")
    mesh = "meshes/large/cone.stl"
    if not work.text(share + mesh) or work.text(share + mesh) != work.text(f"src/{PACKAGE}/{mesh}"):
        raise Wrong(f"{mesh}, installed as it is in src/", "another file", "Which folder does the pattern name?")


@exercise(
    "appc.q3",
    "A description that travels",
    points=2,
    hints=(
        "First make one absolute path of all that is not package://; posixpath.join leaves absolute ones alone.",
        "posixpath.normpath removes . and .. ; is /a/robots in /a/robot?",
    ),
)
def travels(work: Work) -> None:
    """Check names of every kind, and files outside."""
    function, number = work.function("portable"), work.dice("appc.q3").randint(2, 99)
    root = f"/home/vera{number}/ws/src/vera_description"
    near = f"{root}/urdf"
    inside = {
        f"{root}/meshes/hull.stl": "meshes/hull.stl",
        f"file://{root}/meshes/left/arm.dae": "meshes/left/arm.dae",
        "../meshes/hull.stl": "meshes/hull.stl",
        "./parts/../wheel.stl": "urdf/wheel.stl",
        "wheel.stl": "urdf/wheel.stl",
        f"{near}/../meshes/./eye.stl": "meshes/eye.stl",
    }
    for name, rest in inside.items():
        _expect(function, (name, "vera_description", root, near), _package("vera_description", rest))
    _expect(function, ("a.stl", "arm", "/opt/arm/", "/opt/arm/"), _package("arm", "a.stl"))
    other = "package://other_description/meshes/hand.stl"
    _expect(function, (other, "vera_description", root, near), other)
    for name in ("../../other/hull.stl", f"{root}s/hull.stl", "file:///tmp/hull.stl", f"{root}/../hull.stl"):
        wanted = f"a ValueError for {name}, as it is outside of {posixpath.basename(root)}/"
        _expect_value_error(function, (name, "vera_description", root, near), wanted, hint=1)


def _package(name: str, rest: str) -> str:
    return f"package://{name}/{rest}"


def _expect(function: Any, given: tuple[str, ...], right: str) -> None:
    wanted = f"{right} for {given[0]}, with root {given[2]} and near {given[3]}"
    got = text(called(function, *given, told=f"portable({given[0]!r}, ...)"), wanted)
    if got != right:
        kept = given[0] == right
        cause = "Names that begin with package:// stay as they are." if kept else ""
        raise Wrong(wanted, gave=shown(got), cause=cause, hint=NO_HINT if kept else 0)
