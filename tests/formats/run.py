#!/usr/bin/env python3
"""Reports against what their readers demand, and completion in the shells.

    run.py --bin PROGRAM [--work FOLDER] [--robots FOLDER]

The bad examples of docs/rules/, and the robots below --robots, are checked with every rule. SARIF is validated with the
official schema, JUnit and GitLab reports with what Jenkins and GitLab read; documents with planted mistakes have to be
refused. Completion is asked for in bash, fish and zsh. Installs jsonschema into a virtual environment below FOLDER
(target/tmp/formats); needs cargo, python3 and the shells.
"""
import argparse
import copy
import json
import os
import subprocess
import sys

import completions
import examples
import schemas


def with_jsonschema(work):
    """Start again in a virtual environment that has jsonschema."""
    python = os.path.join(work, "venv", "bin", "python")
    if not os.path.exists(python):
        subprocess.run([sys.executable, "-m", "venv", os.path.join(work, "venv")], check=True)
    subprocess.run([python, "-m", "pip", "install", "--quiet", "jsonschema==4.25.1"], check=True)
    os.execv(python, [python, os.path.abspath(__file__), *sys.argv[1:], "--installed"])


def report(program, folder, form):
    """What the program prints about a folder, with every rule."""
    command = [program, "check", "--format", form, "--select", "ALL", "--show", "all", "--exit-zero", "."]
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if ran.returncode != 0:
        sys.exit(f"{form} in {folder}: exit code {ran.returncode}: {ran.stderr}")
    return ran.stdout


def spoilt(document, edits):
    """The document with one mistake each."""
    for path, value in edits:
        broken = copy.deepcopy(document)
        place = broken
        for key in path[:-1]:
            place = place[key]
        place[path[-1]] = value
        yield ".".join(map(str, path)), broken


SARIF_MISTAKES = [
    (("runs", 0, "results", 0, "level"), "bad"),
    (("version",), "2.0.0"),
    (("runs",), None),
    (("runs", 0, "results", 0, "locations", 0, "physicalLocation", "region", "startLine"), 0),
]
GITLAB_MISTAKES = [
    ((0, "severity"), "warning"),
    ((0, "location", "path"), "/robot.urdf"),
    ((0, "location", "positions", "begin", "line"), 0),
    ((0, "fingerprint"), None),
]


def judged(program, folder, sarif):
    """What is wrong with the reports about a folder, and the SARIF and GitLab documents."""
    documents = {form: json.loads(report(program, folder, form)) for form in ("sarif", "gitlab")}
    wrong = [f"sarif: {one}" for one in sarif(documents["sarif"])]
    wrong += [f"gitlab: {one}" for one in schemas.gitlab(documents["gitlab"])]
    wrong += [f"junit: {one}" for one in schemas.junit(report(program, folder, "junit"))]
    return wrong, documents


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", required=True)
    parser.add_argument("--work", default=os.path.join(examples.TOP, "target", "tmp", "formats"))
    parser.add_argument("--robots")
    parser.add_argument("--installed", action="store_true")
    args = parser.parse_args()
    os.makedirs(args.work, exist_ok=True)
    if not args.installed:
        with_jsonschema(args.work)
    program = os.path.abspath(args.bin)
    sarif = schemas.validator(schemas.sarif_schema(args.work))
    folder = os.path.join(args.work, "examples")
    subprocess.run(["rm", "-rf", folder], check=True)
    os.makedirs(folder)
    blocks = examples.write(folder)
    wrong, documents = judged(program, folder, sarif)
    for form, mistakes, check in (("sarif", SARIF_MISTAKES, sarif), ("gitlab", GITLAB_MISTAKES, schemas.gitlab)):
        unseen = (place for place, broken in spoilt(documents[form], mistakes) if not check(broken))
        wrong += [f"{form}: a mistake in {place} is not seen" for place in unseen]
    if args.robots:
        wrong += judged(program, args.robots, sarif)[0]
    results = documents["sarif"]["runs"][0]["results"]
    rules = {result["ruleId"] for result in results}
    if len(rules) < 100:
        wrong.append(f"only {len(rules)} rules have results: the examples are not checked as they should be")
    wrong += completions.check(program, os.path.join(args.work, "completions"))
    for one in wrong:
        print(one)
    print(f"{blocks} examples, {len(results)} results of {len(rules)} rules, {len(wrong)} problems")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
