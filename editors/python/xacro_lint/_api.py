"""The functions, each one run of the program."""

from __future__ import annotations

import json
import os
import subprocess
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterable, List, Mapping, Optional, Tuple, Union

from ._program import find_program

PathLike = Union[str, "os.PathLike[str]"]
# xacro writes `True`, numbers and strings of Python alike: by `str`
Arguments = Mapping[str, object]


class XacroError(Exception):
    """The program could not do it; the text is what it printed, with the locations of the errors."""


class XacroWarning(UserWarning):
    """What the program printed although it succeeded."""


@dataclass(frozen=True)
class Related:
    """Another location that a diagnostic refers to. Rows and columns start at 1."""

    filename: str
    row: int
    column: int
    end_row: int
    end_column: int
    message: str


@dataclass(frozen=True)
class Diagnostic:
    """A finding. Rows and columns start at 1; columns count characters; the end is exclusive."""

    code: str
    name: str
    severity: str
    message: str
    filename: str
    row: int
    column: int
    end_row: int
    end_column: int
    help: Optional[str]
    related: Tuple[Related, ...]
    places: int
    fixable: bool

    def __str__(self) -> str:
        return f"{self.filename}:{self.row}:{self.column}: {self.severity}: {self.message} [{self.name}]"


def expand(
    path: PathLike,
    args: Optional[Arguments] = None,
    *,
    package_path: Iterable[PathLike] = (),
    cwd: Optional[PathLike] = None,
) -> str:
    """The text that `xacro path name:=value ...` prints.

    Raises `XacroError` if the file cannot be expanded. Warnings of xacro become `XacroWarning`.
    """
    return _run(["expand", *_packages(package_path), *_file(path, args)], cwd)


def files_read(
    path: PathLike,
    args: Optional[Arguments] = None,
    *,
    package_path: Iterable[PathLike] = (),
    cwd: Optional[PathLike] = None,
) -> List[Path]:
    """The file and all files that it includes or loads; watch them to expand it again."""
    printed = _run(["deps", "--format", "json", *_packages(package_path), *_file(path, args)], cwd)
    return [Path(cwd or ".", name) for name in json.loads(printed)["files"]]


def check(
    *paths: PathLike,
    args: Optional[Arguments] = None,
    select: Iterable[str] = (),
    ignore: Iterable[str] = (),
    package_path: Iterable[PathLike] = (),
    cwd: Optional[PathLike] = None,
) -> List[Diagnostic]:
    """What `xacro-lint check` finds in files and folders, of every severity; without a path, in the current folder.

    Raises `XacroError` if an option is wrong, or a file or the configuration cannot be read.
    """
    command = ["check", "--format", "json", "--exit-zero", *_packages(package_path)]
    for option, rules in (("--select", select), ("--ignore", ignore)):
        names = [rules] if isinstance(rules, str) else list(rules)
        if names:
            command += [option, ",".join(names)]
    command += _assignments(args)
    command += ["--", *(_path(path) for path in paths)] if paths else []
    # progress and notes are printed beside the findings
    return [_diagnostic(entry) for entry in json.loads(_run(command, cwd, notes=True))]


def _run(command: List[str], cwd: Optional[PathLike], *, notes: bool = False) -> str:
    done = subprocess.run(
        [find_program(), *command],
        cwd=cwd,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        errors="replace",
        check=False,
    )
    if done.returncode != 0:
        raise XacroError(done.stderr.strip() or f"`xacro-lint {command[0]}` ended with {done.returncode}")
    if done.stderr.strip() and not notes:
        warnings.warn(done.stderr.strip(), XacroWarning, stacklevel=3)
    return done.stdout


def _path(path: PathLike) -> str:
    text = os.fspath(path)
    # neither an option nor standard input, whatever its name is
    return os.path.join(os.curdir, text) if text.startswith("-") else text


def _file(path: PathLike, args: Optional[Arguments]) -> List[str]:
    return [_path(path), *_assignments(args)]


def _assignments(args: Optional[Arguments]) -> List[str]:
    assignments = []
    for name, value in (args or {}).items():
        if not name or ":=" in name or name.startswith("-"):
            raise ValueError(f"`{name}` is not the name of an argument")
        assignments.append(f"{name}:={value}")
    return assignments


def _packages(folders: Iterable[PathLike]) -> List[str]:
    listed = [folders] if isinstance(folders, (str, os.PathLike)) else folders
    return [part for folder in listed for part in ("--package-path", _path(folder))]


def _diagnostic(entry: Mapping[str, Any]) -> Diagnostic:
    return Diagnostic(
        code=entry["code"],
        name=entry["name"],
        severity=entry["severity"],
        message=entry["message"],
        help=entry["help"],
        related=tuple(Related(message=other["message"], **_location(other)) for other in entry["related"]),
        places=entry["places"],
        fixable=entry["fix"] is not None,
        **_location(entry),
    )


def _location(entry: Mapping[str, Any]) -> Mapping[str, Any]:
    start, end = entry["location"], entry["end_location"]
    return {
        "filename": entry["filename"],
        "row": start["row"],
        "column": start["column"],
        "end_row": end["row"],
        "end_column": end["column"],
    }
