#!/usr/bin/env python3
"""Draw a sample of findings on public repositories, to be judged by hand, and count the verdicts.

    tests/precision/sample.py CHECKOUTS --bin BIN --seed N [--errors 150] [--warnings 150] --out sheet.csv
    tests/precision/sample.py --summary sheet.csv

CHECKOUTS holds one folder per repository, and is not named `src`. The sample is stratified: of each rule at most 12 errors and 8 warnings, of
these at most 3 (2) from one repository; where that gives too few, further findings are taken rule by rule. The same
seed and the same findings give the same sheet. Missing meshes, textures and installed files that `.not-there` of a checkout lists (files
that the copy lacks) are left out: of a
group, the first one that is no such file is shown. Verdicts: true, noise (right and of no interest), false, doubtful.
"""
import argparse
import collections
import csv
import json
import os
import pathlib
import random
import re
import statistics
import subprocess
import sys

VERDICTS = ('true', 'noise', 'false', 'doubtful')
COLUMNS = ('repository', 'place', 'rule', 'severity', 'message', 'verdict', 'reason')
PER_RULE = {'error': 12, 'warning': 8}
PER_REPOSITORY = {'error': 3, 'warning': 2}
# the last part of a path that ends in an extension
FILE = re.compile(r'[^/\s`"\']+\.[A-Za-z]\w{1,4}(?=[`"\'\s:,;)]|$)')
# what is said of the call in which a file is missing, and libraries in it, are no files of the robot
CALL, LIBRARY = 'in this call', '.so'
FILE_RULES = ('mesh-not-found', 'texture-not-found')
INSTALL_RULE = 'installed-file-not-found'
VARIABLES = ('ROS', 'AMENT', 'CMAKE_PREFIX', 'COLCON')

# the folder of a workspace that holds its packages: of one repository, those of all others would be found there
WORKSPACE = 'src'

Finding = collections.namedtuple('Finding', 'repository place rule severity message')


def check(command, checkout):
    """The findings of a repository, as the program prints them without any ROS variable."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(VARIABLES)}
    run = subprocess.run([command, 'check', '--format', 'json', '.'], cwd=checkout, env=environment, capture_output=True, check=False)
    if run.returncode not in (0, 1):
        sys.exit('%s: exit status %d: %s' % (checkout, run.returncode, run.stderr.decode('utf-8', 'replace')[-500:]))
    return json.loads(run.stdout)


def is_lacking(rule, place, absent):
    """Whether a place is about a file, or the files of a folder, that only the copy of the repository lacks."""
    message = place.get('message', '')
    if rule == INSTALL_RULE:
        path = os.path.normpath(os.path.join(os.path.dirname(place['filename']), message.split('`')[1]))
        return any(file == path or file.startswith(path + '/') for file in absent)
    if rule not in FILE_RULES:
        return False
    named = [name for name in FILE.findall(message) if not name.endswith(LIBRARY)]
    return any(pathlib.PurePosixPath(file).name in named for file in absent)


def collect(repository, findings, absent=()):
    """Errors and warnings of a repository, without those about files that only the copy lacks."""
    absent = [path for path in absent if path]
    found = []
    for finding in findings:
        others = [place for place in finding.get('related') or () if not place['message'].startswith(CALL)]
        related = [place for place in others if finding['name'] == INSTALL_RULE or FILE.search(place['message'])]
        there = [place for place in (finding, *related) if not is_lacking(finding['name'], place, absent)]
        if finding['severity'] in PER_RULE and there:
            place = there[0]
            found.append(Finding(repository, '%s:%d:%d' % (place['filename'], place['location']['row'], place['location']['column']),
                                 finding['name'], finding['severity'], place['message']))
    return found


def draw(findings, severity, wanted, seed):
    """A stratified sample of the findings of a severity, at most `wanted`."""
    rules = collections.defaultdict(list)
    for finding in sorted(set(findings)):
        if finding.severity == severity:
            rules[finding.rule].append(finding)
    taken, spare = collections.defaultdict(list), {}
    for rule, found in sorted(rules.items()):
        # a generator per rule: a finding more of one rule does not change the others
        random.Random('%s %s %s' % (seed, severity, rule)).shuffle(found)
        count, rest = collections.Counter(), []
        for finding in found:
            fits = len(taken[rule]) < PER_RULE[severity] and count[finding.repository] < PER_REPOSITORY[severity]
            count[finding.repository] += fits
            (taken[rule] if fits else rest).append(finding)
        spare[rule] = rest
    sample = round_robin(taken, wanted)
    return sorted(sample + round_robin(spare, wanted - len(sample)), key=lambda f: (f.rule, f))


def round_robin(strata, wanted):
    """One finding of each stratum after the other, until there are enough."""
    queues, result = {rule: list(found) for rule, found in strata.items()}, []
    while len(result) < wanted and any(queues.values()):
        for rule in sorted(queues):
            if queues[rule] and len(result) < wanted:
                result.append(queues[rule].pop(0))
    return result


def write_sheet(path, sample):
    """The sample as CSV, with empty columns for verdict and reason."""
    with open(path, 'w', encoding='utf-8', newline='') as out:
        sheet = csv.writer(out, lineterminator='\n')
        sheet.writerow(COLUMNS)
        sheet.writerows([*finding, '', ''] for finding in sample)


def ratio(part, whole):
    return '%.1f %%' % (100 * part / whole) if whole else '-'


def summary(path):
    """Figures of a judged sheet, as a Markdown table; raises ValueError on an unknown verdict."""
    with open(path, encoding='utf-8', newline='') as sheet:
        rows = list(csv.DictReader(sheet))
    counts = collections.defaultdict(collections.Counter)
    for number, row in enumerate(rows, 2):
        verdict = row['verdict'].strip().lower()
        if verdict not in (*VERDICTS, ''):
            raise ValueError('row %d: unknown verdict `%s`, expected one of %s' % (number, verdict, ', '.join(VERDICTS)))
        for key in ((row['severity'], row['rule']), (row['severity'], 'all')):
            counts[key]['sampled'] += 1
            counts[key][verdict] += 1
    lines = ['| rule | severity | sampled | %s | true of the judged |' % ' | '.join(VERDICTS),
             '|---|---|---|' + '---|' * (len(VERDICTS) + 1)]
    for (severity, rule), count in sorted(counts.items(), key=lambda item: (item[0][0], item[0][1] == 'all', item[0][1])):
        judged = sum(count[verdict] for verdict in VERDICTS)
        lines.append('| %s | %s | %d | %s | %s |' % (rule, severity, count['sampled'], ' | '.join(
            str(count[verdict]) for verdict in VERDICTS), ratio(count['true'], judged)))
    unjudged = sum(counts[severity, 'all'][''] for severity in PER_RULE)
    if unjudged:
        lines.append('\n%d of %d findings are not judged yet' % (unjudged, len(rows)))
    return '\n'.join(lines)


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('checkouts', nargs='?', type=pathlib.Path)
    parser.add_argument('--bin', type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument('--seed', type=int)
    parser.add_argument('--errors', type=int, default=150)
    parser.add_argument('--warnings', type=int, default=150)
    parser.add_argument('--out', type=pathlib.Path)
    parser.add_argument('--summary', type=pathlib.Path, metavar='SHEET')
    options = parser.parse_args()
    if options.summary:
        try:
            print(summary(options.summary))
        except ValueError as error:
            sys.exit(str(error))
        return
    if not (options.checkouts and options.bin and options.out and options.seed is not None):
        parser.error('CHECKOUTS, --bin, --seed and --out are needed, or --summary')
    if options.checkouts.resolve().name == WORKSPACE:
        parser.error('CHECKOUTS is named %s, which the program takes for a workspace of all repositories in it: move them' % WORKSPACE)
    findings, per_repository = [], []
    for checkout in sorted(path for path in options.checkouts.iterdir() if path.is_dir()):
        not_there = checkout / '.not-there'
        absent = not_there.read_text(encoding='utf-8', errors='replace').splitlines() if not_there.exists() else []
        found = collect(checkout.name.replace('+', '/', 1), check(options.bin, checkout), absent)
        per_repository.append(sum(finding.rule not in FILE_RULES for finding in found))
        findings += found
    sample = draw(findings, 'error', options.errors, options.seed) + draw(findings, 'warning', options.warnings, options.seed)
    write_sheet(options.out, sample)
    print('%d repositories, %d errors and warnings, %d drawn' % (len(per_repository), len(findings), len(sample)))
    if per_repository:
        print('errors and warnings per repository without missing meshes and textures: median %g, p90 %d'
              % (statistics.median(per_repository), percentile(per_repository, 0.9)))


if __name__ == '__main__':
    main()
