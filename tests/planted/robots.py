#!/usr/bin/env python3
"""Write the robots in which defects are planted, each a workspace of its own: `robots.py FOLDER`.

Thirty are invented here; the examples of the documentation that have no defect come in addition.
"""
import pathlib
import shutil
import sys

from arms import arm, cell, plain_arm, yaml_arm
from limbs import legs, lift, turret
from mobile import base, gripper

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / 'docs' / 'examples'
CLEAN_EXAMPLES = ('industrial_arm', 'measuring_cell', 'two_joint_gripper')
FOUR = ('front_left', 'front_right', 'rear_left', 'rear_right')
ROBOTS = {
    'arm_ros2_control': arm('tarn6', 6, 1.2, True), 'arm_no_control': arm('tarn4', 4, 0.8, False, computed=True),
    'arm_long': arm('brindle7', 7, 1.5, True), 'arm_short': arm('dace3', 3, 0.6, True),
    'yaml_by_package': yaml_arm('ostler', ['turn', 'lower_arm', 'upper_arm', 'hand'], True),
    'yaml_by_name': yaml_arm('quill', ['hip', 'knee', 'ankle'], False),
    'yaml_five': yaml_arm('sorrel', ['swing', 'boom', 'stick', 'wrist', 'roll'], True),
    'urdf_revolute': plain_arm('pintle', 5, ('revolute',)), 'urdf_mixed': plain_arm('gimbal', 6, ('revolute', 'continuous')),
    'urdf_fixed': plain_arm('bobbin', 4, ('fixed', 'revolute')),
    'cell_one': cell('bench_cell', 6, 1), 'cell_two': cell('twin_cell', 6, 2), 'cell_small': cell('desk_cell', 4, 2),
    'base_two_wheels': base('mallow', 2, 0.08, 'true'), 'base_four_wheels': base('teasel', 4, 0.11, 'true'),
    'base_large': base('burdock', 4, 0.15, 'true'), 'base_not_simulated': base('yarrow', 2, 0.1, 'false'),
    'gripper_one': gripper('pincer', 0.04, False), 'gripper_two': gripper('nipper', 0.03, True),
    'gripper_wide': gripper('tongs', 0.06, True),
    'legs_four': legs('badger', FOUR, True), 'legs_two': legs('heron', ('front_left', 'front_right'), True),
    'legs_uncontrolled': legs('otter', FOUR, False),
    'turret_two': turret('sentry', [('pan', '0 0 1'), ('tilt', '0 1 0')], False),
    'turret_three': turret('beacon', [('pan', '0 0 1'), ('tilt', '0 1 0'), ('roll', '1 0 0')], True),
    'turret_one': turret('vane', [('yaw', '0 0 1')], False),
    'lift_two': lift('jackstay', 2, 0.3), 'lift_three': lift('hoist', 3, 0.25), 'lift_four': lift('derrick', 4, 0.2),
    'arm_five': arm('linnet5', 5, 0.9, True, computed=True),
}


def write(folder):
    """Write every robot into a folder of its own below `folder`; returns their names."""
    for robot, files in ROBOTS.items():
        for path, content in files.items():
            target = pathlib.Path(folder, robot, path)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content if isinstance(content, bytes) else content.encode())
    for example in CLEAN_EXAMPLES:
        shutil.copytree(EXAMPLES / example, pathlib.Path(folder, example))
    return sorted([*ROBOTS, *CLEAN_EXAMPLES])


if __name__ == '__main__':
    write(sys.argv[1])
