"""Descriptions with one mistake each: what the comparison of tools is made on."""

ROBOT = """<?xml version="1.0"?>
<robot name="arm">
  <material name="grey">
    <color rgba="0.5 0.5 0.5 1"/>
  </material>
  <link name="base_link"/>
  <link name="upper">
    <inertial>
      <mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
    </inertial>
    <visual>
      <origin xyz="0 0 0.1" rpy="0 0 0"/>
      <geometry>
        <box size="0.25 0.25 0.25"/>
      </geometry>
      <material name="grey"/>
    </visual>
    <collision>
      <origin xyz="0 0 0.1" rpy="0 0 0"/>
      <geometry>
        <box size="0.25 0.25 0.25"/>
      </geometry>
    </collision>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base_link"/>
    <child link="upper"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="2"/>
  </joint>
</robot>
"""

END = "</robot>\n"
LIMIT = 'lower="-1" upper="1"'
JOINT = """  <joint name="%s" type="fixed">
    <parent link="%s"/>
    <child link="%s"/>
  </joint>
"""
CLOSED = '  <link name="hand"/>\n' + JOINT % ("wrist", "upper", "hand")


def added(text):
    """The robot with more at its end."""
    return ROBOT.replace(END, text + END)


def other(old, new):
    """The robot with one text replaced."""
    assert ROBOT.count(old), old
    return ROBOT.replace(old, new, 1)


#: The mistake, and the robot that has it and no other.
URDF = {
    "no mistake at all": ROBOT,
    "an unconnected link": added('  <link name="hand"/>\n'),
    "a joint with an undefined parent link": other('<parent link="base_link"/>', '<parent link="base"/>'),
    "a kinematic loop": ROBOT.replace(END, JOINT % ("loop", "upper", "base_link") + END),
    "a link with two parents": added(CLOSED + JOINT % ("closing", "base_link", "hand")),
    "two links with the same name": added('  <link name="upper"/>\n'),
    "two joints with the same name": added('  <link name="hand"/>\n' + JOINT % ("shoulder", "upper", "hand")),
    "a revolute joint without limit": other(f'    <limit {LIMIT} effort="10" velocity="2"/>\n', ""),
    "a limit without effort and velocity": other(' effort="10" velocity="2"', ""),
    "an unknown joint type": other('type="revolute"', 'type="rotating"'),
    "an axis of zero length": other('<axis xyz="0 0 1"/>', '<axis xyz="0 0 0"/>'),
    "an axis with two numbers": other('<axis xyz="0 0 1"/>', '<axis xyz="0 1"/>'),
    "lower limit above the upper one": other(LIMIT, 'lower="1" upper="-1"'),
    "limits in degrees": other(LIMIT, 'lower="-180" upper="180"'),
    "a missing mesh": other('<box size="0.25 0.25 0.25"/>', '<mesh filename="meshes/upper.stl"/>'),
    "a negative mass": other('<mass value="1"/>', '<mass value="-1"/>'),
    "impossible moments of inertia": other('izz="0.01"', 'izz="0.05"'),
    "inertia on the root link": other(
        '<link name="base_link"/>',
        '<link name="base_link">\n    <inertial>\n      <mass value="1"/>\n      <inertia ixx="0.01" ixy="0" ixz="0"'
        ' iyy="0.01" iyz="0" izz="0.01"/>\n    </inertial>\n  </link>',
    ),
    "mimic of an unknown joint": other(
        f'    <limit {LIMIT}', f'    <mimic joint="elbow"/>\n    <limit {LIMIT}'
    ),
    "a misspelled element": other("<visual>", "<visul>").replace("</visual>", "</visul>"),
    "a misspelled attribute": other('rpy="0 0 0"', 'rpyy="0 0 0"'),
    "an undefined material": other('<material name="grey"/>', '<material name="gray"/>'),
    "a number with a unit": other('xyz="0 0 0.1"', 'xyz="0 0 0.1m"'),
    "an unclosed element": other("      </geometry>\n", ""),
}

XACRO = """<?xml version="1.0"?>
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="width" value="0.2"/>
  <xacro:arg name="prefix" default=""/>
  <xacro:macro name="part" params="name">
    <link name="${name}">
      <collision>
        <geometry>
          <box size="${width} ${width} ${width}"/>
        </geometry>
      </collision>
    </link>
  </xacro:macro>
  <xacro:part name="$(arg prefix)base_link"/>
</robot>
"""


def xacro(old, new):
    """The description with one text replaced."""
    assert XACRO.count(old), old
    return XACRO.replace(old, new, 1)


#: The same for xacro.
XACROS = {
    "no mistake at all": XACRO,
    "an undefined property": xacro("${width} $", "${widht} $"),
    "an undefined macro": xacro("<xacro:part ", "<xacro:prat "),
    "a missing parameter": xacro('<xacro:part name="$(arg prefix)base_link"/>', "<xacro:part/>"),
    "an undefined argument": xacro('  <xacro:arg name="prefix" default=""/>\n', ""),
    "a macro called without `xacro:`": xacro("<xacro:part ", "<part "),
    "a missing include": xacro("  <xacro:arg", '  <xacro:include filename="none.xacro"/>\n  <xacro:arg'),
    "a broken expression": xacro("${width} $", "${2 * (width} $"),
    "a condition that is neither true nor false": xacro(
        END, '  <xacro:if value="maybe">\n    <link name="a"/>\n  </xacro:if>\n' + END
    ),
    "a property that is never read": xacro("  <xacro:arg", '  <xacro:property name="depth" value="1"/>\n  <xacro:arg'),
    "a property that hides `pi`": xacro("width", "pi").replace("${width}", "${pi}"),
}
