"""Checks that links and joints form one tree."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from .errors import UrdfError, close
from .model import Joint, Link
from .xml_tree import Element

MOST_NAMES = 12
"""Maximum number of names reported for a loop."""
_TREE = "Failed to build tree: "
_ROOT = "Failed to find root link: "


def _element(root: Element, tag: str, name: str) -> Element:
    return next(element for element in root.all(tag) if element.get("name") == name)


def find_root(root: Element, links: Mapping[str, Link], joints: Mapping[str, Joint]) -> str:
    """Return the only link without a parent; raises UrdfError if the joints do not form one tree of the links."""
    elements = {element.get("name"): element for element in root.all("joint")}
    for joint in joints.values():
        _check_ends(elements[joint.name], joint, links)
    above: dict[str, Joint] = {}
    for joint in joints.values():
        if joint.child in above:
            raise _two_parents(root, above[joint.child], joint)
        above[joint.child] = joint
    tops = [name for name in links if name not in above]
    if not tops:
        raise _loop(root, next(iter(links)), above, _ROOT + "No root link found. The robot xml is not a valid tree.")
    if len(tops) > 1:
        raise _two_roots(root, tops)
    reached = {tops[0]}
    for name in links:
        if name not in reached and not _climbs(name, above, reached):
            raise _loop(root, name, above, f"{_TREE}link [{name}] is not connected to the root [{tops[0]}]")
    return tops[0]


def _check_ends(element: Element, joint: Joint, links: Mapping[str, Link]) -> None:
    if not joint.parent or not joint.child:
        what = f"{_TREE}Joint [{joint.name}] is missing a parent and/or child link specification."
        raise element.error(what, 'A joint has both <parent link="..."/> and <child link="..."/>.')
    if joint.child not in links:
        what = f"{_TREE}child link [{joint.child}] of joint [{joint.name}] not found"
        end = element.first("child") or element
        raise end.error(what, f'{close(joint.child, links)} Or add <link name="{joint.child}"/>.')
    if joint.parent not in links:
        what = (
            f"{_TREE}parent link [{joint.parent}] of joint [{joint.name}] not found.  This is not valid according to "
            "the URDF spec. Every link you refer to from a joint needs to be explicitly defined in the robot "
            f"description. To fix this problem you can either remove this joint [{joint.name}] from your urdf file, or "
            f'add "<link name="{joint.parent}" />" to your urdf file.'
        )
        end = element.first("parent") or element
        raise end.error(what, close(joint.parent, links))


def _two_parents(root: Element, first: Joint, second: Joint) -> UrdfError:
    what = f"{_TREE}link [{second.child}] is the child of two joints: [{first.name}] and [{second.name}]"
    cure = (
        f"Joint [{first.name}] in line {first.line} hangs it on [{first.parent}], joint [{second.name}] on "
        f"[{second.parent}]. A link hangs on one joint only: remove one of them, or give it another child."
    )
    return _element(root, "joint", second.name).error(what, cure)


def _two_roots(root: Element, tops: list[str]) -> UrdfError:
    what = f"{_ROOT}Two root links found: [{tops[0]}] and [{tops[1]}]"
    more = f" ({len(tops)} in all: {', '.join(tops)})" if len(tops) > 2 else ""
    cure = f"All links but one are the child of a joint{more}: add a joint with <child link=\"{tops[1]}\"/>."
    return _element(root, "link", tops[1]).error(what, cure)


def _climbs(name: str, above: Mapping[str, Joint], reached: set[str]) -> bool:
    """Whether the path up ends at a link known to be below the root; then all links on the path become known, too."""
    way: set[str] = set()
    while name not in reached:
        if name in way:
            return False
        way.add(name)
        name = above[name].parent
    reached.update(way)
    return True


def _loop(root: Element, start: str, above: Mapping[str, Joint], what: str) -> UrdfError:
    """Return the error that names the loop at the end of the path up from `start`."""
    way: dict[str, None] = {}
    while start not in way:
        way[start] = None
        start = above[start].parent
    names = [*way]
    loop = [*names[names.index(start) :], start][::-1]
    last = above[loop[-1]]
    shown = loop if len(loop) <= MOST_NAMES else [*loop[: MOST_NAMES - 2], "...", loop[-1]]
    cure = f"The links go round in a loop: {' -> '.join(shown)}. Remove one of its joints, for example [{last.name}]."
    return _element(root, "joint", last.name).error(what, cure)


def check_mimics(root: Element, joints: Mapping[str, Joint], warnings: list[str]) -> dict[str, Joint]:
    """Return the joints, with mimics of fixed or unknown joints removed; UrdfError if one mimics itself."""
    elements = {element.get("name"): element.first("mimic") or element for element in root.all("joint")}
    checked = dict(joints)
    for joint in joints.values():
        if joint.mimic is None:
            continue
        element, leader = elements[joint.name], joint.mimic.joint
        if leader not in joints or not joints[leader].moves:
            place = f"{element.file or 'robot description'}:{element.line}"
            why = joints[leader].type if leader in joints else "no joint"
            hint = "" if leader in joints else f" {close(leader, joints)}"
            warnings.append(f"{place}: joint '{joint.name}' mimics '{leader}', which is {why}; it moves by itself.{hint}")
            checked[joint.name] = replace(joint, mimic=None)
    free = {name for name, joint in checked.items() if joint.mimic is None}
    for name in checked:
        way = _leaders(name, checked, free)
        if way[-1] in way[:-1]:
            loop = way[way.index(way[-1]) :]
            what = f"Found an infinite recursive mimic chain: joint [{loop[0]}] mimics itself: {' -> '.join(loop)}"
            raise elements[loop[0]].error(what, "One of them has to move by itself: remove its <mimic>.")
        free.update(way)
    return checked


def _leaders(name: str, joints: Mapping[str, Joint], free: set[str]) -> list[str]:
    """Return the chain of joints that a mimic joint follows, up to a free one, or to the first repeated one."""
    way: dict[str, None] = {}
    while name not in free and name not in way:
        way[name] = None
        mimic = joints[name].mimic
        assert mimic is not None
        name = mimic.joint
    return [*way, name]


__all__ = ["check_mimics", "find_root"]
