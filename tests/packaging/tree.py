"""Grammars of languages whose own programs are in no registry."""

from common import run, tool

SCRIPT = """
import importlib, pathlib, sys
import tree_sitter
language = tree_sitter.Language(importlib.import_module("tree_sitter_" + sys.argv[1]).language())
root = tree_sitter.Parser(language).parse(pathlib.Path(sys.argv[2]).read_bytes()).root_node
sys.exit(f"{sys.argv[2]} is no {sys.argv[1]}: {root}" if root.has_error else 0)
"""


def parse(language, file):
    """A file of that language has no syntax error."""
    run([tool("python"), "-c", SCRIPT, language, file])
