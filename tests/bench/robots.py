"""What the benches work on: the examples of the documentation, and robots of any length."""
import pathlib

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent.parent / 'docs' / 'examples'

HEAD = '''<?xml version="1.0"?>
<robot name="long" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="sizes" value="${xacro.load_yaml('sizes.yaml')}"/>
  <xacro:macro name="segment" params="name parent size *origin">
    <link name="${name}">
      <inertial>
        <mass value="${sizes[size]['mass']}"/>
        <inertia ixx="${sizes[size]['mass'] * sizes[size]['radius'] ** 2 / 2}" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
      </inertial>
    </link>
    <joint name="${name}_joint" type="revolute">
      <xacro:insert_block name="origin"/>
      <parent link="${parent}"/>
      <child link="${name}"/>
      <axis xyz="0 0 1"/>
      <limit lower="${-pi}" upper="${pi}" effort="10" velocity="1"/>
    </joint>
  </xacro:macro>
  <link name="s0"/>
'''
CALL = '''  <xacro:segment name="s{n}" parent="s{before}" size="{size}">
    <origin xyz="0 0 ${{sizes['{size}']['length'] + {n} / 1000}}"/>
  </xacro:segment>
'''
SIZES = ''.join(f'{name}:\n  mass: {mass}\n  radius: 0.0{mass}\n  length: 0.{mass}\n'
                for name, mass in (('small', 1), ('middle', 2), ('large', 4)))


def long_robot(folder, links):
    """A robot of many calls of one macro, whose sizes stand in YAML."""
    sizes = ('small', 'middle', 'large')
    calls = ''.join(CALL.format(n=n, before=n - 1, size=sizes[n % 3]) for n in range(1, links + 1))
    (folder / 'sizes.yaml').write_text(SIZES)
    path = folder / 'long.urdf.xacro'
    path.write_text(HEAD + calls + '</robot>\n')
    return path
