#!/usr/bin/env python3
"""Rewrite robots so that they mean the same: the linter must find the same.

    tests/metamorphic/run.py --bin target/release/xacro-lint [--count 300] [--seed 1] [--keep DIR]

Each robot is one of tests/planted, most of them with a planted defect. It is checked before and after one change without
meaning: a comment, white space, a condition that holds around an element, elements moved into an included file, a name
changed everywhere, two links or joints in the other order. Rule, severity and message of all findings must stay.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / 'planted')]
import defects  # noqa: E402
import robots  # noqa: E402

JOBS = 2
ENVIRONMENT = {k: v for k, v in os.environ.items() if not k.startswith(('ROS', 'AMENT', 'CMAKE_PREFIX', 'COLCON'))}
# what speaks of the text itself, not of the robot; xacro keeps a comment in front of a macro only if a blank line follows it
OF_THE_TEXT = {'unused-include', 'missing-xml-declaration', 'unused-suppression', 'constant-condition', 'description-read-as-yaml'}
TAG = re.compile(r'<(/?)([\w.:-]+)((?:"[^"]*"|\'[^\']*\'|[^>"\'])*?)(/?)>|<!--.*?-->|<\?.*?\?>', re.S)


def findings(command, folder):
    run = subprocess.run([command, 'check', '--no-group', '--format', 'json', '.'], cwd=folder, env=ENVIRONMENT, capture_output=True, check=False)
    found = [(f['name'], f['severity'], f['message']) for f in json.loads(run.stdout) if f['name'] not in OF_THE_TEXT]
    return collections.Counter(found)


def children(text):
    """The elements directly below the root as (start, end, name); none when the text is not well-formed."""
    open_tags, found = [], []
    for match in TAG.finditer(text):
        if not match[2]:
            continue
        if match[1]:
            if not open_tags or open_tags[-1][1] != match[2]:
                return []
            start, name = open_tags.pop()
            if len(open_tags) == 1:
                found.append((start, match.end(), name))
        elif not match[4]:
            open_tags.append((match.start(), match[2]))
        elif len(open_tags) == 1:
            found.append((match.start(), match.end(), match[2]))
    return [] if open_tags else found


def is_xacro(text):
    return 'xmlns:xacro="http' in text


def commented(rng, texts):
    file = rng.choice(sorted(texts))
    places = [end for _, end, _ in children(texts[file])]
    if places:
        at = rng.choice(places)
        texts[file] = texts[file][:at] + '\n  <!-- a note -->' + texts[file][at:]
    return bool(places)


def spaced(rng, texts):
    file = rng.choice(sorted(texts))
    places = [start for start, _, _ in children(texts[file])]
    if places:
        at = rng.choice(places)
        texts[file] = texts[file][:at] + '\n\n\t   ' + texts[file][at:]
    return bool(places)


def wrapped(rng, texts):
    file = rng.choice(sorted(texts))
    text = texts[file]
    plain = [part for part in children(text) if part[2] in ('link', 'joint', 'material', 'transmission', 'ros2_control')]
    if not plain or not is_xacro(text):
        return False
    start, end, _ = rng.choice(plain)
    texts[file] = '%s<xacro:if value="1">%s</xacro:if>%s' % (text[:start], text[start:end], text[end:])
    return True


def moved(rng, texts):
    file = rng.choice(sorted(texts))
    text = texts[file]
    parts = [part for part in children(text) if part[2] in ('link', 'joint', 'material', 'xacro:macro')]
    if not parts or not is_xacro(text):
        return False
    start, end, _ = rng.choice(parts)
    beside = str(pathlib.PurePosixPath(file).with_name('moved_part.xacro'))
    texts[beside] = '<?xml version="1.0"?>\n<robot xmlns:xacro="http://www.ros.org/wiki/xacro">\n%s\n</robot>\n' % text[start:end]
    texts[file] = '%s<xacro:include filename="moved_part.xacro"/>%s' % (text[:start], text[end:])
    return True


def renamed(rng, texts):
    names = re.findall(r'<(?:link|joint|xacro:macro|xacro:property) name="(\w{4,})"', ''.join(texts.values()))
    fixed = {'base_link', 'base_footprint', 'world', 'tool0', 'flange', 'base', 'joint', 'link'}
    common = [name for name in names if name not in fixed and not name.endswith(('_optical_frame', '_wheel'))]
    if not common:
        return False
    old = rng.choice(sorted(set(common)))
    new = old[:2] + 'qz' + old[2:]
    # names of elements, attributes and files stay, and those that are put together
    stays = re.compile(r'</?%s\b|\s%s=|\b%s\.\w|filename="[^"]*\$' % (old, old, old))
    if any(stays.search(text) for text in texts.values()) or old in str(sorted(texts)) or re.search('left|right|front|rear', old):
        return False
    for file, text in texts.items():
        texts[file] = re.sub(r'\b%s\b' % old, new, text)
    return old, new


def reordered(rng, texts):
    file = rng.choice(sorted(texts))
    text = texts[file]
    parts = [part for part in children(text) if part[2] in ('link', 'joint')]
    pairs = [(a, b) for a, b in zip(parts, parts[1:]) if not text[a[1]:b[0]].strip() and '${' not in text[a[0]:b[1]]]
    if not pairs:
        return False
    a, b = rng.choice(pairs)
    texts[file] = text[:a[0]] + text[b[0]:b[1]] + text[a[1]:b[0]] + text[a[0]:a[1]] + text[b[1]:]
    return True


CHANGES = [commented, spaced, wrapped, moved, renamed, reordered]


def write(folder, texts):
    for file, text in texts.items():
        pathlib.Path(folder, file).write_bytes(text.encode())


def with_name(found, names):
    """Findings with a name as it was before it was changed."""
    old, new = names
    return collections.Counter({(rule, severity, message.replace(new, old)): count for (rule, severity, message), count in found.items()})


def try_robot(command, sources, place, seed):
    """What differs between a robot and the same robot in other words."""
    rng = random.Random(seed)
    before, after = pathlib.Path(place, 'before'), pathlib.Path(place, 'after')
    source = rng.choice(sources)
    shutil.copytree(source, before)
    files = sorted(p.relative_to(before).as_posix() for p in before.rglob('*') if p.suffix in ('.xacro', '.urdf'))
    texts = {file: pathlib.Path(before, file).read_bytes().decode('utf-8') for file in files}
    planted = rng.choice([None, *defects.plan(source.name, texts, 2)])
    if planted:
        text = texts[planted.file]
        texts[planted.file] = text[:planted.start] + planted.text + text[planted.end:]
        write(before, texts)
    change = rng.choice(CHANGES)
    made = change(rng, texts)
    if not made:
        return [], None
    shutil.copytree(before, after)
    if change is renamed:
        for path in after.rglob('*.y*ml'):
            path.write_text(re.sub(r'\b%s\b' % made[0], made[1], path.read_text()))
    write(after, texts)
    old, new = findings(command, before), findings(command, after)
    if change is renamed:
        new = with_name(new, made)
    gone, come = old - new, new - old
    kind = planted.kind if planted else 'clean'
    lead = 'seed %s, %s, %s, %s:' % (seed, source.name, kind, change.__name__)
    return ['%s gone %s' % (lead, f) for f in gone] + ['%s new %s' % (lead, f) for f in come], change.__name__


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n\n')[0])
    parser.add_argument('--bin', required=True)
    parser.add_argument('--count', type=int, default=300)
    parser.add_argument('--seed', default='1')
    parser.add_argument('--keep', help='folder for the robots')
    options = parser.parse_args()
    command = str(pathlib.Path(options.bin).resolve())
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(options.keep or folder).resolve()
        sources = [folder / 'sources' / name for name in robots.write(folder / 'sources')]
        seeds = ['%s.%d' % (options.seed, number) for number in range(options.count)]
        with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
            outcomes = list(pool.map(lambda seed: try_robot(command, sources, folder / seed, seed), seeds))
    wrong = [text for texts, _ in outcomes for text in texts]
    made = collections.Counter(change for _, change in outcomes if change)
    print('\n'.join(wrong[:60]))
    print('%d robots rewritten (%s), %d differences' % (sum(made.values()), ', '.join('%s %d' % pair for pair in sorted(made.items())), len(wrong)))
    if sum(made.values()) * 2 < options.count:
        wrong.append('too few robots could be rewritten for the test to mean anything')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
