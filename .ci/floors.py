#!/usr/bin/env python3
"""Run the larger case sets and fail where one passes fewer cases than `.ci/floors.toml` demands."""
import pathlib
import re
import subprocess
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
# what a runner says of a case that failed: without it a broken floor cannot be traced
FAILED = re.compile(r"\s*fail", re.IGNORECASE)


def count(name, command, pattern):
    """Run a command; how many cases passed, as it says."""
    print(f"\n-- {name}: {' '.join(command)}", flush=True)
    run = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    lines = run.stdout.splitlines()
    print("\n".join([line for line in lines[:-12] if FAILED.match(line)] + lines[-12:]), flush=True)
    counts = re.findall(pattern, run.stdout)
    return int(counts[-1]) if counts else 0


def main(shared):
    floors = tomllib.loads((HERE / "floors.toml").read_text())
    bad = []
    for name, floor in floors.items():
        command = [part.format(shared=shared, root=ROOT) for part in floor["command"]]
        pattern = floor.get("pattern", r"(\d+) passed, \d+ failed")
        passed = 0
        for _ in range(floor.get("tries", 1)):
            passed = max(passed, count(name, command, pattern))
            if passed >= floor["least"]:
                break
        if passed < floor["least"]:
            bad.append(f"{name}: {passed} passed, the floor is {floor['least']}")
        elif passed > floor["least"]:
            print(f"-- {name}: {passed} passed, above the floor of {floor['least']}: raise it")
    for line in bad:
        print("FLOOR BROKEN", line)
    print(f"\nfloors: {len(floors) - len(bad)} passed, {len(bad)} failed")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
