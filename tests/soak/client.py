"""A small client of a language server that can stop listening for a while."""
import json
import os
import subprocess
import threading
import time

CAPABILITIES = {
    'general': {'positionEncodings': ['utf-16']},
    'workspace': {'configuration': True, 'didChangeWatchedFiles': {'dynamicRegistration': True},
                  'workspaceEdit': {'documentChanges': True}, 'fileOperations': {'didRename': True},
                  'diagnostics': {'refreshSupport': True}},
    'window': {'workDoneProgress': True},
    'textDocument': {'diagnostic': {'relatedDocumentSupport': False}, 'publishDiagnostics': {'versionSupport': True},
                     'documentSymbol': {'hierarchicalDocumentSymbolSupport': True}},
}


class Gone(Exception):
    """The server ended."""


class Client:
    def __init__(self, server, folder, capabilities=None):
        self.process = subprocess.Popen([server], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, bufsize=0,
                                        env=dict(os.environ, AMENT_PREFIX_PATH=os.path.join(folder, 'none')))
        self.replies, self.next_id, self.faults = {}, 0, []
        self.listens = threading.Event()
        self.listens.set()
        self.arrived = threading.Condition()
        self.ended = False
        self.errors = bytearray()
        threading.Thread(target=self.read, daemon=True).start()
        threading.Thread(target=self.read_errors, daemon=True).start()
        self.request('initialize', {
            'processId': os.getpid(), 'rootUri': None, 'capabilities': capabilities or CAPABILITIES,
            'workspaceFolders': [{'uri': uri(folder), 'name': 'ws'}]})
        self.notify('initialized', {})

    def read_errors(self):
        while True:
            part = self.process.stderr.read(65536)
            if not part:
                return
            self.errors.extend(part[:10000])

    def read(self):
        stream = self.process.stdout
        while True:
            self.listens.wait()
            length = None
            while True:
                line = bytearray()
                while not line.endswith(b'\n'):
                    byte = stream.read(1)
                    if not byte:
                        with self.arrived:
                            self.ended = True
                            self.arrived.notify_all()
                        return
                    line.extend(byte)
                if line == b'\r\n':
                    break
                if line.lower().startswith(b'content-length:'):
                    length = int(line.split(b':')[1])
            body = b''
            while len(body) < length:
                body += stream.read(length - len(body))
            self.take(json.loads(body))

    def take(self, message):
        if 'method' in message and 'id' in message:
            result = [None] * len(message['params']['items']) if message['method'] == 'workspace/configuration' else None
            threading.Thread(target=self.send, daemon=True,
                             args=({'jsonrpc': '2.0', 'id': message['id'], 'result': result},)).start()
        elif 'method' in message:
            text = json.dumps(message)
            if 'internal error' in text:
                self.faults.append(text[:500])
        else:
            with self.arrived:
                self.replies[message['id']] = message
                self.arrived.notify_all()

    def send(self, message):
        body = json.dumps(message).encode()
        data = memoryview(b'Content-Length: %d\r\n\r\n' % len(body) + body)
        try:
            while data:
                data = data[self.process.stdin.write(data):]
        except OSError:
            raise Gone(bytes(self.errors[-2000:]).decode('utf-8', 'replace'))

    def notify(self, method, params):
        self.send({'jsonrpc': '2.0', 'method': method, 'params': params})

    def post(self, method, params):
        self.next_id += 1
        self.send({'jsonrpc': '2.0', 'id': self.next_id, 'method': method, 'params': params})
        return self.next_id

    def reply(self, number, patience=120):
        end = time.monotonic() + patience
        with self.arrived:
            while number not in self.replies:
                if self.ended or time.monotonic() > end:
                    raise Gone('no reply in %d s: %s' % (patience, bytes(self.errors[-2000:]).decode('utf-8', 'replace')))
                self.arrived.wait(1)
            return self.replies.pop(number)

    def request(self, method, params):
        return self.reply(self.post(method, params)).get('result')

    def open(self, path, text):
        self.notify('textDocument/didOpen', {'textDocument': {'uri': uri(path), 'languageId': 'xacro', 'version': 1, 'text': text}})

    def change(self, path, changes, version):
        self.notify('textDocument/didChange', {'textDocument': {'uri': uri(path), 'version': version}, 'contentChanges': changes})

    def diagnostics(self, path):
        """What a pull says, in a form that two servers can be compared by."""
        while True:
            reply = self.reply(self.post('textDocument/diagnostic', {'textDocument': {'uri': uri(path)}}))
            if 'result' in reply:
                items = reply['result'].get('items', [])
                return sorted(json.dumps([i['range'], i.get('code'), i['message']], sort_keys=True) for i in items)
            # cancelled by the server: ask again
            time.sleep(0.05)

    def memory(self):
        """Resident bytes and threads."""
        found = {}
        with open('/proc/%d/status' % self.process.pid) as status:
            for line in status:
                key, _, value = line.partition(':')
                found[key] = value.split()
        return int(found['VmRSS'][0]) * 1024, int(found['Threads'][0])

    def stop(self):
        self.listens.set()
        self.request('shutdown', None)
        self.notify('exit', None)
        return self.process.wait(20)


def uri(path):
    return 'file://' + path
