#!/usr/bin/env python3
"""A file that is four times as long takes about four times as long, whatever is wrong with each of its lines.

    tests/bench/scaling.py --bin target/release/xacro-lint [--lines 3000] [--only NAME]

One robot for each kind of line, many times the same defect under other names; processor time of `check`, the least of several
runs. A rule that compares each element with all others takes sixteen times as long and is caught.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

# what a file of four times the lines may take: sorting, and memory that does not fit into caches, make it more than four
MOST = 8.0
# runs before a ratio counts: another program on the machine makes single ones long
RUNS = 3
# processor time below which a ratio says nothing, seconds
LEAST = 0.2

LINK = '<link name="l{i}"/><joint name="j{i}" type="revolute"><parent link="a"/><child link="l{i}"/>' \
       '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
INERTIAL = '<inertial><mass value="{m}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="{z}"/></inertial>'

KINDS = {
    # links and joints
    'links without joints': '<link name="l{i}"/>',
    'links that are missing': '<joint name="j{i}" type="fixed"><parent link="p{i}"/><child link="c{i}"/></joint>',
    'links with other names': '<link name="l{i}q"/><joint name="j{i}" type="fixed"><parent link="l{p}q"/><child link="l{i}"/></joint>',
    'one link twice': '<link name="a"/>',
    'one joint twice': '<joint name="j" type="fixed"><parent link="a"/><child link="a"/></joint>',
    'several parents': '<joint name="j{i}" type="fixed"><parent link="p{i}"/><child link="a"/></joint><link name="p{i}"/>',
    'a cycle': '<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="l{i}"/><child link="l{p}"/></joint>',
    'names that differ by case': '<link name="Link{i}"/><link name="link{i}"/>',
    'names with blanks': '<link name="l {i}"/>',
    'a chain': '<link name="l{i}">' + INERTIAL.format(m=1, z=5) + '<collision><geometry><box size="1 1 1"/></geometry></collision>'
               '<visual><geometry><box size="0.1 .1 .1"/></geometry><material name="m{i}"/></visual></link>'
               '<joint name="j{i}" type="continuous"><parent link="l{p}"/><child link="l{i}"/><axis xyz="0 0 2"/></joint>',
    'a chain without masses': '<link name="l{i}">' + INERTIAL.format(m=0.001, z=0) + '</link>'
                              '<joint name="j{i}" type="fixed"><parent link="l{p}"/><child link="l{i}"/></joint>',
    'left and right': '<link name="left_arm_{i}">' + INERTIAL.format(m=1, z=1) + '</link><link name="right_arm_{i}">'
                      + INERTIAL.format(m=2, z=1) + '</link>',
    'wheels': ''.join(
        f'<link name="{side}_wheel_{{i}}"/><joint name="{side}_wheel_{{i}}_joint" type="continuous"><parent link="a"/>'
        f'<child link="{side}_wheel_{{i}}"/><axis xyz="0 {axis} 0"/></joint>' for side, axis in [('left', 1), ('right', -1)]),
    'limits': '<link name="l{i}"/><joint name="j{i}" type="revolute"><parent link="a"/><child link="l{i}"/><limit lower="180" '
              'upper="-180" effort="0" velocity="90"/><safety_controller soft_lower_limit="-200" soft_upper_limit="200" '
              'k_velocity="1"/></joint>',
    'a chain of mimics': LINK.replace('</joint>', '<mimic joint="j{p}" multiplier="2"/></joint>'),
    'mimics of nothing': LINK.replace('</joint>', '<mimic joint="zz{i}"/></joint>'),
    'optical frames': '<link name="cam{i}_link"/><link name="cam{i}_optical_frame"/><joint name="o{i}" type="fixed">'
                      '<parent link="cam{i}_link"/><child link="cam{i}_optical_frame"/></joint>',
    'footprints': '<link name="base_footprint{i}"/><joint name="f{i}" type="fixed"><parent link="base_footprint{i}"/>'
                  '<child link="a"/><origin rpy="1 0 0"/></joint>',
    # materials and meshes
    'materials that nothing uses': '<material name="m{i}"><color rgba="1 1 1 2"/></material>',
    'one material twice': '<material name="m"><color rgba="1 {i} 1 1"/></material>',
    'materials that are missing': '<link name="l{i}"><visual><geometry><sphere radius="1"/></geometry><material name="u{i}"/>'
                                    '</visual></link>',
    'meshes that are missing': '<link name="l{i}"><visual name="v"><geometry><mesh filename="package://p{i}/a.stl"/></geometry>'
                                 '</visual><collision><geometry><mesh filename="x{i}.stl" scale="1000 1 1"/></geometry></collision></link>',
    # control and Gazebo
    'frames that are missing': LINK + '<gazebo reference="l{i}"><sensor name="s{i}" type="ray"><plugin filename="libx.so">'
                               '<frame_name>f{i}</frame_name></plugin></sensor></gazebo>',
    'surfaces': '<link name="l{i}"><collision><geometry><sphere radius="1"/></geometry><surface><friction><ode><mu>0</mu></ode>'
                '</friction></surface></collision></link>',
    'sensors on links': LINK + '<gazebo reference="l{i}"><sensor name="s{i}" type="ray"><ray/></sensor></gazebo>',
    'sensors on fixed links': '<link name="l{i}"/><joint name="j{i}" type="fixed"><parent link="a"/><child link="l{i}"/></joint>'
                              '<gazebo reference="l{i}"><sensor name="s{i}" type="ray"><ray/></sensor></gazebo>',
    'unknown references': '<gazebo reference="x{i}"><sensor name="s{i}" type="ray"/></gazebo>',
    'friction on joints': LINK + '<gazebo reference="j{i}"><mu1>0.5</mu1><kp>1</kp></gazebo>',
    'plugins without a file': '<gazebo reference="a"><plugin name="p{i}"/></gazebo>',
    'plugins for ROS 1': '<gazebo><plugin name="p{i}" filename="libgazebo_ros_laser.so"><topicName>t{i}</topicName></plugin></gazebo>',
    'drives of unknown wheels': LINK + '<gazebo><plugin name="p{i}" filename="libgazebo_ros_diff_drive.so"><left_joint>j{i}</left_joint>'
                                '<right_joint>q{i}</right_joint><wheel_separation>1</wheel_separation></plugin></gazebo>',
    'transmissions of unknown joints': LINK + '<transmission name="t{i}"><type>transmission_interface/SimpleTransmission</type>'
                                       '<joint name="q{i}"><hardwareInterface>x</hardwareInterface></joint></transmission>',
    'hardware': LINK + '<ros2_control name="c{i}" type="system"><hardware><plugin>mock_components/GenericSystem</plugin></hardware>'
                '<joint name="j{i}"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>',
    'hardware of one joint': '<ros2_control name="c{i}" type="system"><hardware><plugin>x/Y</plugin></hardware><joint name="j">'
                             '<command_interface name="position"/></joint></ros2_control>',
    # xacro
    'arguments': '<xacro:arg name="a{i}" default="1"/>',
    'properties that need each other': '<xacro:property name="p{i}" value="${{p{p}+1}}"/>',
    'properties that are missing': '<link name="${{q{i}}}"/>',
    'macros': '<xacro:macro name="m{i}" params="x y:=1 *b"><link name="l${{x}}"/></xacro:macro>',
    'one macro twice': '<xacro:macro name="m" params="x"><link name="l"/></xacro:macro>',
    'macros with calls': '<xacro:macro name="m{i}" params="x"><link name="${{x}}"/></xacro:macro><xacro:m{i} x="l{i}"/>',
    'macros with blocks': '<xacro:macro name="m{i}" params="*b"><xacro:insert_block name="b"/></xacro:macro>'
                          '<xacro:m{i}><link name="l{i}"/></xacro:m{i}>',
    'macros that are missing': '<xacro:zz{i}/>',
    'tags without their prefix': '<property name="p{i}" value="1"/><include filename="f{i}.xacro"/>',
    'includes that are missing': '<xacro:include filename="f{i}.xacro"/>',
    'conditions': '<xacro:if value="${{x{i}}}"><link name="l{i}"/></xacro:if>',
    'text': 'hello {i} <link name="l{i}"/> --&gt;',
    'unknown tags': '<foo{i}/>',
    'suppressions': '<!-- xacro-lint: disable-next-line=nope{i} -->\n<link name="l{i}"/>',
}


def robot(line, lines):
    """A robot of so many lines of a kind."""
    rest = '\n'.join(line.format(i=i, p=i - 1) for i in range(1, lines + 1))
    return '<?xml version="1.0"?>\n<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n<link name="a"/><link name="l0"/>' \
           f'<xacro:property name="p0" value="1"/>\n{rest}\n</robot>\n'


def seconds(binary, path):
    """Processor time of a check."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([binary, 'check', '--format', 'json', path], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in (0, 1):
        raise SystemExit(f'exit code {done.returncode}: {done.stderr}')
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def grows(binary, folder, line, lines):
    """How many times as long four times the lines take, and how long."""
    paths = []
    for count in (lines, 4 * lines):
        # each in a folder of its own: the other would lie in its workspace
        path = folder / str(count) / 'robot.urdf.xacro'
        path.parent.mkdir(exist_ok=True)
        path.write_text(robot(line, count))
        paths.append(path)
    short = long = float('inf')
    for _ in range(RUNS):
        short, long = (min(least, seconds(binary, path)) for least, path in zip((short, long), paths))
        if long < LEAST or long / short <= MOST:
            break
    return long / short, long


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--bin', required=True)
    parser.add_argument('--lines', type=int, default=3000)
    parser.add_argument('--only', help='a kind of line')
    options = parser.parse_args()
    binary, failed = os.path.abspath(options.bin), 0
    kinds = {name: line for name, line in KINDS.items() if options.only in (None, name)}
    with tempfile.TemporaryDirectory() as folder:
        for name, line in kinds.items():
            ratio, long = grows(binary, pathlib.Path(folder), line, options.lines)
            is_bad = ratio > MOST and long >= LEAST
            failed += is_bad
            print(f'{name:36} {ratio:5.1f} times as long, {long:.2f} s{"  FAILED" if is_bad else ""}')
    print(f'{len(kinds) - failed} passed, {failed} failed')
    return int(failed > 0)


if __name__ == '__main__':
    sys.exit(main())
