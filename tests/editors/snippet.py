"""Blocks of code of a page, by the comment above them: `<!-- run: NAME -->`."""

import pathlib
import re

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "editors.md"


def snippet(name: str) -> str:
    pattern = rf"<!-- run: {re.escape(name)} -->\n```\w*\n(.*?)^```"
    found = re.search(pattern, PAGE.read_text(encoding="utf-8"), re.S | re.M)
    if not found:
        raise SystemExit(f"docs/editors.md has no block `{name}`")
    return found.group(1)
