"""Random expressions of a wanted kind, written as xacro's Python."""
import ast
import re
from collections import Counter

from . import literals
from .grammar import GRAMMAR, WILD
from .trial import printable

PLACE = re.compile(r'\{(\w+)(?::(\d+))?(?:\+(\w)=(\w+))?\}')
LAMBDA, COND, UNARY, POST, ATOM = 0, 1, 12, 15, 16
COUNTS = Counter()  # uses of each form, for --stats


OPERATORS = {ast.BitOr: 6, ast.BitXor: 7, ast.BitAnd: 8, ast.LShift: 9, ast.RShift: 9, ast.Add: 10, ast.Sub: 10, ast.Pow: 13}
NODES = {ast.Lambda: 0, ast.IfExp: 1, ast.Compare: 5, ast.Call: 15, ast.Subscript: 15, ast.Attribute: 15}


def precedence(source):
    """How tightly the outermost operator of an expression binds."""
    node = ast.parse(source, mode='eval').body
    if isinstance(node, ast.Tuple) and not source.startswith('('):
        return 0
    if isinstance(node, ast.BoolOp):
        return 2 if isinstance(node.op, ast.Or) else 3
    if isinstance(node, ast.UnaryOp):
        return 4 if isinstance(node.op, ast.Not) else 12
    if isinstance(node, ast.BinOp):
        return OPERATORS.get(type(node.op), 11)
    return NODES.get(type(node), 16)


def read(table):
    """Templates of one kind: (precedence, text, weight)."""
    rows = []
    for line in table.strip().split('\n'):
        text, weight = re.fullmatch(r'\s*(.+?)(?: @(\d+))?', line).groups()
        rows.append((precedence(PLACE.sub('x', text)), text, int(weight or 1)))
    return rows


SAFE = {kind: read(table) for kind, table in GRAMMAR.items()}
RISKY = {kind: read(table) for kind, table in WILD.items()}
FORMS = sorted({text for table in (SAFE, RISKY) for rows in table.values() for _, text, _ in rows})


class Expressions:
    """Expression source over the names that `names(kind)` offers.

    `avoid` holds global symbols that the program has redefined.
    """

    def __init__(self, rng, names, avoid=()):
        self.rng, self.names = rng, names
        self.avoid = re.compile(r'(?<![\w.])(%s)(?!\w)' % '|'.join(map(re.escape, avoid))) if avoid else None
        self.bound, self.wild, self.taken = [], False, []

    def make(self, kind, depth=3):
        """Source of an expression of `kind`."""
        return self.at(kind, COND, depth)

    def closed(self, depth=3):
        """Source of an expression without names from the wilder grammar; it works in Python."""
        for _ in range(40):
            self.wild, self.taken = True, []
            kind = self.rng.choice(['int', 'num', 'num', 'text', 'text', 'mix', 'mix'])
            source, _ = self.template(self.rng.choice(RISKY[kind]), depth)
            self.wild = False
            if printable(source):
                COUNTS.update(self.taken)
                return source
        return self.make('num', 1)

    def at(self, kind, level, depth):
        """An expression that can stand where precedence `level` is asked for."""
        source, prec = self.pick(kind, depth)
        if kind in ('digit', 'plain'):  # stand inside a word
            return source
        if prec < level or self.rng.random() < 0.03:
            return '(' + self.pad() + source + self.pad() + ')'
        return source

    def pad(self):
        return ' ' if self.rng.random() < 0.05 else ''

    def pick(self, kind, depth):
        rng = self.rng
        if kind not in SAFE:
            return self.leaf(kind)
        names = [] if self.wild else self.names(kind)
        names = names + [name for name, k in self.bound if k == kind] * 2
        if names and rng.random() < (0.65 if depth <= 0 else 0.3):
            name = rng.choice(names)
            return name, (UNARY if name.startswith('-') else POST)
        if depth <= 0 or rng.random() < 0.15:
            return self.leaf(kind)
        rows = SAFE[kind]
        if self.wild and kind in RISKY and rng.random() < 0.4:
            rows = RISKY[kind]
        return self.template(rng.choices(rows, [w for _, _, w in rows])[0], depth - 1)

    def template(self, row, depth):
        """Fill a template; rejects those that use a redefined symbol."""
        prec, text, _ = row
        if self.avoid and self.avoid.search(PLACE.sub('', text)):
            return self.leaf('int' if self.wild else 'any') if self.wild else self.leaf_like(row)
        (self.taken.append if self.wild else lambda t: COUNTS.update([t]))(text)
        v, w = self.rng.sample(['i', 'j', 'm', 'x', 'q', 'item'], 2)

        def fill(match):
            kind, level, name, bound = match.groups()
            if kind in 'vw':
                return v if kind == 'v' else w
            level = COND if level is None else int(level)
            if name is None:
                return self.at(kind, level, depth)
            self.bound.append((v if name == 'v' else w, bound))
            try:
                return self.at(kind, level, depth)
            finally:
                self.bound.pop()

        if re.fullmatch(r'\{\w+:16\}', text):  # the kind of another: keep its precedence
            return self.pick(text[1:-4], depth)
        return self.space(PLACE.sub(fill, text)), prec

    def leaf_like(self, row):
        kind = next(kind for kind, rows in SAFE.items() if row in rows)
        return self.leaf(kind)

    def space(self, source):
        """Now and then other white space around the operators."""
        if self.rng.random() > 0.06 or '\'' in source or '"' in source:
            return source
        return re.sub(r' ([-+*/%<>=&|^]+) ', self.rng.choice([r'\1', r'  \1 ', r' \1  ']), source)

    def leaf(self, kind):
        """A literal of `kind` and its precedence."""
        rng = self.rng
        if kind == 'idx':
            return str(rng.randrange(4)), ATOM
        if kind == 'bit':
            return str(rng.randrange(2)), ATOM
        if kind in ('digit', 'plain'):
            return (str(rng.randrange(2, 10)) if kind == 'digit' else rng.choice(literals.WORDS)), ATOM
        if kind == 'int':
            if rng.random() < 0.04:
                return '(%s)' % rng.choice(literals.BIG_INTS), ATOM
            return (str(rng.randrange(100)) if rng.random() < 0.6 else rng.choice(literals.INTS)), ATOM
        if kind == 'big':
            return '(%s)' % rng.choice(literals.BIG_INTS), ATOM
        if kind == 'nz':
            return rng.choice([('3', ATOM), ('7', ATOM), ('10', ATOM), ('-4', UNARY), ('2', ATOM), ('0x10', ATOM), ('-1', UNARY)])
        if kind == 'nzflt':
            return rng.choice([('3.0', ATOM), ('0.5', ATOM), ('7', ATOM), ('-2.5', UNARY), ('1e3', ATOM), ('.1', ATOM)])
        if kind == 'flt':
            return (rng.choice(literals.FLOATS) if rng.random() < 0.5 else repr(round(rng.uniform(0.02, 99), rng.randrange(1, 6)))), ATOM
        if kind == 'num':
            return self.leaf(rng.choice(['int', 'flt']))
        if kind == 'odd':
            choices = literals.ODD_FLOATS if rng.random() < 0.7 else literals.BIG_INTS
            return '(%s)' % rng.choice(choices), ATOM
        if kind == 'odd2':
            return '(%s, %s)' % (self.leaf('odd')[0], self.leaf('odd')[0]), ATOM
        if kind == 'bool':
            return rng.choice(['True', 'False']), ATOM
        if kind == 'word':
            return literals.word_literal(rng), ATOM
        if kind == 'text':
            return literals.text_literal(rng), ATOM
        if kind == 'ilist':
            return '[%s]' % ', '.join(str(rng.randrange(-5, 60)) for _ in range(rng.randrange(2, 6))), ATOM
        if kind == 'wlist':
            return '[%s]' % ', '.join(literals.word_literal(rng) for _ in range(rng.randrange(2, 5))), ATOM
        if kind == 'dict':
            return 'dict(a=%d, b=%d)' % (rng.randrange(50), rng.randrange(50)), POST
        if kind == 'mix':
            return rng.choice(['[]', '()', '[1, None]', "('a', 2.5)", '[[1], [2]]']), ATOM
        if kind == 'fn':
            return 'lambda x: x + %d' % rng.randrange(9), LAMBDA
        if kind == 'any':
            return self.leaf(rng.choice(['int', 'flt', 'bool', 'word', 'text', 'mix', 'odd']))
        raise ValueError(kind)
