"""What Windows does to a running program: locks of other programs, consoles, Ctrl-C, the local server of the preview."""
import re
import signal
import subprocess
import sys
import threading
import time
import urllib.request

import build

SECONDS = 60
ROBOT = '<robot name="r">\r\n  <link name="a"/>\r\n  <link name="b"/>\r\n  <joint name="j" type="Fixed">\r\n' \
        '    <parent link="a"/>\r\n    <child link="b"/>\r\n  </joint>\r\n</robot>\r\n'
# opens a file so that nobody else may open it, says so, and waits until its input ends
LOCK = '''#include <windows.h>
#include <stdio.h>
int wmain(int count, wchar_t **words) {
    HANDLE file = CreateFileW(words[1], GENERIC_READ | GENERIC_WRITE, 0, NULL, OPEN_EXISTING, 0, NULL);
    puts(file == INVALID_HANDLE_VALUE ? "failed" : "locked");
    fflush(stdout);
    getchar();
    return count == 2 ? 0 : 1;
}
'''


def locker(suite, path):
    """Another program that holds a file for itself."""
    if suite.is_native:
        script = ('import ctypes, sys\nopen_ = ctypes.windll.kernel32.CreateFileW\nopen_.restype = ctypes.c_void_p\n'
                  'held = open_(sys.argv[1], 0xC0000000, 0, None, 3, 0, None)\n'
                  'print("failed" if held in (None, 2 ** 64 - 1) else "locked", flush=True)\nsys.stdin.read(1)\n')
        command = [sys.executable, '-c', script, str(path)]
    else:
        source, program = suite.folder / 'lock.c', suite.folder / 'lock.exe'
        source.write_text(LOCK)
        build.run('x86_64-w64-mingw32-gcc', '-municode', '-o', program, source)
        command = [build.WINE, str(program), suite.local(path)]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=suite.environment)


def locks(suite):
    """A file that another program holds: an error with its name, and it is as it was."""
    path = suite.folder / 'held.urdf'
    path.write_bytes(ROBOT.encode())
    other = locker(suite, path)
    held = other.stdout.readline().strip()
    suite.check('a file held by another program', held == b'locked', held)
    for command in (['check', 'held.urdf'], ['fix', 'held.urdf', '--unsafe-fixes'], ['expand', 'held.urdf'], ['format', 'held.urdf']):
        done = suite.run(*command)
        is_said = done.returncode not in (0, 101) and 'held.urdf' in done.stderr + done.stdout and 'panicked' not in done.stderr
        suite.check(f'{command[0]} of a held file', is_said, (done.returncode, done.stdout, done.stderr))
    other.communicate(b'\n')
    suite.check('a held file is as it was', path.read_bytes() == ROBOT.encode())


def code_pages(suite):
    """The same bytes whatever the code page of the console is."""
    (suite.folder / 'größe.urdf').write_text('<robot name="r"><link name="ärm"/><joint name="j"/></robot>\n', encoding='utf-8')
    expected = suite.run('check', 'größe.urdf').stdout
    for page in (437, 850, 65001):
        if suite.is_native:
            command = ['cmd', '/c', f'chcp {page} >nul & "{suite.command[0]}" check größe.urdf']
        else:
            command = [build.WINE, 'cmd', '/c', f'chcp {page} >nul & {suite.program} check größe.urdf']
        done = subprocess.run(command, cwd=suite.folder, capture_output=True, timeout=SECONDS, env=suite.environment, stdin=subprocess.DEVNULL)
        shown = done.stdout.decode('utf-8', 'replace').replace('\r\n', '\n')
        suite.check(f'output with code page {page}', 'größe.urdf' in shown and shown.endswith(expected[-200:]), shown + done.stderr.decode('utf-8', 'replace'))


def interrupt(suite):
    """Ctrl-C ends `check --watch` at once."""
    flags = {'creationflags': subprocess.CREATE_NEW_PROCESS_GROUP} if suite.is_native else {}
    command = suite.command if suite.is_native else [build.WINE, str(suite.program)]
    (suite.folder / 'watched.urdf').write_bytes(ROBOT.encode())
    running = subprocess.Popen([*command, 'check', '--watch', 'watched.urdf'], cwd=suite.folder, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, env=suite.environment, **flags)
    running.stdout.readline()
    running.send_signal(signal.CTRL_BREAK_EVENT if suite.is_native else signal.SIGINT)
    began = time.monotonic()
    try:
        running.communicate(timeout=SECONDS)
    except subprocess.TimeoutExpired:
        running.kill()
    suite.check('Ctrl-C while watching', time.monotonic() - began < SECONDS / 2)


class Watched:
    """A running program and what it has written so far."""

    def __init__(self, suite, *arguments):
        self.process = subprocess.Popen([*suite.command, *arguments], cwd=suite.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                        stderr=subprocess.STDOUT, env=suite.environment)
        self.shown = b''
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            self.shown += line

    def until(self, pattern):
        """The first match in the output, waited for."""
        end = time.monotonic() + SECONDS
        while not (found := re.search(pattern, self.shown)) and time.monotonic() < end:
            time.sleep(0.1)
        return found


def watching(suite):
    """`check --watch` sees an edit."""
    path = suite.folder / 'edited.urdf'
    path.write_bytes(ROBOT.encode())
    running = Watched(suite, 'check', '--watch', '--format', 'concise', 'edited.urdf')
    running.until(rb'edited\.urdf:')
    path.write_bytes(ROBOT.replace('link="b"', 'link="bb"').encode())
    suite.check('an edit while watching', running.until(rb'`bb`'), running.shown)
    running.process.kill()


def preview(suite):
    """The page of the preview, from this machine only, with its token."""
    (suite.folder / 'shown.urdf').write_bytes(ROBOT.encode())
    running = Watched(suite, 'preview', 'shown.urdf')
    found = running.until(rb'http://127\.0\.0\.1:\d+\S*')
    status = body = None
    if found:
        with urllib.request.urlopen(found[0].decode(), timeout=SECONDS) as page:
            status, body = page.status, page.read()
    running.process.kill()
    suite.check('the page of the preview', status == 200 and b'<html' in (body or b'').lower(), (running.shown, status))
