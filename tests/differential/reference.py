"""The reference xacro: where to find it and how to run its command."""
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
REPOSITORY = os.path.dirname(os.path.dirname(HERE))
STAND_IN = os.path.join(HERE, 'stand_in')
VERSION = '2.1.1'


def python(given=None):
    """Path of a Python that can import the reference; makes `target/venv` when none is given."""
    if given:
        return given
    folder = os.path.join(REPOSITORY, 'target', 'venv')
    found = os.path.join(folder, 'bin', 'python')
    probe = [found, '-c', 'import importlib.metadata as m; assert m.version("xacro") == "%s"' % VERSION]
    if not os.path.exists(found) or subprocess.run(probe, stderr=subprocess.DEVNULL).returncode:
        print('installing xacro %s into %s' % (VERSION, os.path.relpath(folder)), file=sys.stderr)
        subprocess.run([sys.executable, '-m', 'venv', folder], check=True)
        subprocess.run([found, '-m', 'pip', 'install', '--quiet', '--disable-pip-version-check',
                        'xacro==' + VERSION], check=True)
    return found


def environment(extra=None):
    """Environment for the reference: the package index stand-in, no packages but those of `extra`."""
    env = {k: v for k, v in os.environ.items() if k not in ('AMENT_PREFIX_PATH', 'ROS_PACKAGE_PATH')}
    env.update(extra or {}, PYTHONPATH=STAND_IN)
    return env


def command(interpreter):
    """The command `xacro` as a list of words."""
    return [interpreter, '-c', 'import sys, xacro; sys.argv[0] = "xacro"; sys.exit(xacro.main())']


def expand(interpreter, args, folder, extra=None):
    """Run the command `xacro ARGS` in `folder`: exit status, stdout, stderr as text."""
    done = subprocess.run(command(interpreter) + args, cwd=folder, env=environment(extra), capture_output=True)
    return done.returncode, done.stdout.decode('utf-8', 'replace'), done.stderr.decode('utf-8', 'replace')
