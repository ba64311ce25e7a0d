"""Chapter 6."""

_CART = """%%write src/s6_py_urdf/urdf/cart.urdf
<robot name="cart">
  <link name="base_footprint"/>
  <link name="base_link"><visual><geometry><box size="0.5 0.3 0.1"/></geometry></visual></link>
  <joint name="base_joint" type="fixed">
    <origin xyz="0 0 0.15"/><parent link="base_footprint"/><child link="base_link"/>
  </joint>
  {left}{right}
  <link name="lift_link"><visual><geometry><box size="0.4 0.3 0.02"/></geometry></visual></link>
  <joint name="lift_joint" type="prismatic"><origin xyz="0 0 {lift}"/><parent link="base_link"/><child link="{child}"/>
    <axis xyz="{up}"/><limit lower="0" upper="{most}" effort="1" velocity="1"/></joint>
</robot>
"""
_WHEEL = """
  <link name="{side}_wheel_link"><visual><origin rpy="{rpy}"/>
    <geometry><cylinder radius="0.15" length="0.05"/></geometry></visual></link>
  <joint name="{side}_wheel_joint" type="{kind}"><origin xyz="0 {y} 0"/>
    <parent link="base_link"/><child link="{side}_wheel_link"/><axis xyz="{axis}"/></joint>
"""


def _cart(*, lift="0.06", up="0 0 1", most="0.4", child="lift_link", rpy="1.5708 0 0", axis="0 1 0", kind="continuous"):
    sides = {
        side: _WHEEL.format(side=side, y=y, rpy=rpy, axis=axis, kind=kind) for side, y in (("left", 0.2), ("right", -0.2))
    }
    return _CART.format(lift=lift, up=up, most=most, child=child, **sides)


_TIP = "import math\n\ndef tip(shoulder, elbow, upper=0.4, fore=0.3):\n    return {answer}"
_ROLLING = """%%write src/s6_py_urdf/s6_py_urdf/rolling.py
def wheel_steps(radius, step):
    return {left}, {right}
"""

_OWN = """%%write src/s6_py_urdf/urdf/own.urdf.xacro
<robot name="own" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find coursekit_robots)/urdf/shapes.xacro"/>
  <xacro:macro name="part" params="name s mass inertia:=1">
    <link name="${{name}}"><visual><geometry><box size="${{s}} ${{s}} ${{s}}"/></geometry></visual>
      {collision}
      <inertial><mass value="${{mass}}"/><inertia ixx="${{mass*s*s/6*{far}}}" iyy="${{mass*s*s/6}}" izz="${{mass*s*s/6}}"
        ixy="0" ixz="0" iyz="0"/></inertial></link>
  </xacro:macro>
  <link name="base_footprint"/><xacro:part name="body" s="0.2" mass="2"/><xacro:part name="slide" s="0.1" mass="{mass}"/>
  <xacro:part name="wheel" s="0.1" mass="0.1"/><xacro:part name="nose" s="0.1" mass="0.1"/>
  <xacro:part name="ear" s="0.05" mass="0.1"/>
  <joint name="a" type="fixed"><origin xyz="0 0 {height}"/><parent link="base_footprint"/><child link="body"/></joint>
  <joint name="b" type="{slides}"><origin xyz="0 0 0.2"/><parent link="body"/><child link="slide"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="{reach}" effort="1" velocity="1"/></joint>
  <joint name="c" type="continuous"><origin xyz="0 0 0.3"/><parent link="body"/><child link="wheel"/><axis xyz="0 0 1"/></joint>
  <joint name="d" type="revolute"><origin xyz="0 0 0.4"/><parent link="body"/><child link="nose"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="e" type="fixed"><origin xyz="0 0 0.5"/><parent link="body"/><child link="ear"/></joint>
</robot>
"""
_BUMPS = '<collision><geometry><box size="${s} ${s} ${s}"/></geometry></collision>'


def _own(*, collision=_BUMPS, far="1", height="0.1", slides="prismatic", reach="0.1", mass="0.2"):
    return _OWN.format(collision=collision, far=far, height=height, slides=slides, reach=reach, mass=mass)


WRONG = {
    "ch06.q1": [
        _cart(rpy="0 0 0"),
        _cart(axis="0 -1 0"),
        _cart(axis="0 0 1"),
        _cart(lift="0.21"),
        _cart(up="1 0 0"),
        _cart(child="lift_lnk"),
        _cart().replace('name="cart"', 'name="trolley"'),
        _cart().replace("0.5 0.3 0.1", "0.5 0.3 0.2"),
        _cart().replace("</robot>", ""),
    ],
    "ch06.q2": [
        _TIP.format(answer="upper * math.cos(shoulder) + fore * math.cos(elbow), upper * math.sin(shoulder)"),
        _TIP.format(
            answer="0.4 * math.cos(shoulder) + 0.3 * math.cos(shoulder + elbow),"
            " 0.4 * math.sin(shoulder) + 0.3 * math.sin(shoulder + elbow)"
        ),
        _TIP.format(answer="upper + fore"),
        _TIP.format(answer="math.nan, math.nan"),
        _TIP.format(answer="(one for one in (upper, fore))"),
    ],
    "ch06.q3": [
        _ROLLING.format(left="radius * step / 0.0375", right="radius * step / 0.0375"),
        _ROLLING.format(left="(radius + 0.094) * step / 0.0375", right="(radius - 0.094) * step / 0.0375"),
        _ROLLING.format(left="abs(radius - 0.094) * step / 0.0375", right="(radius + 0.094) * step / 0.0375"),
        _ROLLING.format(left="(radius - 0.094) * step", right="(radius + 0.094) * step"),
        _ROLLING.format(left="(raduis - 0.094) * step", right="0.0"),
        _ROLLING.format(left="float('nan')", right="float('nan')"),
    ],
    "ch06.q4": [
        _own(collision=""),
        _own(far="30"),
        _own(height="0.2"),
        _own(slides="continuous"),
        _own(reach="0.01"),
        _own(reach="0.9", mass="5"),
    ],
    "ch06.q5": [
        """%%write -a src/s6_cpp_urdf/src/cpp_tip_node.cpp

Point tip(double shoulder, double elbow) {
  Point place;
  place.x = upper * std::cos(shoulder) + fore * std::cos(elbow);
  place.y = upper * std::sin(shoulder) + fore * std::sin(elbow);
  return place;
}
""",
        """%%write -a src/s6_cpp_urdf/src/cpp_tip_node.cpp

Point tip(double shoulder, double elbow) {
  Point place;
  place.x = upper * std::sin(shoulder) + fore * std::sin(shoulder + elbow);
  place.y = upper * std::cos(shoulder) + fore * std::cos(shoulder + elbow);
  return place;
}
""",
    ],
}
RIGHT = {
    "ch06.q2": [
        "import math\nimport numpy as np\n\ndef tip(shoulder, elbow, upper=0.4, fore=0.3):\n"
        "    turns = np.array([shoulder, shoulder + elbow])\n"
        "    return np.array([[np.cos(turns), np.sin(turns)]])[0] @ [upper, fore]",
    ],
}
