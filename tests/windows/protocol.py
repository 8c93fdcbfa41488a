"""A small client of the language server, for the spellings of URIs that editors on Windows use."""
import json
import subprocess


class Client:
    """A server and what it published."""

    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.number, self.published = 0, {}

    def send(self, method, params, is_request=False):
        message = {'jsonrpc': '2.0', 'method': method, 'params': params}
        if is_request:
            self.number += 1
            message['id'] = self.number
        data = json.dumps(message).encode()
        self.process.stdin.write(b'Content-Length: %d\r\n\r\n' % len(data) + data)
        self.process.stdin.flush()

    def read(self):
        length = 0
        while line := self.process.stdout.readline().strip():
            name, _, value = line.partition(b':')
            if name.lower() == b'content-length':
                length = int(value)
        message = json.loads(self.process.stdout.read(length))
        if message.get('method') == 'textDocument/publishDiagnostics':
            self.published[message['params']['uri']] = message['params']['diagnostics']
        elif 'method' in message and 'id' in message:
            answer = json.dumps({'jsonrpc': '2.0', 'id': message['id'], 'result': None}).encode()
            self.process.stdin.write(b'Content-Length: %d\r\n\r\n' % len(answer) + answer)
            self.process.stdin.flush()
        return message

    def request(self, method, params):
        self.send(method, params, is_request=True)
        while True:
            message = self.read()
            if message.get('id') == self.number and 'method' not in message:
                return message.get('result')

    def stop(self):
        self.request('shutdown', None)
        self.send('exit', None)
        self.process.stdin.close()
        return self.process.wait(20)


def session(command, root, uri, text):
    """What the server says of an open file: findings, hover, definition of the macro call in line 4, and the exit code."""
    client = Client(command)
    client.request('initialize', {'processId': None, 'rootUri': root, 'capabilities': {}})
    client.send('initialized', {})
    client.send('textDocument/didOpen',
                {'textDocument': {'uri': uri, 'languageId': 'xacro', 'version': 1, 'text': text}})
    at = {'textDocument': {'uri': uri}, 'position': {'line': 3, 'character': 12}}
    definition = client.request('textDocument/definition', at)
    hover = client.request('textDocument/hover', at)
    while uri not in client.published:
        client.read()
    return client.published[uri], hover, definition, client.stop()
