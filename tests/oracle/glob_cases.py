#!/usr/bin/env python3
"""glob_cases.py: write glob_cases.json, what `sorted(glob.glob(pattern))` of CPython 3.11 finds.

`files` is the tree (a name that ends in a slash is an empty folder), `cases` holds `[pattern, paths]`.
"""
import glob
import json
import os
import random
import sys
import tempfile

FILES = [
    'a.x', 'b.x', 'B.x', 'ab.x', 'a.y', '.h.x', '.hidden/a.x', 'sub/a.x', 'sub/c.x', 'sub/.s.x', 'sub/deep/a.x',
    'sub/deep/er/a.x', 'tab/a.x', 'tab/b', '[l]/a.x', 'a-b.x', 'é.x', 'ü/a.x', 'x y.x', '!.x', '^.x', ']', '[',
    'empty/', '-.x', '0.x', '9.x', '{a}.x', '~', '#a.x', 'a*.x', 'a?.x', 'Z/', 'sub/deep/[.x', 'z.x.x', '日本.x',
]

PATTERNS = [
    '', '*', '?', '.', '..', './', './*', '../*', '.*', '**', '**/*', '**/**', '*/', '*/*', '*//', '*/./a.x', 'sub//*', 'sub/../*.x',
    '*.x', '?.x', '??.x', '[ab].x', '[!ab].x', '[a-c].x', '[c-a].x', '[!c-a].x', '[]].x', ']', '[]]', '[[]', '[!]]', '[!a-]*', '[-a]*',
    '[a-]*', '[--0].x', '[^a].x', '[!^a].x', '[!!].x', '[a', '[', '[]', '[!]', '[!', 'a[', '*[', '*.[xy]', '*.[!x]', 's*/a.x', 's*/*/a.x', 's*/**/a.x',
    'sub/a.x', 'gone', 'gone/*', 'a.x/*', 'a.x/', 'sub/', 'sub', 'sub/*/', 'sub/.*', '.h*', '.*/*', '*/.*', '[.]h.x', '[l]/*', '[[]l]/*', '[[]*',
    '*é*', '[é-ü]*', '?/*', 'x*y*', 'a[*].x', 'a[?].x', 'a\\*.x', '\\*', '{a}.x', '{a,b}.x', '~', '~*', '#*', '*.x.x', '*.x*', '*x*x*', 'empty/*', 'Z*', '[A-Z]*',
    '[a-z]*.x', '[!.]*', '*/[!a].x', '*/..', '*/../a.x', '*/.', 'sub/deep/[[].x', 'sub/deep/[.x', '***', '*?', '?*', '[a-c-e]*', '[a-]', '[z-a]', '[!z-a]*', '日*',
]


def main():
    random.seed(1)
    patterns = list(PATTERNS)
    pieces = ['*', '?', 'a', 'b', '.x', '/', '[ab]', '[!a]', '[a-z]', 'sub', '.', 'deep', '[', ']', '!', '-', '**', '..', 'x']
    while len(patterns) < 500:
        patterns.append(''.join(random.choice(pieces) for _ in range(random.randrange(1, 7))).lstrip('/'))
    cases = []
    with tempfile.TemporaryDirectory() as outer:
        # Nothing but the tree must be seen through `..`.
        root = os.path.join(outer, 'one', 'two', 'three', 'four', 'five', 'six', 'root')
        for name in FILES:
            path = os.path.join(root, name)
            os.makedirs(path if name.endswith('/') else os.path.dirname(path), exist_ok=True)
            if not name.endswith('/'):
                open(path, 'w').close()
        os.chdir(root)
        cases = [[pattern, sorted(glob.glob(pattern))] for pattern in patterns]
        os.chdir('/')
    target = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'glob_cases.json')
    with open(target, 'w') as out:
        lines = ',\n'.join(json.dumps(case) for case in cases)
        out.write('{"files": %s,\n"cases": [\n%s\n]}\n' % (json.dumps(FILES), lines))
    return 0


if __name__ == '__main__':
    sys.exit(main())
