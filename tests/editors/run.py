"""Editors other than Neovim and VS Code, started for real: findings and completion.

    run.py --server PATH --tools FOLDER [NAME...]

Each uses the configuration that docs/editors.md shows. FOLDER holds what install.sh has unpacked.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from snippet import snippet
from terminal import Terminal

HERE = pathlib.Path(__file__).parent
ROBOT = "src/pan_tilt/urdf/pan_tilt.urdf.xacro"


class Place:
    """A home folder and a workspace for one editor."""

    def __init__(self, options: argparse.Namespace):
        self.tools = options.tools.resolve()
        self.base = pathlib.Path(tempfile.mkdtemp(prefix="xacro-editors-"))
        bin_folder = self.base / "bin"
        bin_folder.mkdir()
        (bin_folder / "xacro-lsp").symlink_to(options.server.resolve())
        self.workspace = self.base / "ws"
        neovim = self.tools / "nvim-trixie" / "nvim"
        subprocess.run([neovim, "--clean", "-l", HERE / "workspace.lua", self.workspace], check=True)
        self.robot = self.workspace / ROBOT
        self.env = {
            "HOME": str(self.base),
            "XDG_CONFIG_HOME": str(self.base / ".config"),
            "PATH": f"{bin_folder}:{os.environ['PATH']}",
            "AMENT_PREFIX_PATH": "",
            "TERM": "screen-256color",
            "LANG": "C.UTF-8",
        }

    def write(self, name: str, text: str) -> pathlib.Path:
        path = self.base / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path


def emacs(place: Place, client: str) -> None:
    config = place.write("config.el", snippet(client))
    env = os.environ | place.env | {
        "CONFIG": str(config),
        "ROBOT": str(place.robot),
        "PACKAGES": str(place.tools / "lsp-mode"),
    }
    command = ["emacs", "--batch", "-Q", "-l", str(HERE / f"emacs-{client}.el")]
    run = subprocess.run(command, env=env, capture_output=True, text=True, timeout=120)
    if run.returncode:
        raise AssertionError(run.stdout + run.stderr)


def eglot(place: Place) -> None:
    emacs(place, "eglot")


def lsp_mode(place: Place) -> None:
    emacs(place, "lsp-mode")


def helix(place: Place) -> None:
    place.write(".config/helix/languages.toml", snippet("helix"))
    place.write(".config/helix/runtime/queries/xacro/highlights.scm", snippet("helix-highlights"))
    place.robot.write_text(place.robot.read_text().replace("${m0 / 3}", "${m_0 / 3}"))
    hx = place.tools / "helix" / "hx"
    terminal = Terminal("helix", [str(hx), str(place.robot)], place.env, str(place.workspace))
    try:
        terminal.wait("a finding in the status line", "● 1")
        terminal.type("]d")
        terminal.wait("the finding", lambda screen: "`m_0` is not defined" in " ".join(screen.split()))
        terminal.type("cm0")
        terminal.keys("Escape")
        terminal.wait("no finding", lambda screen: "●" not in screen)
        terminal.wait("the end of the progress", lambda screen: not any("⠀" <= c <= "⣿" for c in screen))
        terminal.text("/link name")
        terminal.keys("Enter")
        terminal.wait("the line", " 6:")
        terminal.type("o<xacro:un")
        terminal.wait("a completion", lambda screen: "unit" in screen.split("<xacro:un", 1)[1].split("\n")[1])
        terminal.keys("Tab")
        terminal.keys("Enter")
        terminal.wait("the completed call", '<xacro:unit name="" parent=""')
    finally:
        terminal.end()


def vim(place: Place) -> None:
    ale = place.tools / "ale" / "usr" / "share" / "vim-ale"
    vimrc = place.write("vimrc", f"set nocompatible noswapfile rtp^={ale}\nfiletype on\n" + snippet("vim-ale"))
    terminal = Terminal("vim", ["vim", "-u", str(vimrc), str(place.robot)], place.env, str(place.workspace))
    try:
        terminal.wait("the file", "xacro:unit")
        terminal.text("/m0 \\/ 3")
        terminal.keys("Enter")
        terminal.text("cwm_0")
        terminal.keys("Escape")
        terminal.wait("a finding", lambda screen: "`m_0` is not defined" in screen)
        terminal.text("u")
        terminal.wait("no finding", lambda screen: "is not defined" not in screen)
        terminal.text("/link name")
        terminal.keys("Enter")
        terminal.text("o<xacro:un")
        terminal.keys("C-x", "C-o")
        terminal.wait("a completion", lambda screen: "unit" in screen.split("<xacro:un", 1)[1][:400])
    finally:
        terminal.end()


TESTS = {"eglot": eglot, "lsp-mode": lsp_mode, "helix": helix, "vim": vim}


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", type=pathlib.Path, required=True)
    parser.add_argument("--tools", type=pathlib.Path, required=True)
    parser.add_argument("names", nargs="*", choices=[[], *TESTS])
    options = parser.parse_args()
    failed = 0
    for name in options.names or TESTS:
        begin = time.monotonic()
        place = Place(options)
        try:
            TESTS[name](place)
            print(f"ok   {name} ({time.monotonic() - begin:.1f} s)")
        except Exception as problem:
            failed += 1
            print(f"FAIL {name}: {problem}")
        finally:
            shutil.rmtree(place.base, ignore_errors=True)
    print(f"{len(options.names or TESTS) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
