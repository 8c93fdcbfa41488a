"""Write the tables that the expression parser is tested against.

    python3.11 tests/oracle/expr_table.py

Trees come from `ast`, error texts from `compile`; both are those of the running interpreter,
which has to be CPython 3.11. The output goes to `src/expr/testdata/`:

* `valid.txt`: expression (JSON), tab, tree, tab, ranges of all nodes in the order of the tree;
* `invalid.txt`: text (JSON), tab, text of the SyntaxError.
"""

import ast
import json
import pathlib
import struct
import sys
import warnings

from expr_inputs import INVALID, VALID

OUT = pathlib.Path(__file__).parents[2] / "src/expr/testdata"

UNARY = {ast.USub: "neg", ast.UAdd: "pos", ast.Invert: "~", ast.Not: "not"}
BINARY = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.MatMult: "@", ast.Div: "/", ast.FloorDiv: "//",
    ast.Mod: "%", ast.Pow: "**", ast.LShift: "<<", ast.RShift: ">>", ast.BitAnd: "&", ast.BitOr: "|",
    ast.BitXor: "^",
}
COMPARE = {
    ast.Eq: "==", ast.NotEq: "!=", ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.In: "in",
    ast.NotIn: "not-in", ast.Is: "is", ast.IsNot: "is-not",
}
COMPREHENSIONS = {ast.ListComp: "list", ast.SetComp: "set", ast.GeneratorExp: "gen"}


def text(value):
    return json.dumps(value, ensure_ascii=False)


def bits(value):
    return struct.pack(">d", value).hex()


class Dumper:
    """One tree; `ranges` are byte offsets in the same order as the nodes."""

    def __init__(self, source):
        self.ranges = []
        self.lines = [0]
        data = source.encode()
        for i, byte in enumerate(data):
            if byte == 10:
                self.lines.append(i + 1)

    def at(self, line, column):
        return self.lines[line - 1] + column

    def node(self, node):
        if node is None:
            return "_"
        if not isinstance(node, ast.JoinedStr):
            start = self.at(node.lineno, node.col_offset)
            end = self.at(node.end_lineno, node.end_col_offset)
            self.ranges.append(f"{start}:{end}")
        return getattr(self, type(node).__name__)(node)

    def all(self, nodes):
        return "".join(" " + self.node(n) for n in nodes)

    def Name(self, n):
        return n.id

    def Constant(self, n):
        v = n.value
        if v is None or v is Ellipsis or isinstance(v, bool):
            return f"#{v}"
        if isinstance(v, int):
            return str(v)
        if isinstance(v, float):
            return f"(float {bits(v)})"
        if isinstance(v, complex):
            return f"(imag {bits(v.imag)})"
        if isinstance(v, bytes):
            return f"(bytes {v.hex()})"
        return text(v)

    def UnaryOp(self, n):
        return f"({UNARY[type(n.op)]} {self.node(n.operand)})"

    def BinOp(self, n):
        return f"({BINARY[type(n.op)]} {self.node(n.left)} {self.node(n.right)})"

    def BoolOp(self, n):
        return f"({'and' if isinstance(n.op, ast.And) else 'or'}{self.all(n.values)})"

    def Compare(self, n):
        out = self.node(n.left)
        for op, right in zip(n.ops, n.comparators):
            out += f" {COMPARE[type(op)]} {self.node(right)}"
        return f"(cmp {out})"

    def IfExp(self, n):
        return f"(if {self.node(n.test)} {self.node(n.body)} {self.node(n.orelse)})"

    def Lambda(self, n):
        a = n.args
        plain = [(p, "pos") for p in a.posonlyargs] + [(p, "arg") for p in a.args]
        defaults = [None] * (len(plain) - len(a.defaults)) + a.defaults
        out = [(k, p.arg, d) for (p, k), d in zip(plain, defaults)]
        if a.vararg or a.kwonlyargs:
            out.append(("star", a.vararg.arg if a.vararg else "", None))
        out += [("kw", p.arg, d) for p, d in zip(a.kwonlyargs, a.kw_defaults)]
        if a.kwarg:
            out.append(("stars", a.kwarg.arg, None))
        params = " ".join(f"{k}:{name}" + (f"={self.node(d)}" if d else "") for k, name, d in out)
        return f"(lambda ({params}) {self.node(n.body)})"

    def List(self, n):
        return f"(list{self.all(n.elts)})"

    def Tuple(self, n):
        return f"(tuple{self.all(n.elts)})"

    def Set(self, n):
        return f"(set{self.all(n.elts)})"

    def Dict(self, n):
        pairs = "".join(f" {self.node(k) if k else '**'} {self.node(v)}" for k, v in zip(n.keys, n.values))
        return f"(dict{pairs})"

    def Starred(self, n):
        return f"(* {self.node(n.value)})"

    def comprehension(self, kind, elements, generators):
        out = " ".join(self.node(e) for e in elements)
        for g in generators:
            out += f" for {self.node(g.target)} {self.node(g.iter)}"
            out += "".join(f" if {self.node(i)}" for i in g.ifs)
        return f"({kind}-comp {out})"

    def ListComp(self, n):
        return self.comprehension(COMPREHENSIONS[type(n)], [n.elt], n.generators)

    SetComp = GeneratorExp = ListComp

    def DictComp(self, n):
        return self.comprehension("dict", [n.key, n.value], n.generators)

    def Attribute(self, n):
        return f"(. {self.node(n.value)} {n.attr})"

    def Subscript(self, n):
        return f"(index {self.node(n.value)} {self.node(n.slice)})"

    def Slice(self, n):
        return f"(slice {self.node(n.lower)} {self.node(n.upper)} {self.node(n.step)})"

    def Call(self, n):
        out = self.node(n.func) + self.all(n.args)
        out += "".join(f" {k.arg + '=' if k.arg else '**'}{self.node(k.value)}" for k in n.keywords)
        return f"(call {out})"

    def NamedExpr(self, n):
        return f"(:= {n.target.id} {self.node(n.value)})"

    def JoinedStr(self, n):
        return f"(f{''.join(' ' + self.part(p) for p in n.values)})"

    def part(self, p):
        if isinstance(p, ast.Constant):
            return text(p.value)
        conversion = "" if p.conversion == -1 else " !" + chr(p.conversion)
        spec = "" if p.format_spec is None else "".join(" " + self.part(s) for s in p.format_spec.values)
        return f"{{{self.node(p.value)}{conversion}{spec}}}"


def valid_line(source):
    tree = ast.parse(source, "<expression>", "eval").body
    dumper = Dumper(source)
    dump = dumper.node(tree)
    # Ranges inside f-strings are not reliable in 3.11.
    ranges = "-" if "(f " in dump or dump == "(f)" else " ".join(dumper.ranges)
    return f"{text(source)}\t{dump}\t{ranges}\n"


def invalid_line(source):
    try:
        compile(source.strip(), "<expression>", "eval")
    except (SyntaxError, RecursionError) as error:
        return f"{text(source)}\t{text(str(error))}\n"
    sys.exit(f"this is valid: {source!r}")


def unique(items):
    return list(dict.fromkeys(items))


def main():
    if sys.version_info[:2] != (3, 11):
        sys.exit("this table describes CPython 3.11")
    warnings.simplefilter("ignore")
    OUT.mkdir(exist_ok=True)
    (OUT / "valid.txt").write_text("".join(map(valid_line, unique(VALID))))
    (OUT / "invalid.txt").write_text("".join(map(invalid_line, unique(INVALID))))


if __name__ == "__main__":
    main()
