#!/usr/bin/env python3
"""Write the files of this folder for a release: `fill.py OWNER/REPOSITORY VERSION SHA256SUMS FOLDER`.

`@VERSION@`, `@OWNER@` and `@REPOSITORY@` become what was given, `@SHA256:NAME@` the checksum of that file of the release.
"""

import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
# not templates, or not for other repositories
KEPT = {"fill.py", "README.md"}


def checksums(text):
    """The checksums of a release by the names of its files."""
    lines = (line.split(maxsplit=1) for line in text.splitlines() if line.strip())
    return {name.strip().lstrip("*"): value for value, name in lines}


def fill(text, repository, version, sums):
    """A template with its values; a file that the release lacks ends the program."""
    owner, name = repository.split("/")
    text = text.replace("@VERSION@", version).replace("@OWNER@", owner).replace("@REPOSITORY@", name)

    def checksum(match):
        if match[1] not in sums:
            sys.exit(f"SHA256SUMS has no `{match[1]}`")
        return sums[match[1]]

    return re.sub(r"@SHA256:([^@]+)@", checksum, text)


def write(repository, version, sums, target):
    """All templates, in the same folders."""
    for file in sorted(HERE.rglob("*")):
        path = file.relative_to(HERE)
        if file.is_file() and path.name not in KEPT and path.parts[0] != "ros" and "__pycache__" not in path.parts:
            (target / path).parent.mkdir(parents=True, exist_ok=True)
            (target / path).write_text(fill(file.read_text(), repository, version, sums))


if __name__ == "__main__":
    if len(sys.argv) != 5 or "/" not in sys.argv[1]:
        sys.exit(__doc__)
    write(sys.argv[1], sys.argv[2], checksums(pathlib.Path(sys.argv[3]).read_text()), pathlib.Path(sys.argv[4]))
