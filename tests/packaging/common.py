"""What the steps share: where things are, running commands, blocks of the documentation."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGET = ROOT / "target"
WORK = TARGET / "packaging"
TOOLS = WORK / "tools"
RELEASE = TARGET / "release"
EXAMPLES = ROOT / "docs" / "examples"


class Failed(Exception):
    """A step found something wrong."""


def demand(condition, message):
    if not condition:
        raise Failed(message)


def run(command, *, code=0, cwd=ROOT, **variables):
    """What a command prints; it has to end with `code`."""
    environment = {**os.environ, **{name: str(value) for name, value in variables.items()}}
    command = [str(part) for part in command]
    done = subprocess.run(
        command, cwd=cwd, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False
    )
    demand(
        done.returncode == code,
        f"{' '.join(command)}\nended with {done.returncode} instead of {code}:\n{done.stdout[-6000:]}",
    )
    return done.stdout


def tool(name):
    """A program of the environment that the tests make for themselves."""
    return TOOLS / "bin" / name


def with_tools(*first):
    """The PATH with those programs in front, and folders before them."""
    return os.pathsep.join([*map(str, first), str(TOOLS / "bin"), os.environ["PATH"]])


def fresh(name):
    """An empty folder for a step."""
    folder = WORK / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def blocks(page, language):
    """The code blocks of a page of the documentation in a language."""
    text = (ROOT / "docs" / page).read_text()
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def snippet(page, name):
    """The code block of a page that a comment above it names."""
    text = (ROOT / "docs" / page).read_text()
    found = re.findall(rf"^<!-- run: {name} -->\n```\w+\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    demand(len(found) == 1, f"docs/{page} has {len(found)} blocks `{name}`")
    return found[0]


def install_tools():
    """Make the environment with the tools, once for each list of them."""
    wanted = (ROOT / "tests/packaging/requirements.txt").read_text()
    mark = TOOLS / "requirements.txt"
    if not mark.is_file() or mark.read_text() != wanted:
        shutil.rmtree(TOOLS, ignore_errors=True)
        run([sys.executable, "-m", "venv", TOOLS])
        run([tool("pip"), "install", "--quiet", "--requirement", ROOT / "tests/packaging/requirements.txt"])
        mark.write_text(wanted)
    run(["npm", "ci", "--silent", "--no-audit", "--no-fund", "--prefix", ROOT / "tests/packaging"])
