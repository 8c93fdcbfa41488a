#!/usr/bin/env python3
"""Run the fuzz targets, and say how many inputs each tried and what it found.

    tests/fuzz/run.py [--seconds 600] [--only xml,yaml] [--seeds FOLDER] [--jobs 1]

Needs cargo-fuzz (`cargo install cargo-fuzz`) and works with a stable toolchain. `--jobs` targets run at once. A target
that fails is started again for the rest of its time, up to ten times. The corpus grows in `target/fuzz/corpus`; inputs
that fail are put into `target/fuzz/artifacts`. Files of `--seeds`, such as a folder with robots, are added to the seeds
of the targets that read descriptions. `python` compares random expressions with a Python that has the reference xacro.
"""
import argparse
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
REPOSITORY = os.path.dirname(os.path.dirname(HERE))
WORK = os.path.join(REPOSITORY, 'target', 'fuzz')
sys.path.insert(0, os.path.join(REPOSITORY, 'tests', 'differential'))
import reference  # noqa: E402

TARGETS = ('xml edits formatter expression yaml expander fixes mesh configuration launch '
           'launch_requests messages').split()
DESCRIPTIONS = {'xml': b'', 'edits': b'', 'formatter': b'\0', 'expander': b'\1', 'fixes': b'\1'}


def prepare(extra):
    """Write the seeds that the repository has, and those of a folder."""
    seeds = os.path.join(WORK, 'seeds')
    shutil.rmtree(seeds, ignore_errors=True)
    subprocess.run(['cargo', 'test', '--quiet', '--test', 'properties', 'seeds_for_the_fuzzer'], cwd=REPOSITORY,
                   env=dict(os.environ, SEEDS=seeds), stdout=subprocess.DEVNULL, check=True)
    number = 0
    for folder, _, files in os.walk(extra) if extra else []:
        for name in files:
            path = os.path.join(folder, name)
            if name.endswith(('.xacro', '.urdf')) and os.path.getsize(path) < 20000:
                number += 1
                for target, choice in DESCRIPTIONS.items():
                    with open(path, 'rb') as source, open(os.path.join(seeds, target, f'x{number}'), 'wb') as out:
                        out.write(choice + source.read())
    return seeds


def build():
    """Build all targets: the folder with the programs."""
    folder = os.path.join(WORK, 'build')
    subprocess.run(['cargo', 'fuzz', 'build', '--fuzz-dir', HERE, '--sanitizer', 'none', '--target-dir', folder],
                   cwd=REPOSITORY, env=dict(os.environ, RUSTC_BOOTSTRAP='1'), check=True)
    host = re.search(r'host: (\S+)', subprocess.check_output(['rustc', '-vV'], text=True)).group(1)
    return os.path.join(folder, host, 'release')


def fuzz(target, programs, seeds, seconds):
    """Run a target: number of inputs, text of what was found."""
    end, count, found = time.time() + seconds, 0, []
    while len(found) < 10 and (left := int(end - time.time())) > 0:
        tried, what = fuzz_once(target, programs, seeds, left)
        count += tried
        if not what:
            break
        found.append(what)
    return count, '; '.join(found)


def fuzz_once(target, programs, seeds, seconds):
    """Run a target until the time is over or it fails."""
    corpus = os.path.join(WORK, 'corpus', target)
    artifacts = os.path.join(WORK, 'artifacts', target) + os.sep
    os.makedirs(corpus, exist_ok=True)
    os.makedirs(artifacts, exist_ok=True)
    done = subprocess.run(
        [os.path.join(programs, target), corpus, os.path.join(seeds, target), f'-max_total_time={seconds}', '-timeout=30',
         '-rss_limit_mb=2048', '-max_len=16384', '-print_final_stats=1', f'-dict={seeds}/words.dict',
         f'-artifact_prefix={artifacts}'],
        cwd=WORK, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    text = done.stdout.decode('utf-8', 'replace')
    counts = re.findall(r'^#(\d+)\s', text, re.M)
    executed = re.search(r'number_of_executed_units:\s*(\d+)', text)
    count = int(executed.group(1)) if executed else max(map(int, counts), default=0)
    if done.returncode == 0:
        return count, ''
    what = re.search(r'panicked at.*?\n.*', text) or re.search(r'ERROR: .*', text)
    return count, what.group(0).replace('\n', ' ')[:600] if what else text[-600:]


def python(seconds):
    """Compare expressions with Python until the time is over: number of expressions, first differences."""
    interpreter = reference.python()
    table = os.path.join(WORK, 'python.txt')
    os.makedirs(WORK, exist_ok=True)
    end, count, seed, found = time.time() + seconds, 0, int(time.time()), []
    while time.time() < end:
        seed += 1
        with open(table, 'wb') as out:
            subprocess.run([interpreter, os.path.join(HERE, 'python_oracle.py'), '--seed', str(seed), '--count', '20000'],
                           stdout=out, env=reference.environment(), check=True)
        done = subprocess.run(['cargo', 'test', '--quiet', '--test', 'properties', 'python', '--', '--exact'], cwd=REPOSITORY,
                              env=dict(os.environ, TABLE=table), stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        count += 20000
        if done.returncode:
            text = done.stdout.decode('utf-8', 'replace')
            found += re.findall(r'^.*\n  python: .*\n  ours: .*', text, re.M) or [text[-600:]]
    return count, '\n'.join(found[:40])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--seconds', type=int, default=600)
    parser.add_argument('--only', default=','.join(TARGETS + ['python']))
    parser.add_argument('--seeds', help='a folder with more descriptions')
    parser.add_argument('--jobs', type=int, default=1)
    options = parser.parse_args()
    seeds, programs, failed = prepare(options.seeds), build(), []

    def run(target):
        begin = time.time()
        count, found = (python(options.seconds) if target == 'python'
                        else fuzz(target, programs, seeds, options.seconds))
        failed.extend([target] if found else [])
        print(f'{target}: {count} inputs in {time.time() - begin:.0f} s, {found or "nothing found"}', flush=True)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(run, options.only.split(',')))
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
