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


def long_srdf(folder, pairs):
    """An SRDF beside a plain robot, with so many pairs of links whose collisions are not checked; the path of both."""
    links = 2
    while links * (links - 1) // 2 < pairs:
        links += 1
    shape = '<collision><geometry><sphere radius="0.01"/></geometry></collision>'
    joint = ('  <joint name="j{n}" type="revolute"><parent link="l{before}"/><child link="l{n}"/><axis xyz="0 0 1"/>'
             '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>\n')
    robot = folder / 'chain.urdf'
    robot.write_text('<robot name="chain">\n' + ''.join(f'  <link name="l{n}">{shape}</link>\n' for n in range(links))
                     + ''.join(joint.format(n=n, before=n - 1) for n in range(1, links)) + '</robot>\n')
    all_pairs = [(one, two) for two in range(links) for one in range(two)][:pairs]
    pair = '  <disable_collisions link1="l{}" link2="l{}" reason="{}"/>\n'
    srdf = folder / 'chain.srdf'
    srdf.write_text('<robot name="chain">\n  <group name="arm"><chain base_link="l0" tip_link="l1"/></group>\n'
                    + ''.join(pair.format(one, two, 'Adjacent' if two - one == 1 else 'Never') for one, two in all_pairs)
                    + '</robot>\n')
    return srdf, robot


def long_robot(folder, links):
    """A robot of many calls of one macro, whose sizes stand in YAML."""
    sizes = ('small', 'middle', 'large')
    calls = ''.join(CALL.format(n=n, before=n - 1, size=sizes[n % 3]) for n in range(1, links + 1))
    (folder / 'sizes.yaml').write_text(SIZES)
    path = folder / 'long.urdf.xacro'
    path.write_text(HEAD + calls + '</robot>\n')
    return path
