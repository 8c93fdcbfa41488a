"""A program in a terminal of its own (tmux): keystrokes in, screen out."""

import os
import subprocess
import time

PATIENCE = 30.0


class Terminal:
    """Runs a command in a tmux server of its own, which ends with it."""

    def __init__(self, name: str, command: list[str], env: dict[str, str], cwd: str, size=(120, 34)):
        self.socket = f"xacro-{name}-{os.getpid()}"
        # tmux takes PATH from who starts it, whatever it is told
        self.env = os.environ | env
        settings = [part for key, value in env.items() for part in ("-e", f"{key}={value}")]
        width, height = size
        new = ["new-session", "-d", "-x", str(width), "-y", str(height), "-c", cwd, *settings]
        self.tmux("-f", "/dev/null", *new, *command)
        self.tmux("set-option", "-g", "escape-time", "0")

    def tmux(self, *words: str) -> str:
        run = subprocess.run(["tmux", "-L", self.socket, *words], capture_output=True, text=True, env=self.env)
        if run.returncode:
            raise RuntimeError(f"tmux {words[0]}: {run.stderr.strip()}")
        return run.stdout

    def screen(self, colors: bool = False) -> str:
        return self.tmux("capture-pane", "-p", *(["-e"] if colors else []))

    def keys(self, *keys: str) -> None:
        """Keys by the names of tmux: Enter, Escape, C-x."""
        self.tmux("send-keys", *keys)

    def text(self, text: str) -> None:
        self.tmux("send-keys", "-l", text)

    def type(self, text: str) -> None:
        """Text letter by letter, each when the one before is on the screen.

        Helix 25.01 mixes up the order of changes that come within a millisecond.
        """
        for letter in text:
            before = self.screen()
            self.text(letter)
            self.wait(f"the letter `{letter}`", lambda screen, before=before: screen != before)

    def wait(self, what: str, test) -> str:
        """The screen once it passes a test (a text it holds, or a function)."""
        end = time.monotonic() + PATIENCE
        passes = test if callable(test) else lambda screen: test in screen
        while True:
            screen = self.screen()
            if passes(screen):
                return screen
            if time.monotonic() > end:
                raise AssertionError(f"waited in vain for {what}:\n{screen}")
            time.sleep(0.03)

    def end(self) -> None:
        subprocess.run(["tmux", "-L", self.socket, "kill-server"], capture_output=True)
