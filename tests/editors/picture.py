"""Draws docs/images/neovim.svg: a finding, the expanded text and a hover in a real Neovim.

    picture.py --server PATH --neovim PATH
"""

import argparse
import html
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unicodedata

from terminal import Terminal

ROOT = pathlib.Path(__file__).parents[2]
WIDTH, HEIGHT = 144, 34
CELL_X, CELL_Y, SIZE = 8.0, 17.0, 13.3
INK, PAPER = "#e0e2ea", "#14161b"
BASIC = (
    "#000000 #cc4a4a #5fae5f #c7a33c #5a8fd6 #b072c9 #49a8a8 #c0c4cc "
    "#6b7280 #ff7b7b #8fd98f #ffd866 #8ab8ff #d7a1ea #7fdcdc #ffffff"
).split()


def palette(number: int) -> str:
    """A colour of the 256 that terminals number."""
    if number < 16:
        return BASIC[number]
    if number >= 232:
        return "#" + f"{8 + (number - 232) * 10:02x}" * 3
    steps = [0, 95, 135, 175, 215, 255]
    number -= 16
    return "#" + "".join(f"{steps[part]:02x}" for part in (number // 36, number // 6 % 6, number % 6))


class Style:
    """What the escape sequences so far have set."""

    def __init__(self):
        self.reset()

    def reset(self):
        self.ink, self.paper = None, None
        self.bold = self.italic = self.underline = self.reverse = False

    def colors(self) -> tuple[str, str]:
        ink, paper = self.ink or INK, self.paper or PAPER
        return (paper, ink) if self.reverse else (ink, paper)

    def take(self, sequence: str) -> None:
        codes = [re.split(":", part) for part in sequence.split(";")]
        while codes:
            first, *rest = codes.pop(0)
            number = int(first or 0)
            if number in (38, 48, 58):
                if not rest:
                    kind = codes.pop(0)[0]
                    rest = [kind] + [codes.pop(0)[0] for _ in range(3 if kind == "2" else 1)]
                values = [int(value) for value in rest if value]
                color = palette(values[1]) if values[0] == 5 else "#%02x%02x%02x" % tuple(values[-3:])
                if number == 38:
                    self.ink = color
                elif number == 48:
                    self.paper = color
            elif number == 0:
                self.reset()
            elif number in (1, 22):
                self.bold = number == 1
            elif number in (3, 23):
                self.italic = number == 3
            elif number in (4, 24):
                self.underline = number == 4 and rest != ["0"]
            elif number in (7, 27):
                self.reverse = number == 7
            elif 30 <= number <= 37 or 90 <= number <= 97:
                self.ink = BASIC[number % 10 + (8 if number >= 90 else 0)]
            elif 40 <= number <= 47 or 100 <= number <= 107:
                self.paper = BASIC[number % 10 + (8 if number >= 100 else 0)]
            elif number == 39:
                self.ink = None
            elif number == 49:
                self.paper = None


def columns(text: str) -> int:
    """How many columns a text takes in a terminal."""
    return sum(2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in text)


def runs(line: str, style: Style):
    """Pieces of a line with the column they start at, each in one style."""
    column = 0
    for part in re.split(r"(\x1b\[[0-9;:]*m)", line):
        if part.startswith("\x1b["):
            style.take(part[2:-1])
        elif part:
            width = columns(part)
            yield column, width, part
            column += width


def svg(screen: str) -> str:
    """A screen as tmux prints it with -e."""
    style = Style()
    boxes, texts = [], []
    lines = screen.rstrip("\n").split("\n")
    for row, line in enumerate(lines):
        for column, width, part in runs(line, style):
            ink, paper = style.colors()
            x, y = column * CELL_X, row * CELL_Y
            if paper != PAPER:
                boxes.append(f'<rect x="{x:g}" y="{y:g}" width="{width * CELL_X:g}" height="{CELL_Y:g}" fill="{paper}"/>')
            if style.underline:
                boxes.append(
                    f'<rect x="{x:g}" y="{y + CELL_Y - 2:g}" width="{width * CELL_X:g}" height="1" fill="{ink}"/>'
                )
            weight = ' font-weight="bold"' if style.bold else ""
            slant = ' font-style="italic"' if style.italic else ""
            for word in re.finditer(r"\S+", part):
                # place and length are given, so that every font keeps the columns
                left, long = x + columns(part[: word.start()]) * CELL_X, columns(word.group()) * CELL_X
                texts.append(
                    f'<text x="{left:g}" y="{y + CELL_Y - 4.5:g}" fill="{ink}"{weight}{slant} '
                    f'textLength="{long:g}" lengthAdjust="spacingAndGlyphs">{html.escape(word.group())}</text>'
                )
    width, height = WIDTH * CELL_X, len(lines) * CELL_Y
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-10 -10 {width + 20:g} {height + 20:g}" '
        f'font-family="ui-monospace, DejaVu Sans Mono, Menlo, Consolas, monospace" font-size="{SIZE}" '
        f'xml:space="preserve">\n<rect x="-10" y="-10" width="{width + 20:g}" height="{height + 20:g}" rx="8" '
        f'fill="{PAPER}"/>\n' + "\n".join(boxes + texts) + "\n</svg>\n"
    )


def drive(options: argparse.Namespace, base: pathlib.Path) -> str:
    workspace = base / "arm"
    shutil.copytree(ROOT / "docs" / "examples" / "industrial_arm", workspace)
    macro = workspace / "src" / "lunder6_support" / "urdf" / "lunder6_macro.xacro"
    (base / "nvim").mkdir()
    (base / "nvim" / "init.lua").write_text(
        f"vim.opt.runtimepath:prepend({str(ROOT / 'editors' / 'nvim')!r})\n"
        f"vim.g.xacro = {{ cmd = {{ {str(options.server.resolve())!r} }} }}\n"
        "vim.o.swapfile, vim.o.termguicolors, vim.o.laststatus, vim.o.wrap = false, true, 2, false\n"
        "vim.o.statusline = \" %t%m%=%{v:lua.require'xacro'.status()}  %l:%c \"\n"
        "vim.diagnostic.config({ virtual_lines = { current_line = true } })\n"
        "vim.o.number, vim.o.shortmess = true, vim.o.shortmess .. 'I'\n",
        encoding="utf-8",
    )
    folders = {f"XDG_{name}_HOME": str(base) for name in ("CONFIG", "DATA", "STATE", "CACHE")}
    env = folders | {"TERM": "screen-256color", "COLORTERM": "truecolor", "LANG": "C.UTF-8"}
    socket = str(base / "socket")
    neovim = str(options.neovim.resolve())
    server = subprocess.Popen(
        [neovim, "--headless", "--listen", socket, "-n", str(macro)],
        env=os.environ | env, cwd=workspace,
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )
    try:
        while not os.path.exists(socket):
            if server.poll() is not None:
                raise SystemExit("Neovim did not start")
        terminal = Terminal("picture", [neovim, "--server", socket, "--remote-ui"], env, str(workspace), (WIDTH, HEIGHT))
        try:
            return show(terminal)
        finally:
            terminal.end()
    finally:
        server.terminate()


def show(terminal: Terminal) -> str:
    terminal.wait("the file", "xacro:macro")
    terminal.wait("the robot", "lunder6.xacro")
    terminal.text(":XacroExpand")
    terminal.keys("Enter")
    terminal.wait("the expanded text", "<robot name=")
    terminal.text(':%s/number="3" parent="link_2"/number="3" parent="lnk_2"/')
    terminal.keys("Enter")
    terminal.wait("the finding", "undefined-link")
    terminal.text('/number="3"')
    terminal.keys("Enter")
    terminal.text("zz0f:l")
    terminal.wait("the expanded text to follow", '<joint name="joint_3"')
    terminal.text(":nohlsearch | echo '' | lua vim.lsp.buf.hover({ border = 'rounded', max_width = 56, anchor_bias = 'above' })")
    terminal.keys("Enter")
    terminal.wait("the hover", "╭")
    return terminal.screen(colors=True)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--server", type=pathlib.Path, required=True)
    parser.add_argument("--neovim", type=pathlib.Path, required=True)
    options = parser.parse_args()
    base = pathlib.Path(tempfile.mkdtemp(prefix="xacro-picture-"))
    try:
        screen = drive(options, base)
        picture = svg(screen)
    finally:
        shutil.rmtree(base, ignore_errors=True)
    target = ROOT / "docs" / "images" / "neovim.svg"
    target.parent.mkdir(exist_ok=True)
    target.write_text(picture, encoding="utf-8")
    print(target)


if __name__ == "__main__":
    main()
