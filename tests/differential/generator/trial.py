"""Trying closed expressions out with Python itself."""
import ast
import builtins
import math
import re
import warnings
from types import SimpleNamespace


def tokenize(s, sep=',; ', skip_empty=True):
    """Like the function of the reference, to try expressions out."""
    parts = re.split('[%s]' % sep, s)
    return [part for part in parts if part] if skip_empty else parts


class Dotted(dict):
    """Stands in for the dictionaries with dotted access."""

    def __getattr__(self, name):
        if name in self:
            return self[name]
        raise AttributeError(name)


def trial_names():
    """The global names of an expression, as Python values."""
    names = {k: v for k, v in math.__dict__.items() if not k.startswith('_')}
    direct = 'list dict map len str float int bool True False min max round sorted range'.split()
    more = ('abs all any complex divmod enumerate filter frozenset hash isinstance issubclass ord repr reversed slice '
            'set sum tuple type vars zip').split()
    names.update((k, getattr(builtins, k)) for k in direct)
    names['math'] = SimpleNamespace(**{k: v for k, v in math.__dict__.items() if not k.startswith('_')})
    names['python'] = SimpleNamespace(**{k: getattr(builtins, k) for k in direct + more})
    names['xacro'] = SimpleNamespace(tokenize=tokenize, dotify=Dotted)
    names['__builtins__'] = {}
    names['_power'] = power
    return names


class Bounded(ast.NodeTransformer):
    """Replaces powers by calls of a function that refuses large ones."""

    def visit_BinOp(self, node):
        self.generic_visit(node)
        if isinstance(node.op, ast.Pow):
            call = ast.Call(ast.Name('_power', ast.Load()), [node.left, node.right], [])
            return ast.fix_missing_locations(ast.copy_location(call, node))
        return node


def power(base, exponent):
    """`**` within reason."""
    if isinstance(base, int) and isinstance(exponent, int) and base.bit_length() * abs(exponent) > 2000:
        raise OverflowError
    return base ** exponent


TRIAL = trial_names()
warnings.filterwarnings('ignore', category=SyntaxWarning)


def printable(source):
    """Whether a closed expression works and prints the same in every process."""
    try:
        tree = ast.parse(source, mode='eval')
        if '**' in source:
            tree = Bounded().visit(tree)
        text = str(eval(compile(tree, 'trial', 'eval'), TRIAL))  # our own text, no names but the ones above
    except Exception:
        return False
    return len(text) < 300 and ' at 0x' not in text and '$' not in text
