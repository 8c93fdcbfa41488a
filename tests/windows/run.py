#!/usr/bin/env python3
"""The programs for Windows under Wine, compared with those for this system; with --native on Windows itself.

    run.py --bin target/release/xacro-lint [--arguments N]   build for Windows, run under Wine, compare
    run.py --native --bin target/release/xacro-lint.exe      what needs no comparison

Wine is not Windows: letter case, locks and consoles differ, so this is a lower bound; the hosted workflow runs the second form.
"""
import argparse
import functools
import os
import random
import re
import stat
import subprocess
import sys
import tempfile
from pathlib import Path

import build
import processes
import protocol
import spellings

REPOSITORY = build.REPOSITORY
FUNCTIONS = {'sin': 10, 'cos': 10, 'tan': 10, 'asin': 1, 'acos': 1, 'atan': 20, 'exp': 20, 'log': 0, 'log10': 0, 'sqrt': 0,
             'sinh': 10, 'cosh': 10, 'tanh': 5, 'pow': 0, 'atan2': 10}
CHUNK = 2000
# seconds for a command: under Wine, with another one beside it, the largest example takes more than two minutes
PATIENCE = 400
# glibc itself gives another last bit for one argument in a thousand on processors without fused multiplication
MOST_DIFFERENT = 0.005
PARTS = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="tip"><link name="tip"/></xacro:macro></robot>\n'
ROBOT = '''<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="{include}"/>
  <xacro:property name="own" value="$(find arm)"/>
  <xacro:tip/>
  <link name="base"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="tip"/></joint>
  <w cwd="$(cwd)" own="${{own}}" uri="file://$(find arm)/a.stl" also="file://${{own}}/a.stl" power="${{10**-2}}"
     yaml="${{xacro.load_yaml('$(find arm)/config/arm.yaml')['reach']}}"/>
</robot>
'''


class Suite:
    """The program under test, and the folder in which it is tested."""

    def __init__(self, command, program, folder, is_native):
        self.command, self.program, self.folder, self.is_native = command, program, folder, is_native
        self.environment = dict(os.environ, **({} if is_native else build.ENVIRONMENT))
        self.passed, self.failed = 0, 0

    def local(self, path):
        """A path as Windows names it."""
        return str(path) if self.is_native else 'Z:' + str(path)

    def run(self, *arguments, cwd=None, **variables):
        return subprocess.run([*self.command, *map(str, arguments)], cwd=cwd or self.folder, capture_output=True,
                              encoding='utf-8', timeout=PATIENCE, env=dict(self.environment, **variables), stdin=subprocess.DEVNULL)

    def check(self, name, is_right, found=''):
        self.passed, self.failed = self.passed + bool(is_right), self.failed + (not is_right)
        if not is_right:
            print(f'FAILED {name}: {str(found)[:600]}')


def workspace(folder):
    package = folder / 'arm'
    (package / 'config').mkdir(parents=True)
    (package / 'urdf').mkdir()
    (package / 'package.xml').write_text('<package><name>arm</name><version>1.0.0</version></package>')
    (package / 'config' / 'arm.yaml').write_text('reach: 0.7\n')
    (package / 'urdf' / 'parts.xacro').write_text(PARTS)
    for name, include in [('arm', 'parts.xacro'), ('back', '..\\urdf\\parts.xacro'), ('cwd', '$(cwd)/arm/urdf/parts.xacro')]:
        (package / 'urdf' / f'{name}.urdf.xacro').write_text(ROBOT.format(include=include))
    return package


def paths(suite):
    """Slashes and drives in what is written; the spellings that are read."""
    package = workspace(suite.folder)
    root = suite.local(suite.folder).replace('\\', '/')
    root = root[0].upper() + root[1:]
    own = f'{root}/arm'
    for name in ('arm', 'back', 'cwd'):
        for spelling in (f'arm/urdf/{name}.urdf.xacro', f'arm\\urdf\\{name}.urdf.xacro',
                         suite.local(package / 'urdf' / f'{name}.urdf.xacro').replace('/', '\\').replace('Z:', 'z:')):
            done = suite.run('expand', spelling)
            expected = [f'cwd="{root}"', f'own="{own}"', f'uri="file:///{own}/a.stl"', f'also="file:///{own}/a.stl"',
                        'power="0.01"', 'yaml="0.7"']
            suite.check(f'expand {spelling}', done.returncode == 0 and all(part in done.stdout for part in expected)
                        and '\\' not in done.stdout, done.stdout + done.stderr)
    done = suite.run('expand', 'arm/urdf/arm.urdf.xacro', '--root-dir', suite.local(suite.folder) + '\\')
    suite.check('--root-dir', f'cwd="{root}"' in done.stdout, done.stdout + done.stderr)
    suite.check('--deps', '\\' not in suite.run('expand', '--deps', 'arm\\urdf\\back.urdf.xacro').stdout)
    changed = suite.local(package / 'urdf' / 'parts.xacro').replace('Z:', 'z:').replace('/', '\\')
    done = suite.run('check', '.', '--changed', changed, '--format', 'concise')
    suite.check('--changed', done.returncode in (0, 1) and '\\' not in done.stdout, done.stdout + done.stderr)
    for name in ('nul', 'Z:parts.xacro', '\\\\.\\COM1'):
        (package / 'urdf' / 'odd.urdf.xacro').write_text(ROBOT.format(include=name))
        done = suite.run('expand', 'arm/urdf/odd.urdf.xacro')
        suite.check(f'include of {name}', done.returncode == 2 and 'it ' in done.stderr, done.stderr)
    (package / 'urdf' / 'odd.urdf.xacro').unlink()
    deep = suite.folder / ('long_name_' * 12) / ('long_name_' * 12)
    deep.mkdir(parents=True)
    (deep / 'r.urdf').write_text('<robot name="r"><link name="a"/></robot>\n')
    done = suite.run('check', suite.local(deep / 'r.urdf'))
    suite.check('a path of more than 260 letters', done.returncode == 0, done.stdout + done.stderr)


def packages(suite):
    """A list of prefixes with semicolons, as `local_setup.bat` sets it."""
    outside = suite.folder / 'outside'
    for prefix, name in (('one', 'hand'), ('two', 'wrist')):
        share = outside / prefix / 'share'
        (share / name).mkdir(parents=True)
        index = share / 'ament_index' / 'resource_index' / 'packages'
        index.mkdir(parents=True)
        (index / name).write_text('')
    (outside / 'r.xacro').write_text('<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
                                     '<w a="$(find hand)" b="$(find wrist)"/></robot>\n')
    prefixes = [suite.local(outside / prefix).replace('/', '\\') for prefix in ('one', 'two')]
    done = suite.run('expand', 'r.xacro', cwd=outside, AMENT_PREFIX_PATH=';'.join(prefixes))
    suite.check('AMENT_PREFIX_PATH', done.returncode == 0 and done.stdout.count('/share/') == 2 and '\\' not in done.stdout,
                done.stdout + done.stderr)


def is_all_or_nothing(done, path, before, after):
    """Either the file is fixed, or it is as it was and its name is in the message."""
    if done.returncode == 0:
        return path.read_bytes() == after
    return path.read_bytes() == before and path.name in done.stderr + done.stdout and 'panicked' not in done.stderr


def fixes(suite):
    """A file that may not be written stays as it is, with a message; others are fixed."""
    path = suite.folder / 'fix.urdf'
    text = '<robot name="r">\r\n  <link name="a"/>\r\n  <link name="b"/>\r\n  <joint name="j" type="Fixed">\r\n' \
           '    <parent link="a"/>\r\n    <child link="b"/>\r\n  </joint>\r\n</robot>\r\n'
    path.write_bytes(text.encode())
    path.chmod(stat.S_IREAD)
    fixed = text.replace('"Fixed"', '"fixed"').encode()
    # under Wine, files that programs of this system hold are free, and the owner may write read-only ones
    done = suite.run('fix', 'fix.urdf', '--unsafe-fixes')
    suite.check('a read-only file', is_all_or_nothing(done, path, text.encode(), fixed), done.stdout + done.stderr)
    path.chmod(stat.S_IREAD | stat.S_IWRITE)
    path.write_bytes(text.encode())
    with path.open('rb'):
        done = suite.run('fix', 'fix.urdf', '--unsafe-fixes')
    suite.check('a file that is open elsewhere', is_all_or_nothing(done, path, text.encode(), fixed), done.stdout + done.stderr)
    path.write_bytes(text.encode())
    done = suite.run('fix', 'fix.urdf', '--unsafe-fixes')
    suite.check('a file is fixed', done.returncode == 0 and path.read_bytes() == fixed, done.stdout + done.stderr)


def output(suite):
    """Unicode and colors in pipes."""
    path = suite.folder / 'größe.urdf'
    path.write_text('<robot name="r"><link name="ärm"/><joint name="j"/></robot>\n', encoding='utf-8')
    done = suite.run('check', 'größe.urdf')
    suite.check('letters beyond ASCII', 'größe.urdf' in done.stdout and '\x1b' not in done.stdout, done.stdout + done.stderr)
    done = suite.run('check', 'größe.urdf', CLICOLOR_FORCE='1')
    suite.check('colors when asked for', '\x1b[' in done.stdout, done.stdout)


def server(suite, command):
    """Three spellings of one URI, with line ends of Windows."""
    path = suite.folder / 'arm' / 'urdf' / 'arm.urdf.xacro'
    drive, rest = suite.local(path).replace('\\', '/').split(':', 1)
    text = path.read_text().replace('\n', '\r\n')
    for spelling in (f'{drive}:', f'{drive.lower()}%3A', f'{drive.lower()}:'):
        uri = f'file:///{spelling}{rest}'
        root = uri.rsplit('/', 3)[0]
        findings, hover, definition, code = protocol.session(command, root, uri, text)
        is_found = 'parts.xacro' in str(definition) and '\\' not in str(definition)
        suite.check(f'server with {uri}', hover and is_found and code == 0, (findings, hover, definition, code))


def examples(suite, here):
    """The findings of the example robots, byte for byte."""
    for folder in sorted(path for path in (REPOSITORY / 'docs/examples').iterdir() if path.is_dir()):
        arguments = ('check', folder.relative_to(REPOSITORY), '--format', 'json')
        ours = subprocess.run([here, *map(str, arguments)], cwd=REPOSITORY, capture_output=True, encoding='utf-8')
        theirs = suite.run(*arguments, cwd=REPOSITORY)
        same = (ours.returncode, ours.stdout) == (theirs.returncode, theirs.stdout)
        suite.check(f'findings of {folder.name}', same, theirs.stdout + theirs.stderr)


def numbers(suite, here, count):
    """How many results of each function have other bits than here."""
    number = random.Random(1)
    for name, limit in FUNCTIONS.items():
        different = 0
        for first in range(0, count, CHUNK):
            lines = []
            for _ in range(min(CHUNK, count - first)):
                x = number.uniform(-limit, limit) if limit else number.uniform(0, 100)
                x = round(x, 3) if number.random() < 0.3 else x
                call = f'{x!r} ** {number.uniform(-4, 4)!r}' if name == 'pow' else \
                    f'atan2({x!r}, {number.uniform(-4, 4)!r})' if name == 'atan2' else f'{name}({x!r})'
                lines.append(f'<w v="${{{call}}}"/>')
            path = suite.folder / 'numbers.xacro'
            path.write_text('<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n' + '\n'.join(lines) + '\n</robot>\n')
            values = lambda text: re.findall(r'v="([^"]*)"', text)
            ours = subprocess.run([here, 'expand', path], capture_output=True, encoding='utf-8')
            one, other = values(ours.stdout), values(suite.run('expand', 'numbers.xacro').stdout)
            if len(one) != len(other) or not one:
                different = count
                break
            different += sum(a != b for a, b in zip(one, other))
        print(f'{name}: {different} of {count} in another last digit')
        suite.check(f'bits of {name}', different <= max(1, MOST_DIFFERENT * count), different)


def repository(suite, folder, here):
    """The repository's own fixtures against the program under Wine."""
    program = build.command(folder, 'xacro-lint', is_filtered=True)
    done = subprocess.run(['cargo', 'test', '--quiet', '--test', 'conformance'], cwd=REPOSITORY, capture_output=True,
                          encoding='utf-8', env=dict(os.environ, XACRO_LINT_PROGRAM=str(program)))
    suite.check('conformance', done.returncode == 0, done.stdout[-3000:] + done.stderr[-1000:])
    done = subprocess.run([sys.executable, 'tests/fixes/run.py', '--bin', str(program), '--count', '30'], cwd=REPOSITORY,
                          capture_output=True, encoding='utf-8')
    suite.check('fixes', done.returncode == 0, done.stdout[-1500:] + done.stderr[-500:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--bin', required=True, help='the program for this system')
    parser.add_argument('--native', action='store_true', help='this system is Windows')
    parser.add_argument('--arguments', type=int, default=CHUNK, help='arguments of each function')
    parser.add_argument('--only', help='names of checks, with commas')
    options = parser.parse_args()
    here = str(Path(options.bin).resolve())
    if options.native:
        command, program, launcher = [here], here, [str(Path(here).with_name('xacro-lsp.exe'))]
    else:
        folder = build.build()
        command, program = [str(build.command(folder, 'xacro-lint', is_filtered=False))], folder / 'xacro-lint.exe'
        launcher = [str(build.command(folder, 'xacro-lsp', is_filtered=False))]
    with tempfile.TemporaryDirectory() as temporary:
        suite = Suite(command, program, Path(temporary).resolve(), options.native)
        checks = {'paths': lambda: paths(suite), 'packages': lambda: packages(suite), 'fixes': lambda: fixes(suite),
                  'output': lambda: output(suite), 'server': lambda: server(suite, launcher),
                  'share': lambda: spellings.share(suite, build.HOME / 'prefix' / 'dosdevices' / 'unc')}
        own = [spellings.letter_case, spellings.kept_paths, spellings.links, processes.locks, processes.code_pages, processes.interrupt,
               processes.watching, processes.preview]
        checks |= {check.__name__: functools.partial(check, suite) for check in own}
        if not options.native:
            checks |= {'examples': lambda: examples(suite, here), 'numbers': lambda: numbers(suite, here, options.arguments),
                       'repository': lambda: repository(suite, folder, here)}
        for name in options.only.split(',') if options.only else checks:
            checks[name]()
    print(f'windows: {suite.passed} passed, {suite.failed} failed')
    return 1 if suite.failed or not suite.passed else 0


if __name__ == '__main__':
    sys.exit(main())
