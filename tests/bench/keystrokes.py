#!/usr/bin/env python3
"""How long a language server takes from a letter to the findings for it, in long files.

    tests/bench/keystrokes.py --server target/release/xacro-lsp [--rounds 20] [--lines 200,2000,20000] [--pairs 50,500]

A letter is typed into an expression of a macro that everything calls, and deleted again, without any pause before the
findings. The same in an SRDF of as many pairs of links, in the name of a link, and in the robot it is for. Also measured: completion and hover at that place, processor time of an edit, memory with the file open.
Linux only.
"""
import argparse
import os
import pathlib
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(1, str(HERE.parent / 'soak'))
from client import Client, uri  # noqa: E402
from robots import long_robot, long_srdf  # noqa: E402

PUSHED = {'textDocument': {'publishDiagnostics': {'versionSupport': True}}}
PLACE = "ixx=\"${sizes[size"
IN_SRDF = 'tip_link="l1'
IN_ROBOT = 'child link="l1'


class Typist(Client):
    """A client that notes when findings for a version arrive, and does without a pause."""

    def __init__(self, server, folder):
        self.shown = {}
        super().__init__(server, folder, PUSHED)
        self.notify('workspace/didChangeConfiguration', {'settings': {'xacro': {'diagnostics': {'delay': 0}}}})

    def take(self, message):
        if message.get('method') == 'textDocument/publishDiagnostics':
            found = {finding.get('code') for finding in message['params']['diagnostics']}
            with self.arrived:
                self.shown[message['params'].get('version')] = time.perf_counter(), found
                self.arrived.notify_all()
        super().take(message)

    def when_shown(self, version, code=None, typed=True):
        """When the findings for a version came; with a code, those that have it, or have it no longer."""
        def is_there():
            known = self.shown.get(version)
            return known and (code is None or (code in known[1]) == typed)
        with self.arrived:
            if not self.arrived.wait_for(lambda: is_there() or self.ended, 30):
                sys.exit(f'no findings for version {version}: {self.shown.get(version)}')
            return self.shown[version][0]


def processor(pid):
    fields = pathlib.Path(f'/proc/{pid}/stat').read_text().rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


def memory(pid):
    status = pathlib.Path(f'/proc/{pid}/status').read_text()
    return int(status.split('VmRSS:')[1].split()[0]) / 1024


def quantiles(times):
    times = sorted(times)
    return f'p50 {times[len(times) // 2] * 1e3:7.2f}  p99 {times[-1 - len(times) // 100] * 1e3:7.2f} ms'


def in_robot(folder, lines):
    return long_robot(folder, (lines - 19) // 3), PLACE, None


def in_srdf(folder, pairs):
    return long_srdf(folder, pairs)[0], IN_SRDF, 'srdf-unknown-link'


def beside_srdf(folder, pairs):
    return long_srdf(folder, pairs)[1], IN_ROBOT, None


def measure(server, what, make, size, rounds):
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, '.git').mkdir()
        path, behind_what, code = make(pathlib.Path(folder), size)
        text = path.read_text()
        client = Typist(server, folder)
        pid = client.process.pid
        client.notify('textDocument/didOpen', {'textDocument': {
            'uri': uri(str(path)), 'languageId': 'xacro', 'version': 1, 'text': text}})
        client.when_shown(1)
        time.sleep(1)
        used = memory(pid)
        offset = text.index(behind_what) + len(behind_what)
        place = {'line': text.count('\n', 0, offset), 'character': offset - text.rfind('\n', 0, offset) - 1}
        behind = dict(place, character=place['character'] + 1)
        asked = {'textDocument': {'uri': uri(str(path))}, 'position': place}
        version, edits, asks = 1, [], {'completion': [], 'hover': []}
        busy = processor(pid)
        for number in range(2 * rounds):
            version += 1
            typed = number % 2 == 0
            start = time.perf_counter()
            client.notify('textDocument/didChange', {
                'textDocument': {'uri': uri(str(path)), 'version': version}, 'contentChanges': [{
                    'range': {'start': place, 'end': place if typed else behind}, 'text': 'x' if typed else ''}]})
            edits.append(client.when_shown(version, code, typed) - start)
        busy = (processor(pid) - busy) / (2 * rounds)
        for kind, times in asks.items():
            for _ in range(rounds):
                start = time.perf_counter()
                client.request(f'textDocument/{kind}', asked)
                times.append(time.perf_counter() - start)
        client.process.kill()
        print(f'{size:6} {what}  edit {quantiles(edits)}, {busy * 1e3:.2f} ms of processor time   memory {used:.1f} MiB')
        for kind, times in asks.items():
            print(f'              {kind:10} {quantiles(times)}')


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--server', required=True)
    parser.add_argument('--rounds', type=int, default=50)
    parser.add_argument('--lines', default='200,2000,20000')
    parser.add_argument('--pairs', default='50,500')
    options = parser.parse_args()
    server = os.path.abspath(options.server)
    for lines in filter(None, options.lines.split(',')):
        measure(server, 'lines', in_robot, int(lines), options.rounds)
    for pairs in filter(None, options.pairs.split(',')):
        measure(server, 'pairs, in the SRDF', in_srdf, int(pairs), options.rounds)
        measure(server, 'pairs, in the robot', beside_srdf, int(pairs), options.rounds)


if __name__ == '__main__':
    main()
