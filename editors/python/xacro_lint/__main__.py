"""`python -m xacro_lint` is `xacro-lint`, where the folder of programs is not on the PATH."""

from __future__ import annotations

import os
import subprocess
import sys

from ._program import find_program


def main() -> int:
    command = [find_program(), *sys.argv[1:]]
    if sys.platform != "win32":
        os.execv(command[0], command)
    # Windows has no `exec`: the new process would outlive the one that the shell waits for
    return subprocess.run(command, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
