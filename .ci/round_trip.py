#!/usr/bin/env python3
"""The way from the expanded text to its source and back, over the robots of the folder that is named."""
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main(shared):
    corpus = pathlib.Path(shared) / "corpus"
    packages = corpus / "src"
    lines = []
    for entry in json.loads((corpus / "entries.json").read_text())["entries"]:
        if entry["expect"] == "ok":
            args = [arg.replace("@WS@", str(packages)) for arg in entry["args"]]
            lines.append("\t".join([str(packages / entry["package"] / entry["file"]), *args]))
    listed = ROOT / "target" / "round_trip" / "robots.txt"
    listed.parent.mkdir(parents=True, exist_ok=True)
    listed.write_text("\n".join(lines) + "\n")
    env = dict(os.environ, ROUND_TRIP=str(listed), ROS_PACKAGE_PATH=str(packages))
    return subprocess.run(["cargo", "test", "--quiet", "--test", "round_trip", "--", "--nocapture"], cwd=ROOT, env=env).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
