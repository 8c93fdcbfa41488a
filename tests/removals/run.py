#!/usr/bin/env python3
"""Remove or rename links, joints, groups and interfaces of robots one by one: the files beside them that no longer fit must be found.

    tests/removals/run.py --bin target/release/xacro-lint                 in docs/examples/pick_arm
    tests/removals/run.py --bin target/release/xacro-lint FOLDER...       in other workspaces; each robot with files beside it
    tests/removals/run.py --bin target/release/xacro-lint --most 40 ...   at most so many removals of each workspace, spread evenly
    tests/removals/run.py --bin target/release/xacro-lint --rename ...    rename instead
    tests/removals/run.py --bin target/release/xacro-lint --seed 1 --count 100 FOLDER...
        so many changes drawn from all workspaces, see draw.py

A removal is the definition of one thing: a `<link>` or `<joint>` of the description or the call of the macro that makes it, a
`<group>` of the SRDF, an interface in `<ros2_control>`. Only names that a file beside the robot uses are removed. A removal is found when the linter reports something
that it did not report before, in a line that uses the name, or in the `<ros2_control>` that names the joint as well. The test
passes when 95 % are found. A rename gives the definition a new name in all that the robot itself reads; the files beside it keep the
old one.
"""
import argparse
import collections
import contextlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ENOUGH = 0.95
ENVIRONMENT = {k: v for k, v in os.environ.items() if not k.startswith(('ROS', 'AMENT', 'CMAKE_PREFIX', 'COLCON'))}

Removal = collections.namedtuple('Removal', 'kind name file start end')
# what a name gets at its end
RENAMED = '_renamed'


def run(command, folder, *arguments):
    done = subprocess.run([command, *arguments], cwd=folder, env=ENVIRONMENT, capture_output=True, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError('exit status %d: %s' % (done.returncode, done.stderr.decode('utf-8', 'replace')[-500:]))
    return done.stdout


def findings(command, folder):
    """What the linter reports as (rule, file, line, message)."""
    found = json.loads(run(command, folder, 'check', '--no-group', '--show', 'all', '--format', 'json', '.'))
    return [(f['name'], f['filename'], f['location']['row'], f['message']) for f in found]


def fresh(after, before):
    known = collections.Counter((rule, file, message) for rule, file, _, message in before)
    for rule, file, line, message in after:
        if known[rule, file, message] > 0:
            known[rule, file, message] -= 1
        else:
            yield rule, file, line, message


def element(text, start):
    """The end of the element whose start tag begins at `start`."""
    tag = re.match(r'<([\w:.-]+)', text[start:]).group(1)
    depth = 0
    for match in re.finditer(r'<!--.*?-->|<(/?)%s(?=[\s/>])(?:"[^"]*"|\'[^\']*\'|[^>"\'])*?(/?)>' % re.escape(tag), text[start:], re.S):
        if match.group(0).startswith('<!--'):
            continue
        depth += -1 if match.group(1) else 0 if match.group(2) else 1
        if depth == 0:
            return start + match.end()
    return None


def may_be(pattern, name):
    """Whether a name as it is written may become this one: `${prefix}elbow` may be `left_elbow`."""
    parts = re.split(r'\$\{[^}]*\}|\$\([^)]*\)', pattern)
    return len(''.join(parts)) > 1 and re.fullmatch('.*'.join(map(re.escape, parts)), name) is not None


def definitions(text, tag, name):
    """The elements that define a link, joint or group of this name."""
    blank = re.sub(r'<!--.*?-->', lambda match: re.sub('[^\n]', ' ', match.group(0)), text, flags=re.S)
    for match in re.finditer(r'<(?:%s)\s(?:"[^"]*"|[^>"])*?\bname="([^"]+)"' % tag, blank):
        end = element(text, match.start())
        if end and may_be(match.group(1), name):
            yield match.start(), end


def descriptions(folder):
    """The files that may be robots."""
    return [path for path in sorted(folder.rglob('*'))
            if path.is_file() and path.name.endswith(('.urdf', '.xacro')) and 'srdf' not in path.name]


def robot(command, folder, path):
    """A description with files beside it: its name, links and joints, its files, and the files beside; None without any."""
    inside = str(path.relative_to(folder))
    try:
        deps = json.loads(run(command, folder, 'deps', inside, '--format', 'json'))
        beside = [entry['path'] for entry in deps['beside'] if entry['kind'] != 'setup-assistant']
        tree = json.loads(run(command, folder, 'tree', inside, '--format', 'json') or 'null') if beside else None
    except (RuntimeError, ValueError):
        return None
    return (inside, tree, [file for file in deps['files'] if file.startswith(str(folder))], beside) if tree else None


def uses(name, texts):
    """Lines of files that use a name, as (file, line); frames, comments and the names of virtual joints are no use."""
    word = re.compile(r'(?<![\w-])%s(?![\w-])' % re.escape(name))
    unused = re.compile(r'\bparent_frame="[^"]*"|\w*frame\w*:.*|(^|\s)#.*|<!--.*?-->|(?<=<virtual_joint )name="[^"]*"')
    return {(file, number) for file, text in texts.items() for number, line in enumerate(text.splitlines(), 1)
            if word.search(unused.sub('', line))}


def gives(command, folder, root, kind, name):
    """Whether the expanded robot defines a link or joint of this name."""
    text = run(command, folder, 'expand', root).decode('utf-8', 'replace')
    return re.search(r'<%s\s(?=[^>]*\bname="%s")%s' % (kind, re.escape(name), '[^>]*type=' if kind == 'joint' else ''), text) is not None


def without(text, start, end):
    """A text without a part; lines stay where they are."""
    return text[:start] + re.sub('[^\n]', '', text[start:end]) + text[end:]


def renamed(text, kind, written):
    """A text in which a link or joint, as its name is written, has another name where it is defined and where others refer to it."""
    place = r'(?:<%s\s(?:"[^"]*"|[^">])*?\bname=|\b(?:%s|reference)=)"%s(?=")' % (kind, kind, re.escape(written))
    text = re.sub(place, lambda match: match.group(0) + RENAMED, text)
    return text.replace('>%s<' % written, '>%s<' % (written + RENAMED))


def changed(removal, files, is_rename):
    """The texts of files after a removal, or a rename instead; `files` are those that the robot reads."""
    text = read(removal.file)
    if not is_rename:
        return {removal.file: without(text, removal.start, removal.end)}
    end = re.compile(r'<(?:"[^"]*"|[^">])*').match(text, removal.start).end()
    tag = text[removal.start:end]
    written = re.search(r'\bname="([^"]+)"', tag).group(1)
    if re.match('<(?:link|joint)\\s', tag):
        return {file: renamed(read(file), removal.kind, written) for file in {removal.file, *files}}
    tag = re.sub(r'(\bname="[^"]+)"', r'\1%s"' % RENAMED, tag, count=1)
    return {removal.file: text[:removal.start] + tag + text[end:]}


@contextlib.contextmanager
def applied(texts):
    """Files have other texts for a while."""
    before = {file: pathlib.Path(file).read_bytes() for file in texts}
    for file, text in texts.items():
        pathlib.Path(file).write_text(text, 'utf-8')
    try:
        yield
    finally:
        for file, data in before.items():
            pathlib.Path(file).write_bytes(data)


def place_of(command, folder, root, files, kind, name):
    """The element without which the robot lacks a link or joint: its definition, or the call of a macro that makes it."""
    for tag in (kind, r'xacro:[\w.]+'):
        for file in files:
            text = read(file)
            for start, end in definitions(text, tag, name):
                with applied({file: without(text, start, end)}):
                    is_gone = not gives(command, folder, root, kind, name)
                if is_gone:
                    return file, start, end
    return None


def read(file):
    return pathlib.Path(file).read_text('utf-8', 'replace')


def removals(command, folder):
    seen = set()

    def new(kind, name, file, start, end):
        is_new = (file, start) not in seen
        seen.add((file, start))
        return [Removal(kind, name, file, start, end)] if is_new and end else []

    for root, tree, files, beside in filter(None, (robot(command, folder, path) for path in descriptions(folder))):
        texts = {file: read(file) for file in beside}
        named = [('link', name) for name in tree['links']] + [('joint', joint['name']) for joint in tree['joints']]
        for kind, name in named:
            place = uses(name, texts) and place_of(command, folder, root, files, kind, name)
            if place:
                yield from new(kind, name, *place)
        for file in (file for file in beside if file.endswith('.srdf')):
            for name in re.findall(r'<group\s+name="([^"]+)"\s*>', texts[file]):
                place = next(definitions(texts[file], 'group', name), None)
                if place and len(uses(name, texts)) > 1:
                    yield from new('group', name, file, *place)
        for kind in ('command', 'state'):
            wanted = {pair for text in texts.values() for pair in interfaces_used(text, kind)}
            for file in files:
                text = read(file)
                for match in re.finditer(r'<%s_interface\s+name="(\w+)"' % kind, text):
                    joint = re.findall(r'<(?:joint|xacro:\w+)\s[^>]*?name="([^"]+)"', text[:match.start()])[-1:]
                    is_any = joint and re.fullmatch(r'\$\{[^}]*\}', joint[0])
                    if joint and any(name == match.group(1) and (is_any or may_be(joint[0], used)) for used, name in wanted):
                        yield from new('interface', match.group(1), file, match.start(), element(text, match.start()))


def interfaces_used(text, kind):
    """The joints of controllers with the interfaces that these list for them."""
    for block in re.split(r'\n(?=\S)', text):
        lists = {key: re.findall(r'[\w-]+', re.sub(r'#.*', '', words)) for key, words in
                 re.findall(r'\n\s+(joints|%s_interfaces):((?:\s*-\s*\w+[^\n]*|\s*\[[^]]*\])+)' % kind, block)}
        for joint in lists.get('joints', []):
            for interface in lists.get(kind + '_interfaces', []):
                yield joint, interface


def is_found(removal, new, folder, texts):
    places = uses(removal.name, texts)
    for rule, file, line, message in new:
        path = str((folder / file).resolve())
        if removal.kind == 'interface' and rule == 'controller-unknown-interface':
            return True
        if (path, line) in places and path != removal.file:
            return True
        if removal.kind == 'group' and (rule, path) == ('srdf-unknown-group', removal.file):
            return True
        if removal.kind == 'joint' and rule in ('ros2-control-unknown-joint', 'transmission-unknown-joint') and '`%s`' % removal.name in message:
            return True
    return False


def beside_files(folder):
    suffixes = ('.srdf', '.srdf.xacro', '.yaml', '.yml')
    return {str(path.resolve()): path.read_text('utf-8', 'replace') for path in folder.rglob('*')
            if path.is_file() and path.name.endswith(suffixes)}


def copied(source, into):
    """A copy of a workspace without meshes, as a repository of its own."""
    folder = pathlib.Path(into).resolve() / source.name
    unneeded = shutil.ignore_patterns('.git', '*.stl', '*.STL', '*.dae', '*.obj', '*.png', '*.jpg')
    shutil.copytree(source, folder, symlinks=True, ignore=unneeded)
    (folder / '.git').mkdir(exist_ok=True)
    return folder


def tell(removal, is_rename, folder, found, new):
    line = read(removal.file).count('\n', 0, removal.start) + 1
    place = '%s:%d' % (pathlib.Path(removal.file).relative_to(folder.parent), line)
    what = ('found' if found else 'NOT FOUND', 'rename' if is_rename else 'removal', removal.kind, removal.name, place)
    print('%s: %s of %s `%s` of %s' % what, flush=True)
    for rule, file, line, message in ([] if found else new[:4]):
        print('    %s:%d %s: %s' % (file, line, rule, message))


def remove(command, source, options):
    """How many removals were tried and found by kind."""
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as name:
        folder = copied(source, name)
        before, texts = findings(command, folder), beside_files(folder)
        planned = list(removals(command, folder))
        step = max(1, -(-len(planned) // options.most)) if options.most else 1
        for removal in planned[::step]:
            with applied(changed(removal, map(str, descriptions(folder)), options.rename)):
                new = list(fresh(findings(command, folder), before))
            found = is_found(removal, new, folder, texts)
            counts[removal.kind, found] += 1
            if options.verbose or not found:
                tell(removal, options.rename, folder, found, new)
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--bin', default='target/release/xacro-lint')
    parser.add_argument('--most', type=int, default=0)
    parser.add_argument('--rename', action='store_true')
    parser.add_argument('--seed', type=int)
    parser.add_argument('--count', type=int, default=100)
    parser.add_argument('--verbose', action='store_true')
    parser.add_argument('folders', nargs='*', type=pathlib.Path)
    options = parser.parse_args()
    command = str(pathlib.Path(options.bin).resolve())
    folders = [folder.resolve() for folder in options.folders or [HERE.parent.parent / 'docs' / 'examples' / 'pick_arm']]
    total = collections.Counter()
    if options.seed is not None:
        import draw  # which needs this file
        total = draw.changes(command, folders, options)
    else:
        for folder in folders:
            counts = remove(command, folder, options)
            found = sum(count for (_, is_it), count in counts.items() if is_it)
            print('%s: %d of %d found' % (folder.name, found, sum(counts.values())), flush=True)
            total += counts
    for kind in sorted({kind for kind, _ in total}):
        print('%-9s %d of %d' % (kind, total[kind, True], total[kind, True] + total[kind, False]))
    found, tried = sum(count for (_, is_it), count in total.items() if is_it), sum(total.values())
    print('%d of %d found' % (found, tried))
    return 0 if tried and found >= ENOUGH * tried else 1


if __name__ == '__main__':
    sys.exit(main())
