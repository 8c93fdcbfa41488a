"""Install the readers that registries offer, in versions that are fixed, below a folder."""
import collections
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = HERE / 'programs'
# What each reader needs of PyPI.
PYTHON = {
    'urdfdom': 'cmeel-urdfdom==6.0.0',
    'mujoco': 'mujoco==4.0.0',
    'drake': 'drake==1.51.1',
    'pinocchio': 'pin==4.1.0',
    'pybullet': 'pybullet==3.2.7',
    'yourdfpy': 'yourdfpy==0.0.60',
    'urchin': 'urchin==0.0.30',
    'urdf_parser_py': 'urdf-parser-py==0.0.4',
    'isaac': 'urdf-usd-converter==0.3.4',
}
# What is compiled: the source, the packages of Debian, and how pkg-config and the compiler call the libraries.
COMPILED = {
    'urdfdom-3': ('urdfdom.cpp', ['liburdfdom-dev'], ['urdfdom'], []),
    'kdl': ('urdfdom.cpp', ['liburdfdom-dev', 'libkdl-parser-dev'], ['urdfdom'],
            ['-DWITH_KDL', '-I/usr/include/eigen3', '-lkdl_parser', '-lorocos-kdl']),
    'gazebo': ('gazebo.cpp', ['libsdformat-dev'], ['sdformat12'], []),
}
JAVASCRIPT = ['urdf-loader@0.13.1', 'three@0.180', 'jsdom@27']
ALL = ['urdfdom', 'urdfdom-3', 'kdl', 'gazebo', 'urdf-rs', 'urdf-loader', 'mujoco', 'drake', 'pinocchio', 'pybullet', 'yourdfpy',
       'urchin', 'urdf_parser_py', 'isaac']

Tools = collections.namedtuple('Tools', 'python programs answers readers')


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit('%s: %s' % (' '.join(map(str, command))[:200], (done.stderr or done.stdout)[-500:]))
    return done.stdout


def python(folder, readers):
    """A virtual environment with the libraries of readers."""
    program = folder / 'python' / 'bin' / 'python'
    if not program.exists():
        run(sys.executable, '-m', 'venv', str(folder / 'python'))
    wanted = [PYTHON[reader] for reader in readers if reader in PYTHON]
    done = folder / 'python' / 'installed'
    known = set(done.read_text(encoding='utf-8').split()) if done.exists() else set()
    if set(wanted) - known:
        run(str(program), '-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', *wanted)
        done.write_text('\n'.join(sorted(known | set(wanted))), encoding='utf-8')
    return program


def debian(packages):
    missing = [name for name in packages if subprocess.run(['dpkg', '-s', name], capture_output=True, check=False).returncode]
    if missing:
        run(HERE.parent / 'apt.sh', *missing)


def compiled(folder, readers):
    for reader in readers:
        if reader not in COMPILED:
            continue
        source, packages, libraries, options = COMPILED[reader]
        program = folder / reader
        if program.exists() and program.stat().st_mtime > (PROGRAMS / source).stat().st_mtime:
            continue
        debian(['g++', 'pkg-config', *packages])
        flags = run('pkg-config', '--cflags', '--libs', *libraries).split()
        run('g++', '-std=c++17', str(PROGRAMS / source), '-o', str(program), *flags, *options)


def rust(folder):
    target = folder / 'cargo'
    run('cargo', 'build', '--quiet', '--manifest-path', str(PROGRAMS / 'urdf-rs' / 'Cargo.toml'),
        env={**os.environ, 'CARGO_TARGET_DIR': str(target)})
    (PROGRAMS / 'urdf-rs' / 'Cargo.lock').unlink(missing_ok=True)
    shutil.copy(target / 'debug' / 'read-urdf-rs', folder / 'urdf-rs')


def javascript(folder):
    if not (folder / 'node_modules' / 'jsdom').exists():
        run('npm', 'install', '--silent', '--no-save', '--prefix', str(folder), *JAVASCRIPT)
    shutil.copy(PROGRAMS / 'urdf-loader.mjs', folder / 'urdf-loader.mjs')


def tools(folder, readers):
    """The readers below `folder`; all when none are named."""
    folder = folder.resolve()
    readers = readers or ALL
    programs = folder / 'programs'
    programs.mkdir(parents=True, exist_ok=True)
    compiled(programs, readers)
    if 'urdf-rs' in readers:
        rust(programs)
    if 'urdf-loader' in readers:
        javascript(programs)
    return Tools(str(python(folder, readers)), programs, folder / 'answers', readers)
