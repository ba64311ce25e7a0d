"""Appendix C: the file that a name means, a package that brings its meshes, names that travel."""

from __future__ import annotations

import posixpath
from pathlib import Path
from typing import Any

from coursekit.grade.exercise import exercise
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work

PACKAGE = "c_signs"
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
        "str.partition gives what stands before and after the first slash.",
    ),
)
def where(work: Work) -> None:
    """The same file as the library finds, and a ValueError for other schemes."""
    from coursekit.urdf.resources import find_file

    function = work.function("where")
    for uri in URIS:
        got = _called(function, uri)
        if not isinstance(got, str):
            raise Wrong(f"where({uri!r}) as a str", repr(got)[:100])
        if not Path(got).is_absolute() or not Path(got).is_file() or not Path(got).samefile(find_file(uri)):
            tail = "/".join(Path(got).parts[-3:])
            raise Wrong(f"the file that {uri} means", f".../{tail}, which is not it", "The path after NAME is kept whole.")
    for uri in ("file:///tmp/tyre.stl", "meshes/package://tyre.stl"):
        try:
            got = function(uri)
        except ValueError:
            continue
        except Exception as error:
            raise Wrong(f"a ValueError from where({uri!r})", type(error).__name__, share=0.5) from None
        raise Wrong(f"a ValueError from where({uri!r})", repr(got)[:80], share=0.5)


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
    """All is installed, and the installed descriptions find their meshes in the installed package."""
    from coursekit.urdf import UrdfError, load
    from coursekit.urdf.model import Mesh

    share = work.built(PACKAGE) / "share" / PACKAGE
    for file in ("urdf/cone.urdf", "urdf/large_cone.urdf", "meshes/cone.stl", "meshes/large/cone.stl"):
        if not (share / file).is_file():
            there = sorted(one.relative_to(share).as_posix() for one in share.rglob("*.[us]*") if one.is_file())
            there = [one for one in there if one.endswith((".urdf", ".stl"))]
            raise Wrong(
                f"share/{PACKAGE}/{file}, installed",
                f"there are: {', '.join(there) or 'neither meshes nor descriptions'}",
                "data_files puts files flat into the folder that stands before them. Was it built since?",
                share=0.5 if len(there) >= 3 else 0.0,
            )
    large, small = ((share / f"meshes/{name}cone.stl").stat().st_size for name in ("large/", ""))
    try:
        robot = load(share / "urdf/large_cone.urdf")
    except UrdfError as error:
        raise Wrong("a description that ROS takes", error.what) from None
    names = [
        one.geometry.filename for link in robot.links.values() for one in link.visuals if isinstance(one.geometry, Mesh)
    ]
    if names != [f"package://{PACKAGE}/meshes/large/cone.stl"] or not large or not small:
        raise Wrong("large_cone.urdf with the large mesh", f"{names}", "Was the cell that writes it run?")


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
    """Names of every kind, and files that lie outside."""
    function = work.function("portable")
    root = "/home/vera/ws/src/vera_description"
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
        try:
            got = function(name, "vera_description", root, near)
        except ValueError:
            continue
        except Exception as error:
            raise Wrong(f"a ValueError for {name}", f"{type(error).__name__}: {error}", share=0.5) from None
        raise Wrong(f"a ValueError for {name}, as it is outside of {posixpath.basename(root)}/", repr(got)[:100], share=0.5)


def _package(name: str, rest: str) -> str:
    return f"package://{name}/{rest}"


def _expect(function: Any, given: tuple[str, ...], wanted: str) -> None:
    got = _called(function, *given)
    if got != wanted:
        raise Wrong(f"{wanted} for {given[0]}, with root {given[2]} and near {given[3]}", repr(got)[:100])


def _called(function: Any, *given: str) -> Any:
    try:
        return function(*given)
    except Exception as error:
        raise Wrong(f"a name for {given[0]}", f"{type(error).__name__}: {error}"[:120]) from None
