"""Expand and check xacro and URDF robot descriptions.

The functions run the program `xacro-lint` that this package brings along. It needs no ROS and executes no code of the files.
"""

from __future__ import annotations

from ._api import Diagnostic, Related, XacroError, XacroWarning, check, expand, files_read
from ._program import find_program

__all__ = [
    "Diagnostic",
    "Related",
    "XacroError",
    "XacroWarning",
    "check",
    "expand",
    "files_read",
    "find_program",
]
