"""One file under several names: network shares, letter case, links, and the paths that files of the user keep."""
import json
import os
import re

ARM = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{include}  <link name="base"/>\n{rest}</robot>\n'
TWICE = '  <joint name="j" type="fixed"><parent link="base"/><child link="tip"/></joint>\n'
TIP = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">\n  <link name="tip"/>\n</robot>\n'


def spellings(suite):
    """The ways to write the path of a file: slashes, letter case of the drive, both."""
    def of(path):
        local = suite.local(path)
        lower = local[0].lower() + local[1:]
        return {local.replace('\\', '/'), local.replace('/', '\\'), lower.replace('/', '\\'), lower.replace('\\', '/')}
    return of


def workspace(suite, name):
    folder = suite.folder / name
    (folder / 'parts').mkdir(parents=True)
    (folder / 'parts' / 'tip.xacro').write_text(TIP)
    (folder / 'arm.urdf.xacro').write_text(ARM.format(include='  <xacro:include filename="parts/tip.xacro"/>\n', rest=TWICE + TWICE))
    return folder


def listed(suite, *arguments, cwd):
    done = suite.run('check', *arguments, '--format', 'json', cwd=cwd)
    try:
        return [(finding['name'], finding['filename']) for finding in json.loads(done.stdout)]
    except ValueError:
        return done.stdout + done.stderr


def letter_case(suite):
    """A file that is included in two spellings that differ by case is one file."""
    folder = workspace(suite, 'case')
    include = '  <xacro:include filename="PARTS/Tip.xacro"/>\n'
    (folder / 'arm.urdf.xacro').write_text(ARM.format(include=include, rest=TWICE))
    done = suite.run('expand', 'arm.urdf.xacro', cwd=folder)
    suite.check('an include in other letter case', done.returncode == 0 and 'name="tip"' in done.stdout, done.stdout + done.stderr)
    found = listed(suite, 'ARM.urdf.xacro', '--show', 'all', cwd=folder)
    suite.check('a root in other letter case', isinstance(found, list), found)


def kept_paths(suite):
    """Baselines, suppressions, presets and changed files hold in each spelling of a path."""
    folder = workspace(suite, 'kept')
    root = folder / 'arm.urdf.xacro'
    all_ = listed(suite, '.', cwd=folder)
    suite.check('findings to keep', isinstance(all_, list) and len(all_) > 0, all_)
    for number, path in enumerate(sorted(spellings(suite)(root))):
        baseline = f'baseline{number}.json'
        suite.run('check', path, '--write-baseline', baseline, cwd=folder)
        text = (folder / baseline).read_text() if (folder / baseline).exists() else ''
        suite.check(f'a baseline written for {path}', text and '\\\\' not in text and not re.search(r'"[A-Za-z]:', text), text)
        for asked in ('.', 'arm.urdf.xacro', path):
            left = listed(suite, asked, '--baseline', baseline, cwd=folder)
            suite.check(f'the baseline for {path}, checking {asked}', left == [], left)
        changed = listed(suite, '.', '--changed', path, cwd=folder)
        suite.check(f'--changed {path}', changed == all_, changed)
    for file in ('arm.urdf.xacro', './arm.urdf.xacro'):
        (folder / 'xacro-lint.toml').write_text(f'[[roots]]\nfile = "{file}"\n[per-file-ignores]\n"arm.*" = ["ALL"]\n')
        for path in spellings(suite)(root):
            left = listed(suite, path, cwd=folder)
            suite.check(f'per-file-ignores, checking {path}', left == [], left)


def links(suite):
    """A folder that is reached through a link."""
    folder = workspace(suite, 'linked')
    try:
        os.symlink(folder, suite.folder / 'link', target_is_directory=True)
    except OSError as error:
        print(f'links: left out, this user may not make them ({error})')
        return
    done = suite.run('expand', 'arm.urdf.xacro', cwd=suite.folder / 'link')
    suite.check('a robot behind a link', done.returncode == 0 and 'name="tip"' in done.stdout, done.stdout + done.stderr)
    found = listed(suite, '.', cwd=suite.folder / 'link')
    suite.check('the findings behind a link', found == listed(suite, '.', cwd=folder), found)


def share(suite, unc):
    """A folder of another machine or of WSL: `\\\\server\\share\\...`, on the command line and from an editor."""
    folder = workspace(suite, 'remote')
    if suite.is_native:
        # the administrative share of the drive
        name = '\\\\localhost\\' + str(folder).replace(':', '$', 1)
        if not os.path.isdir(name):
            print('share: left out, no administrative share of the drive')
            return
    else:
        (unc / 'wsl.localhost').mkdir(parents=True, exist_ok=True)
        link = unc / 'wsl.localhost' / 'Ubuntu'
        link.unlink(missing_ok=True)
        link.symlink_to(folder)
        name = '\\\\wsl.localhost\\Ubuntu'
    for root in (name + '\\arm.urdf.xacro', (name + '\\arm.urdf.xacro').replace('\\', '/')):
        done = suite.run('expand', root)
        suite.check(f'expand {root}', done.returncode == 0 and 'name="tip"' in done.stdout, done.stdout + done.stderr)
        done = suite.run('check', root, '--format', 'concise')
        slashed = name.replace('\\', '/')
        suite.check(f'check {root}', done.returncode == 1 and '\\' not in done.stdout and slashed in done.stdout, done.stdout + done.stderr)
