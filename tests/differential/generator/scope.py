"""What a program knows at a point: names, blocks, macros, namespaces."""
from dataclasses import dataclass, field, replace
from typing import Any, Optional


class Scope:
    """A symbol table as the running program will have it.

    A `boundary` is the scope of a macro body: of what lies beyond it, only names
    that stay for good may be used, for the body runs later. A namespace has its
    names in the chain of the including scope, but macros of its own.
    """

    def __init__(self, parent=None, boundary=False, namespace=False):
        self.parent, self.boundary, self.namespace = parent, boundary, namespace
        self.names, self.blocks, self.macros, self.spaces = {}, {}, {}, {}

    def chain(self):
        """(scope, whether only lasting names count) from here outwards."""
        scope, lasting = self, False
        while scope:
            yield scope, lasting
            lasting = lasting or scope.boundary
            scope = scope.parent

    def visible_names(self, lasting_only=False):
        """All names that can be read here."""
        found = {}
        for scope, lasting in self.chain():
            for name, stays in scope.names.items():
                if stays or not (lasting or lasting_only):
                    found.setdefault(name, None)
        return list(found)

    def visible_blocks(self):
        return list({name: None for scope, _ in self.chain() for name in scope.blocks})

    def visible_macros(self):
        """(call name, macro, scope that `scope="parent"` reaches in a namespace)."""
        found = {}
        for scope, _ in self.chain():
            for name, macro in scope.macros.items():
                found.setdefault(name, (macro, None))
            if scope.namespace:
                break
        for prefix, space in self.visible_spaces(macros=True):
            for name, macro in space.macros.items():
                found.setdefault(prefix + '.' + name, (macro, space.parent))
        return [(name, macro, target) for name, (macro, target) in found.items()]

    def visible_spaces(self, macros=False):
        """(dotted prefix, namespace scope) reachable from here."""
        for scope, _ in self.chain():
            for name, space in scope.spaces.items():
                yield name, space
                for inner, deeper in space.spaces.items():
                    yield name + '.' + inner, deeper
            if macros and scope.namespace:
                break

    def define(self, name, lasting=True):
        self.names[name] = lasting

    def top(self):
        return self if self.parent is None else self.parent.top()


@dataclass
class Param:
    """A value parameter; `default` is its text after `:=`, `free` whether a call may leave it out anywhere."""
    name: str
    kind: Any
    default: Optional[str] = None
    free: bool = False


@dataclass
class Macro:
    """What a call has to provide, and what the call leaves behind."""
    name: str
    params: list = field(default_factory=list)
    blocks: list = field(default_factory=list)  # (name, inserts the children)
    requires: list = field(default_factory=list)  # names that the caller must have
    leaves: list = field(default_factory=list)  # names set with scope="parent"
    leaves_global: list = field(default_factory=list)
    cost: int = 1
    single: bool = False  # the body is exactly one element
    redefinable: bool = True


@dataclass(frozen=True)
class Context:
    """Where the generator is writing."""
    scope: Scope
    folder: Optional[str] = ''  # of the file being processed; None in macro bodies
    depth: int = 1  # of indentation
    certain: bool = True  # whether this is executed for sure, and once
    body: Optional[Macro] = None
    prefixes: tuple = ()  # namespace prefixes that the file declares
    nesting: int = 0  # of includes

    def deeper(self):
        return replace(self, depth=self.depth + 1)

    def unsure(self):
        """The same place inside a branch that may not be taken."""
        return replace(self, scope=Scope(self.scope), certain=False)
