#!/usr/bin/env python3
"""Time the check of workspaces of 10, 100, 1,000 and 10,000 packages, and count the planted mistakes that it names.

    tests/bench/workspace.py --bin target/release/xacro-lint [--packages 10,100,1000,10000]

Each package has a robot that includes a part of its own and one that all share. Every seventh robot has a joint with a
parent that does not exist. Linux only.
"""
import argparse
import json
import math
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

MANIFEST = '''<package format="3"><name>{name}</name><version>1.0.0</version><description>a robot</description>
<maintainer email="a@b.c">a</maintainer><license>MIT</license><exec_depend>xacro</exec_depend>{more}</package>
'''
SHARED = '''<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="bar" params="name length mass">
    <link name="${name}">
      <inertial>
        <mass value="${mass}"/>
        <inertia ixx="${mass * length ** 2 / 12}" ixy="0" ixz="0" iyy="${mass * length ** 2 / 12}" iyz="0" izz="${mass / 100}"/>
      </inertial>
      <collision><geometry><cylinder radius="0.05" length="${length}"/></geometry></collision>
    </link>
  </xacro:macro>
</robot>
'''
PART = '''<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="unit" params="name parent z:=0.1">
    <xacro:bar name="${name}" length="0.5" mass="2"/>
    <joint name="${name}_joint" type="revolute">
      <origin xyz="0 0 ${z}"/>
      <parent link="${parent}"/>
      <child link="${name}"/>
      <axis xyz="0 0 1"/>
      <limit lower="${-pi / 2}" upper="${pi / 2}" effort="10" velocity="1"/>
    </joint>
  </xacro:macro>
</robot>
'''


def make(folder, packages):
    """A workspace; the files in which a mistake was planted."""
    def package(name, files, more=''):
        place = folder / name / 'urdf'
        place.mkdir(parents=True)
        (place.parent / 'package.xml').write_text(MANIFEST.format(name=name, more=more))
        for file, text in files.items():
            (place / file).write_text(text)

    planted = set()
    package('parts', {'bar.xacro': SHARED})
    for number in range(packages):
        parents = ['base_link', 'u1', 'u2', 'u3']
        if number % 7 == 0:
            parents[2] = 'nobody'
            planted.add(f'robot{number}.urdf.xacro')
        calls = ''.join(f'  <xacro:unit name="u{n}" parent="{parent}" z="${{0.1 * {n}}}"/>\n'
                        for n, parent in enumerate(parents, 1))
        robot = (f'<robot name="r{number}" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
                 '  <xacro:include filename="$(find parts)/urdf/bar.xacro"/>\n  <xacro:include filename="unit.xacro"/>\n'
                 f'  <link name="base_link"/>\n{calls}</robot>\n')
        package(f'robot{number}', {f'robot{number}.urdf.xacro': robot, 'unit.xacro': PART},
                '<exec_depend>parts</exec_depend>')
    return planted


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--bin', required=True)
    parser.add_argument('--packages', default='10,100,1000,10000')
    options = parser.parse_args()
    costs, missed = [], 0
    for packages in map(int, options.packages.split(',')):
        with tempfile.TemporaryDirectory() as folder:
            planted = make(pathlib.Path(folder), packages)
            before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
            done = subprocess.run([os.path.abspath(options.bin), 'check', '--format', 'json', folder],
                                  stdout=subprocess.PIPE)
            wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
        busy = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        findings = json.loads(done.stdout)
        findings = findings['findings'] if isinstance(findings, dict) else findings
        named = {name for name in planted
                 if any(name in json.dumps(finding) and 'nobody' in json.dumps(finding) for finding in findings)}
        missed += len(planted - named)
        costs.append((packages, busy))
        print(f'{2 * packages + 1:6} files  {busy * 1e3:8.0f} ms of processor time, {wall * 1e3:8.0f} ms by the clock, '
              f'{(2 * packages + 1) / wall:6.0f} files a second; {len(named)} of {len(planted)} planted mistakes named')
    (few, cheap), (many, dear) = costs[0], costs[-1]
    if many > few:
        print(f'from {few} to {many} packages the cost grows with an exponent of {math.log(dear / cheap) / math.log(many / few):.2f}')
    return 1 if missed else 0


if __name__ == '__main__':
    sys.exit(main())
