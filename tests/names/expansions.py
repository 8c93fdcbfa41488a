"""Expansions of robots in a copy of their folder, with texts replaced for one run."""
import os
import pathlib
import shutil
import subprocess

import texts

SECONDS = 20
ENVIRONMENT = {k: v for k, v in os.environ.items() if not k.startswith(('ROS', 'AMENT', 'CMAKE_PREFIX', 'COLCON'))}
TEXTS = ('.xacro', '.urdf', '.srdf', '.xml', '.yaml', '.yml', '.toml', '.gazebo', '.trans', '.sdf', '.launch', '.py')


def put(path, data):
    path.unlink() if data is None else path.write_bytes(data)


class Run:
    """What the expander said."""

    def __init__(self, code, out, err):
        self.code, self.out, self.err = code, out, err

    def marks(self, word):
        """What messages that begin with a word say, in order."""
        return [line[len(word) + 1:] for line in self.err.splitlines() if line.startswith(word + ' ')]


class Copy:
    """A copy of a folder whose files are replaced for a run and put back."""

    def __init__(self, bin_, folder, to):
        self.bin, self.folder, self.at = os.path.abspath(bin_), os.path.abspath(folder), os.path.abspath(to)
        self.runs = 0
        for directory, names, files in os.walk(self.folder):
            names[:] = [name for name in names if not name.startswith('.')]
            target = os.path.join(self.at, os.path.relpath(directory, self.folder))
            os.makedirs(target, exist_ok=True)
            for name in files:
                if name.endswith(TEXTS):
                    shutil.copyfile(os.path.join(directory, name), os.path.join(target, name))
        # the folder that holds the packages says which of them are found
        self.search = sorted({os.path.dirname(path) for path in texts.packages(self.folder).values()})

    def moved(self, path):
        """The path in the copy of a path in the folder."""
        return os.path.join(self.at, os.path.relpath(path, self.folder))

    def run(self, main, args, edits):
        """Expand with edits: path to a list of (start, end, new)."""
        read = {path: pathlib.Path(self.moved(path)).read_bytes().decode('utf-8') for path in edits}
        return self.run_with(main, args, {path: texts.replaced(read[path], changes) for path, changes in edits.items()})

    def run_with(self, main, args, files):
        """Expand with other texts of files; None: the file is gone."""
        originals = {}
        try:
            for path, text in files.items():
                target = pathlib.Path(self.moved(path))
                originals[target] = target.read_bytes() if target.exists() else None
                put(target, None if text is None else text.encode('utf-8'))
            return self.expand(main, args)
        finally:
            for target, data in originals.items():
                put(target, data)

    def expand(self, main, args):
        self.runs += 1
        command = [self.bin, 'expand', self.moved(main), *args]
        for folder in self.search:
            command += ['--package-path', self.moved(folder)]
        try:
            done = subprocess.run(command, cwd=self.at, env=ENVIRONMENT, capture_output=True, timeout=SECONDS, check=False)
        except subprocess.TimeoutExpired:
            return Run(99, '', 'too slow')
        return Run(done.returncode, done.stdout.decode('utf-8', 'replace'), done.stderr.decode('utf-8', 'replace'))
