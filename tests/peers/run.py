#!/usr/bin/env python3
"""What other tools say about descriptions with one mistake each, as the tables of docs/comparison.md.

    tests/peers/run.py --bin target/release/xacro-lint            print the tables
    tests/peers/run.py --bin target/release/xacro-lint --update   write them into the page, with the date

The Python tools come from PyPI into target/peers; check_urdf is that of the system (Debian: liburdfdom-tools).
A tool detects a mistake if it fails, or prints something that it does not print for the robot without mistakes.
"""
import argparse
import datetime
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import faults

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "comparison.md"
WANTED = ["xacro==2.1.1", "urdf_parser_py==0.0.4", "yourdfpy==0.0.60"]

PARSER_PY = "import sys; from urdf_parser_py.urdf import URDF; URDF.from_xml_file(sys.argv[1])"
YOURDFPY = (
    "import sys, logging; logging.basicConfig(level=logging.WARNING); import yourdfpy; "
    "robot = yourdfpy.URDF.load(sys.argv[1], load_meshes=False, build_scene_graph=True); "
    "print('valid' if robot.validate() else 'not valid', *robot.errors)"
)


def python():
    """A Python that has the tools."""
    home = ROOT / "target" / "peers"
    program = home / "bin" / "python"
    if not program.exists():
        subprocess.run([sys.executable, "-m", "venv", home], check=True)
        subprocess.run([program, "-m", "pip", "install", "--quiet", *WANTED], check=True)
    return str(program)


def said(command, path):
    """Exit code and text of a run, without what differs from run to run."""
    try:
        run = subprocess.run([*command, path.name], cwd=path.parent, capture_output=True, text=True, timeout=60)
    except subprocess.TimeoutExpired:
        return "does not end", ""
    text = run.stdout + run.stderr
    return run.returncode, text


def sees(command, path, clean):
    """`yes`, `no`, or `line` when it is seen and a line of the file is named."""
    code, text = said(command, path)
    if code == "does not end":
        return code
    if code == clean[0] and (code != 0 or not remarks(text, clean[1])):
        return "no"
    named = re.search(rf"{re.escape(path.name)}:\d+|line \d+, col|line \d+:\d+", text)
    return "line" if named else "yes"


def remarks(text, clean):
    """Lines that speak of something wrong, and were not printed for the robot without mistakes."""
    words = re.compile(r"error|warn|not valid|unknown|invalid|fail|info\[|note", re.IGNORECASE)
    return [line for line in text.splitlines() if words.search(line) and line not in clean.splitlines()]


def table(texts, ending, tools):
    """Rows of Markdown: what each tool says of each text."""
    rows = [f"| mistake | {' | '.join(tools)} |", "|---|" + "---|" * len(tools)]
    counts = dict.fromkeys(tools, 0)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / f"robot.{ending}"
        path.write_text(texts["no mistake at all"], encoding="utf-8")
        clean = {name: said(command, path) for name, command in tools.items()}
        for name, (code, text) in clean.items():
            if code != 0:
                sys.exit(f"{name} refuses the robot without mistakes: {text}")
        for mistake, text in texts.items():
            if mistake == "no mistake at all":
                continue
            path.write_text(text, encoding="utf-8")
            answers = [sees(command, path, clean[name]) for name, command in tools.items()]
            for name, answer in zip(tools, answers):
                counts[name] += answer in ("yes", "line")
            rows.append(f"| {mistake} | {' | '.join(answers)} |")
    rows.append(f"| **detected, of {len(texts) - 1}** | " + " | ".join(f"**{count}**" for count in counts.values()) + " |")
    return "\n".join(rows) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    if not shutil.which("check_urdf"):
        sys.exit("check_urdf is missing: apt-get install liburdfdom-tools")
    interpreter = python()
    ours = [options.bin, "check"]
    urdf = table(faults.URDF, "urdf", {
        "xacro-lint": ours,
        "check_urdf": ["check_urdf"],
        "urdf_parser_py": [interpreter, "-c", PARSER_PY],
        "yourdfpy": [interpreter, "-c", YOURDFPY],
    })
    xacro = table(faults.XACROS, "urdf.xacro", {
        "xacro-lint": ours,
        "xacro": [str(pathlib.Path(interpreter).with_name("xacro"))],
    })
    text = f"\n{urdf}\n{xacro}\nMeasured on {datetime.date.today():%Y-%m-%d}.\n\n"
    if options.update:
        page = PAGE.read_text(encoding="utf-8")
        page = re.sub(r"(<!-- tables: [^\n]*\n).*?(<!-- end of tables -->)", lambda m: m[1] + text + m[2], page, flags=re.S)
        PAGE.write_text(page, encoding="utf-8")
    else:
        print(text)


if __name__ == "__main__":
    main()
