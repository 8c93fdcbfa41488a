#!/usr/bin/env python3
"""What is handed out, and how it is used: packages, hooks, workflows, recipes.

`run.py [STEP ...]` needs `cargo build --release` and the built viewer before it. Everything it makes is in `target/packaging`.
"""

import sys
import time

sys.dont_write_bytecode = True

import assistants
import builds
import channels
import hooks
import recipes
import ros
import workflows
from common import Failed, install_tools

STEPS = {
    "workflows": workflows.lint,
    "workflow-mistakes": workflows.mistakes,
    "action": workflows.action,
    "wheel": builds.wheel,
    "python": builds.python,
    "crate": builds.crate,
    "static": builds.static,
    "manifest": hooks.manifest,
    "hooks-wheel": hooks.wheel,
    "hooks-mirror": hooks.mirror,
    "hooks-source": hooks.source,
    "colcon": recipes.workspace,
    "pytest": recipes.pytest,
    "assistants": assistants.client,
    "ros": ros.packages,
    "channels": channels.files,
}


def main(names):
    unknown = [name for name in names if name not in STEPS]
    if unknown:
        sys.exit(f"no such step: {' '.join(unknown)}; there are {' '.join(STEPS)}")
    install_tools()
    failed = []
    for name in names or STEPS:
        start = time.monotonic()
        try:
            STEPS[name]()
            outcome = "ok"
        except (Failed, OSError, ValueError) as problem:
            outcome = "FAILED"
            failed.append(name)
            print(f"{type(problem).__name__}: {problem}")
        print(f"{outcome:6} {name} ({time.monotonic() - start:.1f} s)", flush=True)
    print(f"packaging: {len(names or STEPS) - len(failed)} passed, {len(failed)} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
