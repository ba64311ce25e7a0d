"""Bad robots: inner text, what urdfdom says, the element and its line in the file (the robot's tag is line 1)."""

INERTIA = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'


def links(*names):
    return "".join(f'<link name="{name}"/>\n' for name in names)


def joint(inner="", type_="continuous", name="j", parent="a", child="b"):
    return f'<joint name="{name}" type="{type_}">\n<parent link="{parent}"/>\n<child link="{child}"/>\n{inner}</joint>\n'


def visual(inner):
    return f'<link name="a">\n<visual>{inner}</visual>\n</link>'


def inertial(inner):
    return f'<link name="a">\n<inertial>\n{inner}</inertial>\n</link>'


AB = links("a", "b")
"""Two links in the lines 2 and 3; a joint begins in line 4."""


BAD = {
    "two roots": (AB, "Failed to find root link: Two root links found: [a] and [b]", '<link name="b">', 3),
    "no root": (
        AB + joint() + joint(name="k", parent="b", child="a"),
        "Failed to find root link: No root link found. The robot xml is not a valid tree.",
        "<joint",
        None,
    ),
    "loop beside the root": (
        links("o", "a", "b") + joint() + joint(name="k", parent="b", child="a"),
        "Failed to build tree: link [a] is not connected to the root [o]",
        "<joint",
        None,
    ),
    "two parents": (
        links("o", "a", "b") + joint() + joint(name="k", parent="o") + joint(name="l", parent="o", child="a"),
        "Failed to build tree: link [b] is the child of two joints: [j] and [k]",
        '<joint name="k">',
        9,
    ),
    "unknown parent": (
        AB + joint(parent="zz"),
        "Failed to build tree: parent link [zz] of joint [j] not found.  This is not valid according to the URDF spec. "
        "Every link you refer to from a joint needs to be explicitly defined in the robot description. To fix this "
        'problem you can either remove this joint [j] from your urdf file, or add "<link name="zz" />" to your urdf file.',
        '<parent> of <joint name="j">',
        5,
    ),
    "unknown child": (
        AB + joint(child="zz"),
        "Failed to build tree: child link [zz] of joint [j] not found",
        '<child> of <joint name="j">',
        6,
    ),
    "no parent": (
        AB + '<joint name="j" type="fixed"><child link="b"/></joint>',
        "Failed to build tree: Joint [j] is missing a parent and/or child link specification.",
        '<joint name="j">',
        4,
    ),
    "link twice": (links("a", "a"), "link 'a' is not unique.", '<link name="a">', 3),
    "joint twice": (
        links("a", "b", "c") + joint() + joint(parent="b", child="c"),
        "joint 'j' is not unique.",
        '<joint name="j">',
        9,
    ),
    "material twice": (
        '<material name="m"><color rgba="1 0 0 1"/></material>\n' * 2 + links("a"),
        "material 'm' is not unique.",
        '<material name="m">',
        3,
    ),
    "no links": ("", "No link elements found in urdf file", '<robot name="r">', 1),
    "link without name": ("<link/>", "No name given for the link.", "<link>", 2),
    "joint without name": (AB + '<joint type="fixed"/>', "unnamed joint found", "<joint>", 4),
    "joint without type": (
        AB + '<joint name="j"/>',
        "joint [j] has no type, check to see if it's a reference.",
        '<joint name="j">',
        4,
    ),
    "unknown type": (AB + joint(type_="wheel"), "Joint [j] has no known type [wheel]", '<joint name="j">', 4),
    "revolute without limit": (
        AB + joint(type_="revolute"),
        "Joint [j] is of type REVOLUTE but it does not specify limits",
        '<joint name="j">',
        4,
    ),
    "prismatic without limit": (
        AB + joint(type_="prismatic"),
        "Joint [j] is of type PRISMATIC without limits",
        '<joint name="j">',
        4,
    ),
    "limit without effort": (
        AB + joint('<limit lower="0" upper="1" velocity="1"/>', "revolute"),
        "joint [j]: limit has no effort",
        '<limit> of <joint name="j">',
        7,
    ),
    "short axis": (
        AB + joint('<axis xyz="0 0"/>'),
        "Malformed axis element for joint [j]: Parser found 2 elements but 3 expected while parsing vector [0 0]",
        '<axis> of <joint name="j">',
        7,
    ),
    "axis of letters": (
        AB + joint('<axis xyz="0 0 z"/>'),
        "Malformed axis element for joint [j]: Unable to parse component [z] to a double (while parsing a vector value)",
        '<axis> of <joint name="j">',
        7,
    ),
    "axis without direction": (
        AB + joint('<axis xyz="0 0 0"/>'),
        "Malformed axis element for joint [j]: the axis [0 0 0] has no direction",
        '<axis> of <joint name="j">',
        7,
    ),
    "axis without numbers": (
        AB + joint("<axis/>"),
        "Malformed axis element for joint [j]: no xyz attribute",
        '<axis> of <joint name="j">',
        7,
    ),
    "origin with commas": (
        AB + joint('<origin xyz="1,2,3"/>'),
        "Unable to parse component [1,2,3] to a double (while parsing a vector value)",
        '<origin> of <joint name="j">',
        7,
    ),
    "origin of nan": (
        AB + joint('<origin xyz="nan 0 0"/>'),
        "Unable to parse component [nan] to a double (while parsing a vector value)",
        '<origin> of <joint name="j">',
        7,
    ),
    "mimic of itself": (
        AB + joint('<mimic joint="j"/>'),
        "Found an infinite recursive mimic chain: joint [j] mimics itself: j -> j",
        '<mimic> of <joint name="j">',
        7,
    ),
    "mimic without joint": (
        AB + joint("<mimic/>"),
        "joint mimic: no mimic joint specified",
        '<mimic> of <joint name="j">',
        7,
    ),
    "dynamics of letters": (
        AB + joint('<dynamics damping="x"/>'),
        "damping value (x) is not a valid float",
        '<dynamics> of <joint name="j">',
        7,
    ),
    "negative mass": (
        inertial(f'<mass value="-1"/>{INERTIA}'),
        "Inertial: mass [-1] is negative",
        '<mass> of <link name="a">',
        4,
    ),
    "negative size": (
        visual('<geometry><sphere radius="-1"/></geometry>'),
        "radius [-1] is negative",
        '<sphere> of <link name="a">',
        3,
    ),
    "negative length": (
        visual('<geometry><cylinder length="-1" radius="1"/></geometry>'),
        "length [-1] is negative",
        '<cylinder> of <link name="a">',
        3,
    ),
    "xacro": ("<xacro:wheel/>", "<xacro:wheel> is xacro, not URDF", "<xacro:wheel>", 2),
}


PASSED_OVER = {
    "no mass": (
        inertial(INERTIA),
        "Inertial element must have a mass element",
        '<inertial> of <link name="a">',
        3,
    ),
    "mass in words": (
        inertial(f'<mass value="2 kg"/>{INERTIA}'),
        "Inertial: mass [2 kg] is not a float",
        '<mass> of <link name="a">',
        4,
    ),
    "half an inertia": (
        inertial('<mass value="1"/><inertia ixx="1" ixy="0"/>'),
        "Inertial: inertia element missing ixz attribute",
        '<inertia> of <link name="a">',
        4,
    ),
    "no geometry": (visual(""), "<visual> has no geometry", '<visual> of <link name="a">', 3),
    "empty geometry": (
        visual("<geometry/>"),
        "Geometry tag contains no child element.",
        '<geometry> of <link name="a">',
        3,
    ),
    "unknown shape": (
        visual('<geometry><cone radius="1"/></geometry>'),
        "Unknown geometry type 'cone'",
        '<cone> of <link name="a">',
        3,
    ),
    "sphere without radius": (
        visual("<geometry><sphere/></geometry>"),
        "Sphere shape must have a radius attribute",
        '<sphere> of <link name="a">',
        3,
    ),
    "mesh without file": (
        visual("<geometry><mesh/></geometry>"),
        "Mesh must contain a filename attribute",
        '<mesh> of <link name="a">',
        3,
    ),
    "colour out of 255": (
        visual('<geometry><sphere radius="1"/></geometry><material name="m"><color rgba="255 0 0 1"/></material>'),
        "Material [m] has malformed color rgba values: [255 0 0 1]",
        '<color> of <material name="m">',
        3,
    ),
}
"""What urdfdom reports as an error, and then builds the robot all the same."""
