#!/usr/bin/env python3
"""Compare an xacro implementation with the reference on random programs.

    run.py --bin "target/release/xacro-lint expand" [--seed 1] [--count 300]
           [--jobs N] [--python VENV/bin/python] [--keep DIR] [--stats]

Program I of seed S is always the same. A program that the reference expands must
give the same bytes; one that it refuses must be refused with exit status 2, a
message and no output. Differing programs are made smaller and printed with their
difference; `--keep` writes them to a folder. `--bin reference` runs the command
of the reference itself, which must give no difference. Last line:
`N passed, M failed`. See README.md.
"""
import argparse
import concurrent.futures
import difflib
import multiprocessing
import os
import re
import shlex
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter

sys.dont_write_bytecode = True
import reference  # noqa: E402

if __name__ == '__main__':
    sys.path.insert(0, reference.STAND_IN)

OPTIONS = None  # of the command line; workers inherit them


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__.split('\n\n')[0], formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--bin', required=True, help='command to test, or `reference`')
    parser.add_argument('--seed', default='1')
    parser.add_argument('--count', type=int, default=300, help='number of programs')
    parser.add_argument('--first', type=int, default=0, help='index of the first program')
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--python', help='Python that can import xacro %s' % reference.VERSION)
    parser.add_argument('--keep', metavar='DIR', help='write differing programs here')
    parser.add_argument('--stats', action='store_true', help='print which constructs the programs had')
    parser.add_argument('--minimise', type=int, default=10, metavar='N', help='make up to N differing programs smaller')
    parser.add_argument('--seconds', type=float, default=20, help='time for making one program smaller')
    parser.add_argument('--verify', type=int, default=3, metavar='N', help='check N programs against the command of the reference')
    parser.add_argument('--disable', action='append', default=[], metavar='FEATURE', help='walrus, entity-markup or encodings; may be given again')
    parser.add_argument('--corners', action='store_true', help='only small programs about the corners of XML, names and namespaces')
    parser.add_argument('--show', type=int, metavar='INDEX', help='print one program and what both make of it')
    options = parser.parse_args()
    options.python = os.path.abspath(reference.python(options.python))
    return options


def tested_command(text, python):
    """The command as a list, its program as an absolute path."""
    if text == 'reference':
        return reference.command(python)
    words = shlex.split(text)
    found = shutil.which(words[0])
    if found is None:
        sys.exit('no such program: ' + words[0])
    return [os.path.abspath(found)] + words[1:]


# --- one program; runs in the workers

def scratch():
    """The folder of this worker."""
    base = '/dev/shm' if os.path.isdir('/dev/shm') else tempfile.gettempdir()
    return os.path.join(base, 'xacro-differential-%d' % os.getpid(), 'program')


def both(program):
    """Results of the reference and of the tested command."""
    import engine
    folder = scratch()
    engine.write(program, folder)
    wanted = engine.run_reference(program, folder)
    return wanted, engine.run_command(OPTIONS.command, program, folder)


def signature(verdict, wanted, got):
    """A short text that groups differences of one cause."""
    if verdict == 'another output':
        return '%s: %s' % (verdict, first_difference(wanted.out, got.out))
    errors = (got if got.code else wanted).err.decode('utf-8', 'replace').split('\n')
    first = next((line for line in errors if line.startswith(('error', 'XML', 'Error'))), errors[0])
    return '%s: %s' % (verdict, re.sub(r"'[^']*'|\"[^\"]*\"|`[^`]*`|\d+", '#', first)[:100])


def first_difference(wanted, got):
    """What kind of thing differs first."""
    wanted, got = wanted.split(b'\n'), got.split(b'\n')
    at = next((i for i, pair in enumerate(zip(wanted, got)) if pair[0] != pair[1]), min(len(wanted), len(got)))
    pair = [lines[at].decode('utf-8', 'replace').strip() if at < len(lines) else None for lines in (wanted, got)]
    if None in pair:
        return 'length'
    if not all(pair):
        return 'an empty line more' if pair[0] else 'an empty line less'
    words = [re.findall(r'[\w.+-]+|\W', text) for text in pair]
    odd = next(((a, b) for a, b in zip(*words) if a != b), None)
    if odd is None or len(words[0]) != len(words[1]):
        return 'comment' if '<!--' in pair[0] + pair[1] else 'tag or text'
    return 'number' if all(re.match(r'[-+]?[\d.]', word) for word in odd) else 'word'


def overdue(*_):
    raise TimeoutError


def try_index(index):
    """Generate and compare program `index`: what the summary needs to know."""
    import engine
    signal.signal(signal.SIGALRM, overdue)
    signal.alarm(3 * engine.TIME)
    try:
        return try_program(index)
    except TimeoutError:
        return index, None, '', 'generator out of time', None, set(), Counter()
    finally:
        signal.alarm(0)


def try_program(index):
    """What `try_index` does in the time that it has."""
    import engine
    from generator import expressions
    from generator.program import generate
    expressions.COUNTS.clear()
    program = generate('%s:%d' % (OPTIONS.seed, index), OPTIONS.disable, OPTIONS.corners)
    forms = Counter(expressions.COUNTS) if OPTIONS.stats else Counter()
    wanted, got = both(program)
    verdict = engine.judge(wanted, got)
    return index, verdict, signature(verdict, wanted, got) if verdict else '', program.kind, wanted.code, set(program.uses), forms


def try_smaller(index):
    """Make program `index` smaller; returns it with both results."""
    import engine
    from generator.program import generate
    from minimise import Minimiser
    program = generate('%s:%d' % (OPTIONS.seed, index), OPTIONS.disable, OPTIONS.corners)
    wanted, got = both(program)
    aim = signature(engine.judge(wanted, got), wanted, got)

    def fails(candidate):
        wanted, got = both(candidate)
        verdict = engine.judge(wanted, got)
        return bool(verdict) and signature(verdict, wanted, got) == aim

    small = Minimiser(fails, OPTIONS.seconds).run(program)
    return index, program, small, *both(small)


def verify(index):
    """Whether the forked reference does what its command does."""
    import engine
    from generator.program import generate
    program = generate('%s:%d' % (OPTIONS.seed, index), OPTIONS.disable, OPTIONS.corners)
    engine.write(program, scratch())
    here = engine.run_reference(program, scratch())
    there = engine.run_command(reference.command(OPTIONS.python), program, scratch())
    return (here.code, here.out) == (there.code, there.out)


# --- reports

def unified(wanted, got):
    """Difference of the outputs, or the messages when there is none."""
    lines = [r.out.decode('utf-8', 'backslashreplace').splitlines(keepends=True) for r in (wanted, got)]
    text = ''.join(line if line.endswith('\n') else line + '\n' for line in difflib.unified_diff(*lines, 'reference', 'tested', n=2))
    for name, result in (('reference', wanted), ('tested', got)):
        if result.code:
            text += '%s: exit %s\n%s\n' % (name, result.code, result.err.decode('utf-8', 'replace').strip())
    return text


def printed(program):
    """The files of a program as text."""
    text = ''
    for path, data in sorted(program.files.items()):
        if data:
            text += '--- %s\n%s\n' % (path, data.decode('utf-8', 'backslashreplace'))
    return text + '--- arguments: %s  environment: %s\n' % (program.args, program.env)


def keep(folder, index, program, small, wanted, got):
    """Write a differing program, whole and small, with both results."""
    import engine
    target = os.path.join(folder, '%s-%d' % (OPTIONS.seed, index))
    engine.write(program, os.path.join(target, 'whole'))
    engine.write(small, os.path.join(target, 'small'))
    reports = {'difference.txt': unified(wanted, got).encode(), 'expected.urdf': wanted.out, 'got.urdf': got.out,
               'command.txt': ('input.xacro %s\n%s\n' % (shlex.join(small.args), small.env)).encode()}
    for name, data in reports.items():
        with open(os.path.join(target, name), 'wb') as out:
            out.write(data)


def table(counts, total):
    """Constructs with the number of programs, in three columns."""
    rows = ['%6d  %-42s' % (n, name[:42]) for name, n in sorted(counts.items(), key=lambda item: (-item[1], item[0]))]
    height = -(-len(rows) // 3)
    for i in range(height):
        print(''.join(rows[i::height]).rstrip())
    print('(%d constructs in %d programs)' % (len(rows), total))


def print_stats(outcomes):
    """What the programs were made of."""
    from generator.expressions import FORMS
    uses, forms = Counter(), Counter()
    for outcome in outcomes:
        uses.update(outcome[5])
        forms.update(outcome[6])
    print('\nconstructs, by number of programs:')
    table(uses, len(outcomes))
    never = [form for form in FORMS if form not in forms]
    print('expression forms: %d of %d used, %d uses; never: %s' % (len(FORMS) - len(never), len(FORMS), sum(forms.values()), never[:20]))
    print('kinds of programs and exit status of the reference: %s' % ', '.join(
        '%s %s: %d' % (kind, code, n) for (kind, code), n in sorted(Counter((o[3], o[4]) for o in outcomes).items(), key=str)))


def report_failures(pool, failures):
    """Print the differences by group, the first of each group made smaller."""
    groups = {}
    for outcome in failures:
        groups.setdefault(outcome[2], []).append(outcome[0])
    print('\ndifferences by kind:')
    for name, indexes in sorted(groups.items(), key=lambda item: -len(item[1])):
        print('%6d  %s  (%s)' % (len(indexes), name, ', '.join(map(str, indexes[:6]))))
    order = [indexes[n] for n in range(max(map(len, groups.values()))) for indexes in groups.values() if n < len(indexes)]
    for index, program, small, wanted, got in pool.map(try_smaller, order[:OPTIONS.minimise]):
        print('\n=== program %s:%d' % (OPTIONS.seed, index))
        print(printed(small) + unified(wanted, got), end='')
        if OPTIONS.keep:
            keep(OPTIONS.keep, index, program, small, wanted, got)


def show(index):
    """Print one program and both results."""
    from generator.program import generate
    program = generate('%s:%d' % (OPTIONS.seed, index), OPTIONS.disable, OPTIONS.corners)
    wanted, got = both(program)
    print(printed(program))
    print('reference: exit %s\n%s' % (wanted.code, (wanted.out or wanted.err).decode('utf-8', 'replace')))
    print(unified(wanted, got) or 'no difference')


def run():
    """The comparison; the exit status."""
    context = multiprocessing.get_context('fork')
    with concurrent.futures.ProcessPoolExecutor(OPTIONS.jobs, context) as pool:
        try:
            return run_in(pool)
        finally:
            for folder in set(pool.map(scratch_parent, range(OPTIONS.jobs * 4))):
                shutil.rmtree(folder, ignore_errors=True)


def run_in(pool):
    """The comparison, with a pool of workers."""
    begin = time.monotonic()
    indexes = range(OPTIONS.first, OPTIONS.first + OPTIONS.count)
    if not all(pool.map(verify, indexes[:OPTIONS.verify])):
        sys.exit('the forked reference differs from its command: the harness is wrong')
    outcomes = []
    for outcome in pool.map(try_index, indexes, chunksize=4):
        outcomes.append(outcome)
        if sys.stderr.isatty() and len(outcomes) % 50 == 0:
            print('\r%d of %d' % (len(outcomes), OPTIONS.count), end='', file=sys.stderr)
    spent = time.monotonic() - begin
    failures = [outcome for outcome in outcomes if outcome[1]]
    if OPTIONS.stats:
        print_stats(outcomes)
    if failures:
        report_failures(pool, failures)
    skipped = sum(outcome[1] is None for outcome in outcomes)
    refused = sum(outcome[4] == 2 for outcome in outcomes)
    print('%d programs, %d refused by the reference, %d left out (it crashed, or a listed limit); %.0f programs/s'
          % (len(outcomes), refused, skipped, len(outcomes) / spent))
    print('%d passed, %d failed' % (len(outcomes) - skipped - len(failures), len(failures)))
    return 1 if failures else 0


def scratch_parent(_):
    time.sleep(0.01)
    return os.path.dirname(scratch())


def main():
    global OPTIONS
    OPTIONS = parse_options()
    if os.path.abspath(sys.executable) != OPTIONS.python:  # the reference runs in this process
        environment = dict(os.environ, PYTHONHASHSEED='0')
        os.execve(OPTIONS.python, [OPTIONS.python, os.path.abspath(__file__)] + sys.argv[1:], environment)
    OPTIONS.command = tested_command(OPTIONS.bin, OPTIONS.python)
    if OPTIONS.show is not None:
        show(OPTIONS.show)
        return 0
    return run()


if __name__ == '__main__':
    sys.exit(main())
