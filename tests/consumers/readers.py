#!/usr/bin/env python3
"""Load robots with one reader and print what it made of each, one line of JSON per robot.

    readers.py READER FOLDER FILE...

READER is one of READERS below; FOLDER holds the packages. Each file is loaded in a process of its own with a limit of
time, after the reader's library was imported once. A line is {"file", "loaded", "why", "links": {name: mass},
"joints": {name: [type, lower, upper]}, "bodies": number of meshes and shapes}; what a reader does not tell is null.
"""
import json
import math
import os
import signal
import sys
import tempfile

SECONDS = 30


class Rejected(Exception):
    """The reader did not load the robot."""


def bound(value):
    return None if value is None or not math.isfinite(value) else round(float(value), 9)


def mujoco_reader(folder):
    import mujoco

    def name(model, kind, number):
        return mujoco.mj_id2name(model, kind, number) or ''

    def read(path):
        model = mujoco.MjModel.from_xml_path(path)
        body, joint = mujoco.mjtObj.mjOBJ_BODY, mujoco.mjtObj.mjOBJ_JOINT
        links = {name(model, body, n): float(model.body_mass[n]) for n in range(1, model.nbody)}
        kinds = {0: 'floating', 1: 'ball', 2: 'prismatic', 3: 'revolute'}
        joints = {}
        for n in range(model.njnt):
            low, high = model.jnt_range[n] if model.jnt_limited[n] else (None, None)
            joints[name(model, joint, n)] = [kinds[int(model.jnt_type[n])], bound(low), bound(high)]
        return {'links': links, 'joints': joints, 'bodies': int(model.ngeom)}
    return read


def drake_reader(folder):
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant
    from pydrake.geometry import SceneGraph

    def read(path):
        plant, scene = MultibodyPlant(0.0), SceneGraph()
        plant.RegisterAsSourceForSceneGraph(scene)
        parser = Parser(plant=plant)
        parser.package_map().PopulateFromFolder(folder)
        (model,) = parser.AddModels(path)
        plant.Finalize()
        context = plant.CreateDefaultContext()
        bodies = [plant.get_body(b) for b in plant.GetBodyIndices(model)]
        links = {b.name(): b.get_mass(context) for b in bodies}
        joints = {}
        for index in plant.GetJointIndices(model):
            joint = plant.get_joint(index)
            one = joint.num_positions() == 1
            low = bound(joint.position_lower_limits()[0]) if one else None
            high = bound(joint.position_upper_limits()[0]) if one else None
            joints[joint.name()] = [joint.type_name(), low, high]
        count = scene.model_inspector().NumGeometriesForFrame if False else None
        return {'links': links, 'joints': joints, 'bodies': count}
    return read


def pinocchio_reader(folder):
    import pinocchio

    def read(path):
        model = pinocchio.buildModelFromUrdf(path)
        kinds = [pinocchio.GeometryType.VISUAL, pinocchio.GeometryType.COLLISION]
        geometry = [pinocchio.buildGeomFromUrdf(model, path, kind, [folder]) for kind in kinds]
        links = {f.name: None for f in model.frames if f.type == pinocchio.FrameType.BODY and f.name != 'universe'}
        joints = {}
        for n in range(1, model.njoints):
            j = model.joints[n]
            one = j.nq == 1
            low = bound(model.lowerPositionLimit[j.idx_q]) if one else None
            high = bound(model.upperPositionLimit[j.idx_q]) if one else None
            joints[model.names[n]] = [j.shortname(), low, high]
        mass = sum(i.mass for i in list(model.inertias)[1:])
        return {'links': links, 'joints': joints, 'mass': round(mass, 9),
                'bodies': sum(len(g.geometryObjects) for g in geometry)}
    return read


def pybullet_reader(folder):
    import pybullet

    def read(path):
        pybullet.connect(pybullet.DIRECT)
        pybullet.setAdditionalSearchPath(folder)
        robot = pybullet.loadURDF(path)
        if robot < 0:
            raise Rejected('loadURDF returned %d' % robot)
        kinds = {0: 'revolute', 1: 'prismatic', 2: 'spherical', 3: 'planar', 4: 'fixed'}
        base = pybullet.getBodyInfo(robot)[0].decode('utf-8', 'replace')
        links, joints, bodies = {base: pybullet.getDynamicsInfo(robot, -1)[0]}, {}, 0
        for n in range(-1, pybullet.getNumJoints(robot)):
            bodies += len(pybullet.getCollisionShapeData(robot, n))
            if n < 0:
                continue
            info = pybullet.getJointInfo(robot, n)
            joints[info[1].decode('utf-8', 'replace')] = [kinds[info[2]], bound(info[8]), bound(info[9])]
            links[info[12].decode('utf-8', 'replace')] = pybullet.getDynamicsInfo(robot, n)[0]
        bodies += len(pybullet.getVisualShapeData(robot))
        return {'links': links, 'joints': joints, 'bodies': bodies}
    return read


def of_objects(robot):
    """What the libraries in Python that keep elements as objects hold."""
    def mass(link):
        inertial = getattr(link, 'inertial', None)
        return getattr(inertial, 'mass', None) if inertial is not None else None

    def limits(joint):
        limit = getattr(joint, 'limit', None)
        low, high = getattr(limit, 'lower', None), getattr(limit, 'upper', None)
        return [None if v is None else bound(v) for v in (low, high)]
    links = {l.name: mass(l) for l in robot.links}
    joints = {j.name: [getattr(j, 'type', None) or getattr(j, 'joint_type', None), *limits(j)] for j in robot.joints}
    return {'links': links, 'joints': joints, 'bodies': None}


def yourdfpy_reader(folder):
    import yourdfpy

    def read(path):
        robot = yourdfpy.URDF.load(path)
        return of_objects(type('Robot', (), {'links': robot.robot.links, 'joints': robot.robot.joints}))
    return read


def urchin_reader(folder):
    import urchin

    def read(path):
        return of_objects(urchin.URDF.load(path))
    return read


def urdf_parser_py_reader(folder):
    from urdf_parser_py.urdf import URDF

    def read(path):
        with open(path, 'rb') as file:
            return of_objects(URDF.from_xml_string(file.read()))
    return read


def isaac_reader(folder):
    import urdf_usd_converter
    from pxr import Usd, UsdPhysics
    packages = [{'name': name, 'path': os.path.join(folder, name)} for name in sorted(os.listdir(folder))
                if os.path.isfile(os.path.join(folder, name, 'package.xml'))]

    def read(path):
        with tempfile.TemporaryDirectory() as out:
            asset = urdf_usd_converter.Converter(ros_packages=packages, scene=False).convert(path, out)
            stage = Usd.Stage.Open(asset.path)
            links, joints = {}, {}
            for prim in stage.Traverse():
                name = prim.GetDisplayName() or prim.GetName()
                if prim.HasAPI(UsdPhysics.RigidBodyAPI):
                    mass = UsdPhysics.MassAPI(prim).GetMassAttr().Get() if prim.HasAPI(UsdPhysics.MassAPI) else None
                    links[name] = mass
                elif prim.IsA(UsdPhysics.Joint):
                    joints[name] = [prim.GetTypeName(), None, None]
            return {'links': links, 'joints': joints, 'bodies': None}
    return read


def program_reader(program):
    """A program that prints the robot as JSON and ends with 0, or says why not and ends with another code."""
    import subprocess

    def read(path):
        run = subprocess.run([*program, path], capture_output=True, check=False)
        if run.returncode < 0:
            raise Rejected('crashed with signal %d' % -run.returncode)
        if run.returncode != 0:
            raise Rejected(run.stderr.decode('utf-8', 'replace').strip()[-300:])
        return json.loads(run.stdout.decode('utf-8', 'replace').strip().splitlines()[-1])
    return read


def check_urdf_reader(folder):
    """urdfdom 6, whose package brings no headers: `check_urdf` prints the links, and what it says is kept."""
    import re
    import subprocess
    prefix = os.path.join(sys.prefix, 'lib', 'python%d.%d' % sys.version_info[:2], 'site-packages', 'cmeel.prefix')
    program = os.path.join(prefix, 'bin', 'check_urdf')
    environment = {**os.environ, 'LD_LIBRARY_PATH': os.path.join(prefix, 'lib')}

    def read(path):
        run = subprocess.run([program, path], capture_output=True, check=False, env=environment)
        text = run.stdout.decode('utf-8', 'replace')
        if run.returncode != 0:
            raise Rejected(run.stderr.decode('utf-8', 'replace').strip()[-300:])
        names = re.findall(r'^(?:root Link: | *child\(\d+\):  )(.*?)(?: has \d+ child\(ren\))?$', text, re.M)
        return {'links': dict.fromkeys(names), 'joints': None, 'bodies': None, 'says': run.stderr.decode('utf-8', 'replace').strip()[-300:]}
    return read


PROGRAMS = os.environ.get('CONSUMERS_PROGRAMS', '')
READERS = {
    'urdfdom': check_urdf_reader,
    'urdfdom-3': lambda folder: program_reader([PROGRAMS + '/urdfdom-3']),
    'kdl': lambda folder: program_reader([PROGRAMS + '/kdl']),
    'gazebo': lambda folder: program_reader([PROGRAMS + '/gazebo']),
    'urdf-rs': lambda folder: program_reader([PROGRAMS + '/urdf-rs']),
    'mujoco': mujoco_reader,
    'drake': drake_reader,
    'pinocchio': pinocchio_reader,
    'pybullet': pybullet_reader,
    'yourdfpy': yourdfpy_reader,
    'urchin': urchin_reader,
    'urdf_parser_py': urdf_parser_py_reader,
    'isaac': isaac_reader,
}


def child(read, path, pipe):
    """Load one robot; the answer goes into the pipe."""
    with open(os.devnull, 'w', encoding='utf-8') as null:
        os.dup2(null.fileno(), 1)
        os.dup2(null.fileno(), 2)
    os.chdir(os.path.dirname(path))
    try:
        answer = {'loaded': True, **read(path)}
    except BaseException as error:  # pylint: disable=broad-except
        answer = {'loaded': False, 'why': '%s: %s' % (type(error).__name__, str(error)[:300])}
    os.write(pipe, json.dumps(answer).encode())
    os._exit(0)


def load(read, path):
    inside, outside = os.pipe()
    process = os.fork()
    if process == 0:
        os.close(inside)
        signal.alarm(SECONDS)
        child(read, path, outside)
    os.close(outside)
    parts = []
    while part := os.read(inside, 1 << 16):
        parts.append(part)
    os.close(inside)
    _, status = os.waitpid(process, 0)
    if parts:
        return json.loads(b''.join(parts))
    return {'loaded': False, 'why': 'ended by signal %d' % (status & 127)}


def main():
    reader, folder, *files = sys.argv[1:]
    if files == ['-']:
        files = sys.stdin.read().split('\n')
    if reader == 'urdf-loader':
        # starting it takes longer than a hundred robots
        import subprocess
        subprocess.run(['node', PROGRAMS + '/urdf-loader.mjs'], input='\n'.join(files).encode(), check=True)
        return
    read = READERS[reader](folder)
    for path in filter(None, files):
        print(json.dumps({'file': path, **load(read, path)}), flush=True)


if __name__ == '__main__':
    main()
