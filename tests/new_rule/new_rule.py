#!/usr/bin/env python3
"""Begin a rule: its file, its lines in the category and its page, ready to be filled in.

    tests/new_rule/new_rule.py CATEGORY NAME [--check link|joint|element|document|whole-document|robot|whole|file] [--severity SEVERITY] [--off]

CATEGORY is a folder of src/rules (joint, frames, ...), NAME the name of the rule (kebab-case). What it writes compiles and finds
nothing. The page docs/contributing/rules.md goes on from there.
"""
import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# what a check is given: the variant, the context, and the one thing that it looks at
CHECKS = {
    'file': ('File', 'FileCx', None),
    'link': ('Link', 'DocumentCx', 'model::Link'),
    'joint': ('Joint', 'DocumentCx', 'model::Joint'),
    'element': ('Element', 'DocumentCx', 'super::super::xml::CheckedElement'),
    'document': ('Document', 'DocumentCx', None),
    'whole-document': ('WholeDocument', 'DocumentCx', None),
    'robot': ('Robot', 'RobotCx', None),
    'whole': ('Whole', 'RobotCx', None),
}

RULE = '''//! TODO: what is wrong, as the beginning of a sentence.

use super::super::context::{context};
use super::super::rule::{{Activation, Category, Check, Rule, Severity, page}};
use super::super::sink::Sink;
{uses}
pub(super) static RULE: Rule = Rule {{
    code: "{code}",
    name: "{name}",
    category: Category::{category},
    severity: Severity::{severity},
    default: Activation::{default},
    since: "{since}",
    fix: None,
    docs: page("{name}"),
    check: Check::{check}(check),
}};

fn check(_cx: &{context}<'_>, {argument}_out: &mut Sink<'_>) {{}}
'''

PAGE = '''# {name}

`{code}` · {severity} · {default} by default · no fix · since {since}

TODO: one sentence that describes the mistake.

## Why

TODO: what happens to the robot, and in which program.

## Reported

```urdf,bad
<robot name="arm">
  <link name="base_link"/>
              ^^^^^^^^^
</robot>
```

## Not reported

```urdf,good
<robot name="arm">
  <link name="base_link"/>
</robot>
```

## How to fix it

TODO

## When to allow it

If TODO.

## Source

TODO: the documentation, the code of a program, or the measurement that shows it.
'''


def categories(root):
    return sorted(path.parent.name for path in (root / 'src/rules').glob('*/mod.rs'))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('category', help='one of ' + ', '.join(categories(ROOT)))
    parser.add_argument('name')
    parser.add_argument('--check', choices=CHECKS, default='document')
    parser.add_argument('--severity', choices=('error', 'warning', 'info', 'hint'), default='warning')
    parser.add_argument('--off', action='store_true', help='the rule runs only where it is selected')
    parser.add_argument('--root', type=pathlib.Path, default=ROOT, help=argparse.SUPPRESS)
    args = parser.parse_args()
    folder = args.root / 'src/rules' / args.category
    if not (folder / 'mod.rs').is_file():
        sys.exit(f'new_rule: unknown category `{args.category}`; write one of {", ".join(categories(args.root))}')
    if not re.fullmatch(r'[a-z0-9]+(-[a-z0-9]+)+', args.name):
        sys.exit(f'new_rule: `{args.name}` is not a name of a rule; write at least two words in lower case, joined by `-`')
    page = args.root / f'docs/rules/{args.name}.md'
    if page.exists():
        sys.exit(f'new_rule: {page.relative_to(args.root)} exists')
    begin(args, folder, page)


def begin(args, folder, page):
    """Write the files of a rule and its lines in the list of the category."""
    texts = ''.join(path.read_text() for path in folder.glob('*.rs'))
    letters, category = re.search(r'"([A-Z]{3})\d{3}"', texts)[1], re.search(r'Category::(\w+)', texts)[1]
    taken = [int(number) for number in re.findall(rf'"{letters}(\d{{3}})"', texts)]
    variant, context, looks_at = CHECKS[args.check]
    uses = f'use {looks_at};\n' if looks_at else ''
    argument = f'_{args.check}: &{looks_at.split("::")[-1]}, ' if looks_at else ''
    version = re.search(r'^version = "(\d+\.\d+)', (args.root / 'Cargo.toml').read_text(), re.MULTILINE)
    values = {
        'name': args.name, 'code': f'{letters}{max(taken) + 1:03}', 'category': category, 'check': variant, 'context': context,
        'uses': uses, 'argument': argument,
        'since': version[1] if version else '0.1',
    }
    module = args.name.replace('-', '_')
    default = 'Off' if args.off else 'On'
    (folder / f'{module}.rs').write_text(RULE.format(severity=args.severity.capitalize(), default=default, **values))
    page.write_text(PAGE.format(severity=args.severity, default=default.lower(), **values))
    listing = folder / 'mod.rs'
    text = listing.read_text()
    modules = re.findall(r'^(?:pub\(super\) )?mod (\w+);\n', text, re.MULTILINE)
    before = next((name for name in modules if name > module), None)
    if before:
        text = re.sub(rf'^((?:pub\(super\) )?mod {before};\n)', rf'mod {module};\n\1', text, count=1, flags=re.MULTILINE)
    else:
        text = re.sub(rf'^((?:pub\(super\) )?mod {modules[-1]};\n)', rf'\1mod {module};\n', text, count=1, flags=re.MULTILINE)
    text = re.sub(r'(static RULES: &\[&Rule\] = &\[.*?)(\n\];)', rf'\1\n    &{module}::RULE,\2', text, count=1, flags=re.DOTALL)
    listing.write_text(text)
    for path in (folder / f'{module}.rs', listing, page):
        print(path.relative_to(args.root))
    print('next: docs/contributing/rules.md, section "Fill it in"')


if __name__ == '__main__':
    main()
