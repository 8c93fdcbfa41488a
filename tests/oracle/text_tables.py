"""Write the tables that the splitter of texts and the substitutions are tested against.

    python3.11 tests/oracle/text_tables.py [COUNT [FOLDER]]

Needs the reference, xacro 2.1.1. The output goes to `src/expr/testdata/` (or FOLDER), one JSON
array per line:

* `templates.txt`: text, tokens;
* `substitutions.txt`: text between the parentheses, and the result: `["value", text]`, or
  `["error", class, message]`.

COUNT random texts are added to the fixed ones.
"""

import json
import os
import pathlib
import random
import sys

from xacro import LEXER, QuickLexer, XacroException, substitution_args

OUT = pathlib.Path(__file__).parents[2] / "src/expr/testdata"

TEXTS = [
    "", "a", " ", "\n", "$", "$$", "$$$", "a$", "$a", "$ a", "$\n", "a$\n", "$$\n", "${}", "$()", "${a}", "$(a)",
    "a${b}c", "${a}${b}", "${a} ", " ${a}", "$(arg a)/b", "$(find p)/${q}.xacro", "US$5", "$5 and $6", "cost $$",
    "$$x", "$${x}", "$$(x)", "$$${x}", "$$$$(x)", "a$${x}b${y}", "${", "${a", "a${b", "$(", "$(a", "${a)", "$(a}",
    "${'}'}", "${{1:2}}", "${f(')')}", "${a$b}", "${'$'}", "${'$5'}", "${$(arg a)}", "${'$(arg a)' == 'x'}", "${$(a}",
    "${${a}}", "${$${a}}", "${'$$'}", "${$$(a)}", "$(arg ${a})", "$(arg ${f(1)})", "$(eval ${a} + 1)", "$(arg ${a)}",
    "$(a $b)", "$(a $(b))", "$(a $${b})", "$(arg ${$(x)})", "$(${$(a}})", "${a}\n${b}", "{a}", "}{", "$}", "$)", "$a${b}",
    "$a$b", "$$a${b}", "${a}$$", "${a}$", "é${ü}ö", "$é{", "${é$(ü)}", "$é(", "a $ {b}", "$\t(a)", "${\n}", "$(\n)",
]
INNERS = [
    "", " ", "  ", "a", "arg", "arg a", "arg  a", " arg a", "arg a ", "arg a b", "arg missing", "arg\ta", "find", "find p", "find p q",
    "env", "env A", "env MISSING", "env A B", "optenv", "optenv A", "optenv MISSING", "optenv MISSING d", "optenv MISSING d  e f",
    "optenv A d", "cwd", "cwd ", " cwd", "dirname", "dirname x", "anon", "anon x", "eval", "evalx", "(", "a(", "arg (", "arg a$", "$",
    "$x", "arg $a", "arg a(b", "arg b", "arg c", "arg d", "arg e", "arg f", "arg g", "arg h", "find a) $(arg a", "arg a)$(arg b",
    "find p) and $(find q", "arg a) (b", "arg a) $(nope x", "arg a)$", "arg a)$(", "arg a)$()", "arg a)$( )", "env A) $(env MISSING", "optenv X $(arg a",
    "nope x", "find $(arg a", "find é", "arg i", "arg j",
]
ARGS = {
    "a": "1", "b": "$(arg a)", "c": "$(find p)/x", "d": "x(y)", "e": "$(nope)", "f": "$( )", "g": "$", "h": "$(env)", "i": "$(find p q)",
    "j": "$(arg missing) $(find z)",
}
ENV = {"A": "env-a"}


def tokens(text):
    lexer = QuickLexer(LEXER)
    out = []

    def add(kind, value):
        if kind == "text" and out and out[-1][0] == "text":
            out[-1][1] += value
        else:
            out.append([kind, value])

    def nested(inner):
        return tokens(inner) if "$" in inner else inner

    try:
        lexer.lex(text)
        while lexer.peek():
            kind, found = lexer.peek()
            if kind == lexer.EXPR:
                add("expr", nested(found[2:-1]))
            elif kind == lexer.EXTENSION:
                add("subst", nested(found[2:-1]))
            elif kind == lexer.TEXT:
                add("text", found)
            else:
                add("escape", found[1:])
            lexer.next()
    except XacroException as error:
        rest = str(error).removeprefix("invalid expression: ")
        add("invalid", rest)
    return out


def resolve(inner):
    if inner == "cwd":
        return ["value", "<cwd>"]
    try:
        context = {"arg": ARGS}
        return ["value", substitution_args.resolve_args(f"$({inner})", context=context)]
    except substitution_args.ArgException as error:
        return ["error", "undefined", str(error)]
    except Exception as error:
        name = type(error).__qualname__
        module = type(error).__module__
        return ["error", name if module == "builtins" else f"{module}.{name}", str(error)]


def write(folder, name, rows):
    lines = [json.dumps(row, ensure_ascii=False) + "\n" for row in rows]
    (folder / name).write_text("".join(lines))


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 120
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else OUT
    substitution_args._eval_find = lambda package: f"<find {package}>"
    os.environ.clear()
    os.environ.update(ENV)
    choose = random.Random(1)
    texts = list(TEXTS)
    while len(texts) < len(TEXTS) + count:
        texts.append("".join(choose.choices("$$${}()a \n", k=choose.randint(2, 14))))
    inners = list(INNERS)
    words = ["arg", "find", "env", "optenv", "a", "b", "c", "A", " ", " ", ")", "(", "$", "$("]
    while len(inners) < len(INNERS) + count:
        inners.append(" ".join(choose.choices(words, k=choose.randint(1, 7))))
    write(folder, "templates.txt", [[t, tokens(t)] for t in dict.fromkeys(texts)])
    usable = [i for i in dict.fromkeys(inners) if not i.startswith("eval ")]
    write(folder, "substitutions.txt", [[i, resolve(i)] for i in usable])


if __name__ == "__main__":
    main()
