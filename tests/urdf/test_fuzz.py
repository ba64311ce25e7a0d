"""Whatever is done to a description, the answer is a robot or a UrdfError."""

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

import coursekit.urdf
from coursekit.urdf import Robot, UrdfError, parse
from coursekit.urdf.kinematics import Kinematics

SHARE = Path(coursekit.urdf.__file__).parents[1] / "share" / "coursekit_robots" / "urdf"
SOUND = (SHARE / "r2d2.urdf").read_text(encoding="utf-8")
PIECES = ["<", ">", "/", '"', "&", "&#0;", "&lt;", "<!--", "]]>", "<![CDATA[", "nan", "1e999", "0 0", "-1"]
PIECES += ["\x00", "é", "\ud800", "<link/>", '<link name="head"/>', "</robot>", "<joint>"]
PIECES += ['name="base_link"', "<origin/>", "xyz=", "<geometry>", "<?x?>"]


def robot_or_fault(text):
    try:
        robot = parse(text, "fuzz.urdf")
    except UrdfError as error:
        assert str(error) and error.what
        return
    assert isinstance(robot, Robot)
    assert len(Kinematics(robot).poses()) == len(robot.links)


@settings(deadline=None)
@given(st.integers(0, len(SOUND)))
def test_a_truncated_description_is_a_fault(end):
    robot_or_fault(SOUND[:end])


@settings(max_examples=300, deadline=None)
@given(st.lists(st.tuples(st.integers(0, len(SOUND)), st.integers(0, 30), st.sampled_from(PIECES)), min_size=1, max_size=4))
def test_a_damaged_description_is_a_robot_or_a_fault(damages):
    text = SOUND
    for place, removed, piece in damages:
        text = text[:place] + piece + text[place + removed :]
    robot_or_fault(text)


WORDS = st.sampled_from(["a", "b", "c", "", "0 0 1", "x", "nan", "revolute", "fixed", "continuous", "1"])
NAMES = st.sampled_from(["name", "type", "link", "joint", "xyz", "rpy", "value", "ixx", "lower", "upper", "effort"])
TAGS = st.sampled_from(
    ["link", "joint", "parent", "child", "origin", "axis", "limit", "mimic", "visual", "geometry", "box", "inertial"]
)


def written(tag, attributes, inner):
    given_ = " ".join(f'{name}="{value}"' for name, value in attributes.items())
    return f"<{tag} {given_}>{''.join(inner)}</{tag}>"


def element(children):
    return st.builds(
        written,
        TAGS,
        st.dictionaries(NAMES, WORDS, max_size=3),
        st.lists(children, max_size=4),
    )


@settings(max_examples=300, deadline=None)
@given(st.lists(st.recursive(st.just(""), element, max_leaves=8), max_size=6))
def test_any_tree_of_elements_is_a_robot_or_a_fault(parts):
    robot_or_fault(f'<robot name="r">{"".join(parts)}</robot>')
