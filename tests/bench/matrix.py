#!/usr/bin/env python3
"""Time `xacro-lint test` on an arm with 500 combinations of its arguments.

    tests/bench/matrix.py --bin target/release/xacro-lint [--runs 5]

The arm is like those of manufacturers: ten types, whose limits, kinematics and masses come from YAML files, macros with a
prefix, ros2_control with a mock or a simulation. Prints the processor time of the process, the median of some runs.
Linux only.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import tempfile

TYPES = [f'reach_{n}' for n in range(3, 13)]
JOINTS = ['shoulder_pan', 'shoulder_lift', 'elbow', 'wrist_1', 'wrist_2', 'wrist_3']

HEAD = '''<?xml version="1.0"?>
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="$(arg kind)">
  <xacro:arg name="kind" default="reach_5"/>
  <xacro:arg name="prefix" default=""/>
  <xacro:arg name="simulated" default="false"/>
  <xacro:arg name="tool" default="none"/>
  <xacro:include filename="arm_macro.xacro"/>
  <link name="world"/>
  <xacro:arm kind="$(arg kind)" prefix="$(arg prefix)" parent="world" simulated="$(arg simulated)">
    <origin xyz="0 0 0" rpy="0 0 0"/>
  </xacro:arm>
  <xacro:unless value="${'$(arg tool)' == 'none'}">
    <xacro:tool name="$(arg prefix)$(arg tool)" parent="$(arg prefix)wrist_3_link" length="0.1"/>
  </xacro:unless>
</robot>
'''

MACROS = '''<?xml version="1.0"?>
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="tube_inertial" params="mass radius length *origin">
    <inertial>
      <mass value="${mass}"/>
      <xacro:insert_block name="origin"/>
      <inertia ixx="${mass * (3 * radius ** 2 + length ** 2) / 12}" ixy="0.0" ixz="0.0"
               iyy="${mass * (3 * radius ** 2 + length ** 2) / 12}" iyz="0.0" izz="${mass * radius ** 2 / 2}"/>
    </inertial>
  </xacro:macro>
  <xacro:macro name="body" params="name prefix mass radius length">
    <link name="${prefix}${name}_link">
      <visual>
        <origin xyz="0 0 ${length / 2}" rpy="0 0 ${pi}"/>
        <geometry><cylinder radius="${radius}" length="${length}"/></geometry>
        <material name="grey"><color rgba="0.7 0.7 0.7 1"/></material>
      </visual>
      <collision>
        <origin xyz="0 0 ${length / 2}" rpy="0 0 ${pi}"/>
        <geometry><cylinder radius="${radius}" length="${length}"/></geometry>
      </collision>
      <xacro:tube_inertial mass="${mass}" radius="${radius}" length="${length}">
        <origin xyz="0 0 ${length / 2}"/>
      </xacro:tube_inertial>
    </link>
  </xacro:macro>
  <xacro:macro name="axis" params="name prefix parent limits kinematics">
    <xacro:property name="own" value="${limits['joint_limits'][name]}"/>
    <xacro:property name="at" value="${kinematics['kinematics'][name]}"/>
    <joint name="${prefix}${name}_joint" type="revolute">
      <parent link="${prefix}${parent}_link"/>
      <child link="${prefix}${name}_link"/>
      <origin xyz="${at['x']} ${at['y']} ${at['z']}" rpy="${at['roll']} ${at['pitch']} ${at['yaw']}"/>
      <axis xyz="0 0 1"/>
      <limit lower="${radians(own['min'])}" upper="${radians(own['max'])}" effort="${own['effort']}" velocity="${radians(own['velocity'])}"/>
      <dynamics damping="0" friction="0"/>
    </joint>
  </xacro:macro>
  <xacro:macro name="control" params="name prefix">
    <joint name="${prefix}${name}_joint">
      <command_interface name="position"/>
      <command_interface name="velocity"/>
      <state_interface name="position"><param name="initial_value">0.0</param></state_interface>
      <state_interface name="velocity"/>
      <state_interface name="effort"/>
    </joint>
  </xacro:macro>
  <xacro:macro name="tool" params="name parent length">
    <xacro:body name="${name}" prefix="" mass="0.5" radius="0.03" length="${length}"/>
    <joint name="${name}_mount" type="fixed">
      <parent link="${parent}"/>
      <child link="${name}_link"/>
    </joint>
  </xacro:macro>
  <xacro:macro name="arm" params="kind prefix parent simulated *origin">
    <xacro:property name="limits" value="${xacro.load_yaml(kind + '/limits.yaml')}"/>
    <xacro:property name="kinematics" value="${xacro.load_yaml(kind + '/kinematics.yaml')}"/>
    <xacro:property name="bodies" value="${xacro.load_yaml(kind + '/bodies.yaml')['bodies']}"/>
    <ros2_control name="${prefix}${kind}" type="system">
      <hardware>
        <xacro:if value="${simulated}"><plugin>gz_ros2_control/GazeboSimSystem</plugin></xacro:if>
        <xacro:unless value="${simulated}"><plugin>mock_components/GenericSystem</plugin></xacro:unless>
      </hardware>
CONTROLS    </ros2_control>
    <joint name="${prefix}base_joint" type="fixed">
      <xacro:insert_block name="origin"/>
      <parent link="${parent}"/>
      <child link="${prefix}base_link"/>
    </joint>
BODIES  </xacro:macro>
</robot>
'''

CONFIG = '''[[roots]]
file = "arm.urdf.xacro"
args = { kind = KINDS, prefix = ["", "left_", "right_", "a_", "b_"], simulated = [true, false], tool = ["none", "pen", "hook", "lamp", "cup"] }

[[roots.expect]]
root = "world"
links = ["$(arg prefix)base_link", "$(arg prefix)wrist_3_link"]
moving-joint-count = 6
chains = [["world", "$(arg prefix)elbow_link", "$(arg prefix)wrist_3_link"]]
command-interfaces = { "$(arg prefix)elbow_joint" = ["position", "velocity"] }

[roots.expect.joint."$(arg prefix)elbow_joint"]
type = "revolute"
lower = -3.1416
upper = 3.1416

[[roots.expect]]
when = { tool = "none" }
no-links = ["$(arg prefix)pen_link"]
mass = 21
'''


def write(folder: pathlib.Path) -> None:
    """The arm, its data and the configuration."""
    bodies, controls, parent = ['base'], [], 'base'
    calls = ['    <xacro:body name="base" prefix="${prefix}" mass="${bodies[\'base\'][\'mass\']}" '
             'radius="${bodies[\'base\'][\'radius\']}" length="${bodies[\'base\'][\'length\']}"/>\n']
    for joint in JOINTS:
        of = f"bodies['{joint}']"
        calls.append(f'    <xacro:body name="{joint}" prefix="${{prefix}}" mass="${{{of}[\'mass\']}}" '
                     f'radius="${{{of}[\'radius\']}}" length="${{{of}[\'length\']}}"/>\n'
                     f'    <xacro:axis name="{joint}" prefix="${{prefix}}" parent="{parent}" limits="${{limits}}" '
                     'kinematics="${kinematics}"/>\n')
        controls.append(f'      <xacro:control name="{joint}" prefix="${{prefix}}"/>\n')
        bodies.append(joint)
        parent = joint
    (folder / 'arm.urdf.xacro').write_text(HEAD)
    macros = MACROS.replace('CONTROLS', ''.join(controls)).replace('BODIES', ''.join(calls))
    (folder / 'arm_macro.xacro').write_text(macros)
    kinds = '[' + ', '.join(f'"{kind}"' for kind in TYPES) + ']'
    (folder / 'xacro-lint.toml').write_text(CONFIG.replace('KINDS', kinds))
    for number, kind in enumerate(TYPES):
        (folder / kind).mkdir()
        limits = ''.join(f'  {joint}: {{min: -180, max: 180, effort: 150, velocity: 180}}\n'
                         for joint in JOINTS)
        (folder / kind / 'limits.yaml').write_text('joint_limits:\n' + limits)
        at = ''.join(f'  {joint}: {{x: {0.05 * number:.3f}, y: 0, z: 0.1, roll: 0, pitch: 0, yaw: 1.570796327}}\n'
                     for joint in JOINTS)
        (folder / kind / 'kinematics.yaml').write_text('kinematics:\n' + at)
        masses = ''.join(f'  {body}: {{mass: 3, radius: 0.06, length: {0.1 + 0.01 * number:.3f}}}\n' for body in bodies)
        (folder / kind / 'bodies.yaml').write_text('bodies:\n' + masses)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument('--bin', required=True)
    parser.add_argument('--runs', type=int, default=5)
    arguments = parser.parse_args()
    binary = str(pathlib.Path(arguments.bin).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write(folder)
        times = []
        for _ in range(arguments.runs):
            before = os.times()
            run = subprocess.run([binary, 'test'], cwd=folder, capture_output=True, text=True)
            after = os.times()
            assert run.returncode == 0, run.stdout[-2000:] + run.stderr
            times.append(after.children_user + after.children_system - before.children_user - before.children_system)
        print(run.stdout.strip().splitlines()[-1])
        print(f'{statistics.median(times):.2f} s of processor time (least {min(times):.2f} s)')


if __name__ == '__main__':
    main()
