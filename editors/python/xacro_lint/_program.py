"""Where the program is that was installed with this package."""

from __future__ import annotations

import os
import shutil
import sys
import sysconfig
from pathlib import Path
from typing import Iterator, Optional

_NAME = "xacro-lint.exe" if sys.platform == "win32" else "xacro-lint"


def _folders() -> Iterator[Optional[str]]:
    """The folders into which installers put programs, the likeliest first."""
    yield sysconfig.get_path("scripts")
    package = Path(__file__).resolve().parent.parent
    # `pip install --target DIR` puts programs into `DIR/bin`; `--prefix DIR` packages into `DIR/lib/pythonX.Y/site-packages`
    for above in [package, *list(package.parents)[2:3]]:
        yield str(above / "bin")
        yield str(above / "Scripts")
    yield sysconfig.get_path("scripts", scheme="nt_user" if os.name == "nt" else "posix_user")


def find_program() -> str:
    """The path of `xacro-lint`: of `XACRO_LINT` if it is set, else the one of this package, else the one on the `PATH`.

    Raises `FileNotFoundError` if there is none.
    """
    chosen = os.environ.get("XACRO_LINT")
    if chosen:
        found = shutil.which(chosen)
        if found is None:
            raise FileNotFoundError(f"`XACRO_LINT` is `{chosen}`, which is not a program")
        return found
    for folder in _folders():
        if folder is not None and os.path.isfile(os.path.join(folder, _NAME)):
            return os.path.join(folder, _NAME)
    found = shutil.which("xacro-lint")
    if found is None:
        raise FileNotFoundError("the program `xacro-lint` is missing: run `pip install --force-reinstall xacro-lint`")
    return found
