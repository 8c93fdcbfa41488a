#!/usr/bin/env python3
"""Drive the language server for a long time: edits, saves, renames, branch switches, a client that stalls.

    tests/soak/run.py --server target/release/xacro-lsp [--minutes 60] [--seed 1] [--files 100]

The workspace is made again: robots with shared parts and YAML files, in a git repository with two branches. All files
are open. Every minute memory and threads are measured, and at rest the diagnostics of all files are compared with
those of a new server. Fails when the server ends, when diagnostics differ, when threads become more, or when memory
grows by more than a quarter in the last two thirds of the time. Linux, git and Python 3 only.
"""
import argparse
import os
import random
import subprocess
import sys
import tempfile
import time

from client import Client, Gone, uri

HEAD = '<robot name="r%d" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
PIECES = ['<link name="extra"/>\n', '<link name="', '${', '}', '"', '<!-- words -->', '\n', 'x', '0', '<', '</robot>',
          '<xacro:part1 name="q" mass="2"/>\n', '🤖', 'é', ' ']


def part(number, branch):
    return (HEAD % number + f'  <xacro:property name="radius{number}" value="{0.1 + branch / 10}"/>\n'
            f'  <xacro:macro name="part{number}" params="name mass:=1">\n    <link name="${{name}}"><inertial>'
            f'<mass value="${{mass * radius{number}}}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>\n'
            + ('    <link name="${name}_more"/>\n' if branch else '') + '  </xacro:macro>\n</robot>\n')


def robot(number, parts, branch):
    text = HEAD % number + '  <link name="base"/>\n'
    for other in parts:
        text += f'  <xacro:include filename="part{other}.xacro"/>\n'
    text += f'  <xacro:property name="cfg" value="${{xacro.load_yaml(\'limits{number % 4}.yaml\')}}"/>\n'
    for count in range(10):
        other = parts[count % len(parts)]
        text += (f'  <xacro:part{other} name="l{count}" mass="${{cfg[\'mass\'] + {count + branch}}}"/>\n'
                 f'  <joint name="j{count}" type="fixed"><parent link="base"/><child link="l{count}"/></joint>\n')
    return text + '</robot>\n'


class Soak:
    def __init__(self, options):
        self.options, self.dice = options, random.Random(options.seed)
        self.folder = tempfile.mkdtemp(prefix='soak-')
        self.branch, self.turn, self.done = 0, 0, {}
        self.make()
        self.texts = {path: open(path, encoding='utf-8').read() for path in self.files()}
        self.versions = dict.fromkeys(self.texts, 1)
        self.client = Client(options.server, self.folder)
        for path, text in self.texts.items():
            self.client.open(path, text)
        self.samples, self.compared, self.edited = [], 0, dict.fromkeys(self.texts, True)

    def git(self, *words):
        subprocess.run(['git', '-C', self.folder, '-c', 'user.name=soak', '-c', 'user.email=soak@localhost', *words], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def make(self):
        count = self.options.files
        self.git('init', '-q', '-b', 'zero')
        for branch in (0, 1):
            if branch:
                self.git('checkout', '-q', '-b', 'one')
            for number in range(count // 2):
                self.write(f'part{number}.xacro', part(number, branch))
            for number in range(count - count // 2):
                parts = [(number + step) % (count // 2) for step in (0, 1, 7)]
                self.write(f'robot{number}.urdf.xacro', robot(number, parts, branch))
            for number in range(4):
                self.write(f'limits{number}.yaml', f'mass: {number + branch}\n')
            self.git('add', '-A')
            self.git('commit', '-q', '-m', f'state {branch}')
        self.git('checkout', '-q', 'zero')

    def write(self, name, text):
        with open(os.path.join(self.folder, name), 'w', encoding='utf-8') as out:
            out.write(text)

    def files(self):
        names = sorted(name for name in os.listdir(self.folder) if name.endswith('.xacro'))
        return [os.path.join(self.folder, name) for name in names]

    def told(self, paths, kind=2):
        self.client.notify('workspace/didChangeWatchedFiles', {'changes': [{'uri': uri(p), 'type': kind} for p in paths]})

    def position(self, text, offset):
        before = text[:offset]
        line = before.rsplit('\n', 1)[-1]
        return {'line': before.count('\n'), 'character': len(line.encode('utf-16-le')) // 2}

    def open(self, path, text):
        self.touched(path)
        self.texts[path] = text
        self.client.open(path, text)

    def touched(self, path):
        """A part is shown under the robot that was opened or edited last."""
        self.edited.pop(path, None)
        self.edited[path] = True

    def set(self, path, changes, text):
        self.versions[path] += 1
        self.texts[path] = text
        self.touched(path)
        self.client.change(path, changes, self.versions[path])

    def edit(self):
        path = self.dice.choice(list(self.texts))
        for _ in range(self.dice.randrange(1, 8)):
            text = self.texts[path]
            start = self.dice.randrange(len(text) + 1)
            end = min(len(text), start + self.dice.choice([0, 0, 0, 1, 3, 20]))
            new = self.dice.choice(PIECES)
            place = {'start': self.position(text, start), 'end': self.position(text, end)}
            self.set(path, [{'range': place, 'text': new}], text[:start] + new + text[end:])

    def undo(self):
        """Take broken texts back, so that the workspace does not rot."""
        for path in self.dice.sample(list(self.texts), min(10, len(self.texts))):
            self.reload(path)

    def reload(self, path):
        with open(path, encoding='utf-8') as source:
            text = source.read()
        if text != self.texts[path]:
            self.set(path, [{'text': text}], text)

    def save(self):
        path = self.dice.choice(list(self.texts))
        with open(path, 'w', encoding='utf-8') as out:
            out.write(self.texts[path])
        self.client.notify('textDocument/didSave', {'textDocument': {'uri': uri(path)}})
        self.told([path])

    def rename(self):
        path = self.dice.choice(list(self.texts))
        name = os.path.basename(path)
        new = os.path.join(self.folder, name[4:] if name.startswith('new_') else 'new_' + name)
        os.rename(path, new)
        text = self.texts.pop(path)
        self.versions.pop(path)
        self.client.notify('textDocument/didClose', {'textDocument': {'uri': uri(path)}})
        self.client.notify('workspace/didRenameFiles', {'files': [{'oldUri': uri(path), 'newUri': uri(new)}]})
        self.told([path], 3)
        self.told([new], 1)
        self.versions[new] = 1
        self.open(new, text)

    def switch(self):
        before = set(self.files())
        self.branch = 1 - self.branch
        self.git('checkout', '-q', '-f', ['zero', 'one'][self.branch])
        self.git('clean', '-q', '-f')
        after = set(self.files())
        for path in before - after:
            self.texts.pop(path)
            self.versions.pop(path)
            self.client.notify('textDocument/didClose', {'textDocument': {'uri': uri(path)}})
        for path in after - before:
            with open(path, encoding='utf-8') as source:
                text = source.read()
            self.versions[path] = 1
            self.open(path, text)
        yaml = [os.path.join(self.folder, f'limits{n}.yaml') for n in range(4)]
        self.told(sorted(before | after) + yaml)
        for path in after & before:
            self.reload(path)

    def ask(self):
        path = self.dice.choice(list(self.texts))
        text = self.texts[path]
        place = self.position(text, self.dice.randrange(len(text) + 1))
        document = {'textDocument': {'uri': uri(path)}}
        method = self.dice.choice(['hover', 'completion', 'definition', 'references', 'documentSymbol', 'foldingRange',
                                   'semanticTokens/full', 'codeLens', 'documentLink', 'documentHighlight'])
        number = self.client.post('textDocument/' + method, dict(document, position=place, context={'includeDeclaration': True}))
        if self.dice.random() < 0.3:
            self.client.notify('$/cancelRequest', {'id': number})
        self.client.reply(number)

    def stall(self):
        """A client that does not read for a while, but goes on typing."""
        self.client.listens.clear()
        for _ in range(40):
            self.edit()
        time.sleep(self.dice.random() * 3)
        self.client.listens.set()

    def compare(self):
        """What the session says at rest is what a new server says."""
        fresh = Client(self.options.server, self.folder)
        for path, text in self.texts.items():
            fresh.open(path, text)
        for path in self.edited:
            if path in self.texts:
                fresh.change(path, [{'text': self.texts[path]}], 2)
        for path in self.texts:
            ours, theirs = self.client.diagnostics(path), fresh.diagnostics(path)
            if ours != theirs:
                only = [line for line in ours if line not in theirs][:3], [line for line in theirs if line not in ours][:3]
                raise AssertionError(f'{path}: only in the session {only[0]}, only in a new server {only[1]}')
            self.compared += 1
        fresh.stop()

    def run(self):
        begin = time.monotonic()
        end, next_sample = begin + self.options.minutes * 60, begin + 20
        actions = [(self.edit, 60), (self.ask, 25), (self.save, 8), (self.undo, 4), (self.rename, 2), (self.switch, 1), (self.stall, 1)]
        names, weights = [action for action, _ in actions], [weight for _, weight in actions]
        while time.monotonic() < end:
            action = self.dice.choices(names, weights)[0]
            action()
            self.done[action.__name__] = self.done.get(action.__name__, 0) + 1
            time.sleep(self.options.pause)
            if time.monotonic() > next_sample:
                self.client.request('textDocument/foldingRange', {'textDocument': {'uri': uri(next(iter(self.texts)))}})
                self.compare()
                memory, threads = self.client.memory()
                self.samples.append(((time.monotonic() - begin) / 60, memory / 1e6, threads))
                print('%.1f min: %.1f MB, %d threads, %s' % (*self.samples[-1], self.done), flush=True)
                next_sample = time.monotonic() + 60

    def verdict(self):
        samples = self.samples[len(self.samples) // 3:]
        wrong = list(self.client.faults)
        if len(samples) > 3:
            middle = sum(m for _, m, _ in samples) / len(samples)
            when = sum(t for t, _, _ in samples) / len(samples)
            slope = (sum((t - when) * (m - middle) for t, m, _ in samples)
                     / sum((t - when) ** 2 for t, _, _ in samples))
            print('memory: %.1f MB on average, slope %+.3f MB a minute; threads %d to %d' % (
                middle, slope, min(s[2] for s in samples), max(s[2] for s in samples)))
            grown = slope * (samples[-1][0] - samples[0][0])
            if grown > middle / 4:
                wrong.append('memory grows by %.1f MB' % grown)
            if samples[-1][2] > samples[0][2] + 2:
                wrong.append('threads grow')
        code = self.client.stop()
        if code != 0:
            wrong.append('exit code %s' % code)
        print('%d actions %s; %d files compared with a new server' % (sum(self.done.values()), self.done, self.compared))
        return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--server', required=True)
    parser.add_argument('--minutes', type=float, default=60)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--files', type=int, default=100)
    parser.add_argument('--pause', type=float, default=0.02, help='seconds between actions')
    options = parser.parse_args()
    options.server = os.path.abspath(options.server)
    soak = Soak(options)
    try:
        soak.run()
        wrong = soak.verdict()
    except (Gone, AssertionError) as error:
        wrong = [f'after {sum(soak.done.values())} actions: {error}']
    for text in wrong:
        print('failed: ' + text)
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
