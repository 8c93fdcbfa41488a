"""Running one program: the reference in a forked child, the tested command as a process."""
import contextlib
import io
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import traceback

import reference

TIME = 20  # seconds for one run
MEMORY = 2 << 30


class Result:
    """Exit status (None: out of time), stdout and stderr of a run."""

    def __init__(self, code, out, err):
        self.code, self.out, self.err = code, out, err

    def __eq__(self, other):
        return (self.code, self.out, self.err) == (other.code, other.out, other.err)


def write(program, folder):
    """Write the files of a program below `folder`, which is emptied first."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for path, data in program.files.items():
        full = os.path.join(folder, path)
        os.makedirs(os.path.dirname(full), exist_ok=True)
        with open(full, 'wb') as out:
            out.write(data)


def variables(program, folder):
    return {name: value.replace('@DIR@', folder) for name, value in program.env.items()}


def run_reference(program, folder):
    """Run the reference on the files in `folder`, in a child of this process."""
    xacro = preload()
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        child = os.fork()
        if child == 0:
            reference_child(xacro, program, folder, out.fileno(), err.fileno())
        _, status = os.waitpid(child, 0)
        out.seek(0)
        err.seek(0)
        code = os.waitstatus_to_exitcode(status)
        return Result(None if code == -signal.SIGALRM else code, out.read(), err.read())


def preload():
    """Import the reference and all that it imports later, so that children start at once."""
    import ament_index_python.packages
    import xacro
    import xacro.substitution_args
    import xml.dom.expatbuilder
    import yaml
    return xacro


def reference_child(xacro, program, folder, out, err):
    """The forked child: what the command `xacro` does; never returns."""
    code = 1
    try:
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.alarm(TIME)
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        os.chdir(folder)
        os.environ.update(variables(program, folder))
        sys.argv = ['xacro', 'input.xacro'] + program.args
        sys.stdout = io.TextIOWrapper(os.fdopen(out, 'wb', closefd=False), 'utf-8')
        sys.stderr = io.TextIOWrapper(os.fdopen(err, 'wb', closefd=False), 'utf-8', 'backslashreplace')
        xacro.main()
        code = 0
    except SystemExit as stop:
        code = stop.code if isinstance(stop.code, int) else 1
    except BaseException:
        traceback.print_exc()
    finally:
        with contextlib.suppress(Exception):
            sys.stderr.flush()
        try:
            sys.stdout.flush()
        except Exception:  # as at the end of the interpreter
            code = 1 if code == 0 else code
        os._exit(code)


def run_command(command, program, folder):
    """Run the tested command on the files in `folder`."""
    env = reference.environment(variables(program, folder))
    try:
        done = subprocess.run(command + ['input.xacro'] + program.args, cwd=folder, env=env, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=TIME)
    except subprocess.TimeoutExpired:
        return Result(None, b'', b'out of time')
    return Result(done.returncode, done.stdout, done.stderr)


#: Limits of ours and faults of the reference that docs/compatibility.md lists: what follows is no difference.
LIMITS = re.compile(rb"the method '\w+' of bytes is not supported here|range bounds of more than 120 bits")
ADDRESS = re.compile(rb'&lt;function \S+ at 0x')
FAULTS = re.compile(rb'ElementInfo\.isIdNS\(\) missing')


def judge(wanted, got):
    """What is wrong with `got` when the reference gave `wanted`: '' if nothing, None if that cannot be told."""
    if wanted.code is None or wanted.code not in (0, 2):
        return None  # the reference crashed or ran out of time
    if LIMITS.search(got.err) or FAULTS.search(wanted.err) or ADDRESS.search(wanted.out):
        return None
    if got.code is None:
        return 'no end within %d s' % TIME
    if wanted.code == 0 and got.code != 0:
        return 'an error where the reference succeeds'
    if wanted.code == 0:
        return '' if wanted.out == got.out else 'another output'
    if got.code == 0:
        return 'no error where the reference fails'
    if got.code != 2:
        return 'exit status %d instead of 2' % got.code
    if got.out:
        return 'output in spite of an error'
    return '' if got.err.strip() else 'no message with the error'
