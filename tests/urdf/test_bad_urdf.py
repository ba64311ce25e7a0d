"""Bad descriptions, each refused with urdfdom's words, the file, the line, the element and a cure."""

import pytest

from coursekit.urdf import UrdfError, parse
from tests.urdf.bad_robots import AB, BAD, PASSED_OVER, joint, links


@pytest.mark.parametrize("name", BAD)
def test_a_bad_robot_is_refused_with_its_place(name):
    inner, what, element, line = BAD[name]
    bound = "" if "xacro" not in inner else ' xmlns:xacro="x"'
    with pytest.raises(UrdfError) as caught:
        parse(f'<robot name="r"{bound}>\n{inner}</robot>', "my.urdf")
    error = caught.value
    assert error.what == what
    assert error.element.startswith(element)
    assert line is None or error.line == line
    assert error.cure
    assert str(error).startswith(f"my.urdf:{error.line}: {error.element}: {what}\n")


@pytest.mark.parametrize("name", PASSED_OVER)
def test_a_bad_part_of_a_link_is_reported_and_the_robot_built_as_urdfdom_does(name):
    inner, what, element, line = PASSED_OVER[name]
    robot = parse(f'<robot name="r">\n{inner}{links("b")}{joint()}</robot>', "my.urdf")
    (fault,) = robot.faults
    assert (fault.what, fault.element, fault.line) == (what, element, line)
    assert fault.cure and fault.chain[-1].endswith("element for Link [a]")
    assert robot.link("a").visuals == robot.link("a").collisions == ()


def test_a_link_keeps_what_stands_before_its_fault():
    ball = "<geometry><sphere radius='1'/></geometry>"
    first = f"<visual>{ball}</visual><visual/><collision>{ball}</collision>"
    robot = parse(f'<robot name="r"><link name="a">{first}</link></robot>')
    assert len(robot.link("a").visuals) == 1 and not robot.link("a").collisions


def test_what_urdfdom_says_nothing_of_is_a_warning():
    limit = joint('<limit lower="2" upper="1" effort="1" velocity="1"/>', "revolute")
    mimic = joint('<mimic joint="j"/>', name="k", parent="b", child="c")
    robot = parse(f'<robot name="r">{links("a", "b", "c")}{limit}{mimic}</robot>')
    assert "joint 'j' has its lower limit above the upper one" in robot.warnings[0] + robot.warnings[1]
    fixed = parse(f'<robot name="r">{links("a", "b", "c")}{joint(type_="fixed")}{mimic}</robot>')
    assert any("'k' mimics 'j', which is fixed" in warning for warning in fixed.warnings)
    assert fixed.joints["k"].mimic is None
    alone = parse(f'<robot name="r">{AB}' + joint('<mimic joint="elbow"/>', name="elbov") + "</robot>")
    assert "'elbov' mimics 'elbow', which is no joint; it moves by itself. Did you mean 'elbov'?" in alone.warnings[-1]
    assert alone.joints["elbov"].mimic is None


def test_blank_lines_before_the_declaration_are_taken_and_counted():
    text = '\n\n<?xml version="1.0"?>\n<robot name="r"><link name="a"/></robot>'
    assert parse(text).link("a").line == 4


@pytest.mark.parametrize("before", ["<!-- ------ arm ------ -->", '<?xml verison="1.0"?>', "<!-- a -- b --> <?xml?>"])
def test_what_tinyxml_takes_and_stricter_parsers_refuse_is_taken(before):
    assert parse(f'{before}\n<robot name="r">\n<link name="a"/></robot>').link("a").line == 3


def test_a_text_ends_at_its_first_zero_byte():
    assert parse('<robot name="r"><link name="a"/></robot>\0 and what an editor has left').link("a")


@pytest.mark.parametrize("wrong", ["&", "<link name=a/>", '<link name="a" <link name="b"/>'])
def test_a_fault_in_the_middle_is_not_taken_for_a_missing_end(wrong):
    with pytest.raises(UrdfError, match="Look at line 2") as caught:
        parse(f'<robot name="r">\n{wrong}</robot>')
    assert "missing" not in caught.value.cure


@pytest.mark.parametrize(
    ("text", "words", "line"),
    [
        ("", "no element found", 1),
        ('<robot name="r">\n<link name="a">', 'ends inside <link name="a">', 2),
        ('<robot name="r">\n<link name="a"></robot>', "mismatched tag", 2),
        ('<robot name="r">\n<link name="a" name="b"/></robot>', "duplicate attribute", 2),
        ('<robot name="r">\n<link name="a', "unclosed token", 2),
        ('<robot name="r"/>\n<robot name="s"/>', "junk after document element", 2),
        ("<sdf/>", "Could not find the 'robot' element in the xml file", 1),
        ("<robot/>", "No name given for the robot.", 1),
        ('<robot name="r" version="3.0"/>', "Invalid 'version' specified", 1),
        ('<robot name="r" version="new"/>', "The version attribute should be in the form 'x.y'", 1),
    ],
)
def test_what_is_no_robot_is_refused(text, words, line):
    with pytest.raises(UrdfError) as caught:
        parse(text, "my.urdf")
    assert words in str(caught.value)
    assert caught.value.line == line


BOMB = '<!DOCTYPE robot [<!ENTITY e0 "ha">'
BOMB += "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 12)) + "]>"


@pytest.mark.parametrize(
    "text",
    [
        BOMB + '<robot name="&e11;"/>',
        '<!DOCTYPE robot [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot name="r"><link name="&x;"/></robot>',
        '<!DOCTYPE robot [<!ENTITY % x SYSTEM "file:///etc/passwd">%x;]><robot name="r"><link name="a"/></robot>',
        "<robot name='r'>" + "<link>" * 100_000,
    ],
)
def test_xml_that_is_meant_to_harm_is_refused(text):
    with pytest.raises(UrdfError, match="XML parser error"):
        parse(text)


BAD_ORIGIN = joint('<origin rpy="0 0"/>')


def test_what_urdfdom_adds_is_kept():
    with pytest.raises(UrdfError) as caught:
        parse(f'<robot name="r">{AB}{BAD_ORIGIN}</robot>')
    assert caught.value.chain == (
        "Malformed parent origin element for joint [j]",
        "joint xml is not initialized correctly",
    )


def test_definitions_that_xacro_left_do_no_harm():
    text = '<robot name="r" xmlns:xacro="x"><xacro:include filename="a"/>{}</robot>'
    assert parse(text.format(links("a"))).root == "a"
    with pytest.raises(UrdfError, match="Expand the file first"):
        parse(text.format(""))


def test_a_near_name_is_offered():
    text = f'<robot name="r">{links("base_link", "wheel_link")}{joint(parent="base_lnk", child="wheel_link")}</robot>'
    with pytest.raises(UrdfError, match="Did you mean 'base_link'"):
        parse(text)


@pytest.mark.parametrize(
    "text",
    [
        '<robot><xacro:property name="w" value="1"/></robot>',
        f'<robot name="r">{AB}' + joint('<origin xyz="${w} 0 0"/>') + "</robot>",
        f'<robot name="r">{AB}' + joint('<limit lower="$(arg low)" effort="1" velocity="1"/>', "revolute") + "</robot>",
    ],
)
def test_what_xacro_has_yet_to_work_out_is_said_to_be_that(text):
    with pytest.raises(UrdfError, match="Expand the file first"):
        parse(text.replace("<robot>", '<robot xmlns:xacro="x">'))
