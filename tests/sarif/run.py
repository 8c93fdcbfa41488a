#!/usr/bin/env python3
"""SARIF output against the official schema.

    run.py --bin PROGRAM [--work FOLDER]

The bad examples of docs/rules/ are written to files and checked with every rule, and the document is validated
with the schema that the crate serde-sarif carries. Documents with planted mistakes have to be refused.
Installs jsonschema into a virtual environment below FOLDER (target/tmp/sarif); needs cargo and python3.
"""
import argparse
import copy
import glob
import json
import os
import subprocess
import sys

CRATE, VERSION = "serde-sarif", "0.8.0"
HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(os.path.dirname(HERE))


def with_jsonschema(work):
    """Start again in a virtual environment that has jsonschema."""
    python = os.path.join(work, "venv", "bin", "python")
    if not os.path.exists(python):
        subprocess.run([sys.executable, "-m", "venv", os.path.join(work, "venv")], check=True)
    subprocess.run([python, "-m", "pip", "install", "--quiet", "jsonschema==4.25.1"], check=True)
    os.execv(python, [python, os.path.abspath(__file__), *sys.argv[1:], "--installed"])


def schema(work):
    """The schema, from the registry's copy of the crate."""
    project = os.path.join(work, "schema")
    os.makedirs(os.path.join(project, "src"), exist_ok=True)
    with open(os.path.join(project, "Cargo.toml"), "w") as file:
        file.write('[package]\nname = "schema"\nversion = "0.0.0"\nedition = "2021"\n[workspace]\n')
        file.write(f'[dependencies]\n{CRATE} = "={VERSION}"\n')
    open(os.path.join(project, "src", "lib.rs"), "w").close()
    command = ["cargo", "metadata", "--format-version", "1", "--manifest-path", os.path.join(project, "Cargo.toml")]
    packages = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["packages"]
    folder = next(os.path.dirname(p["manifest_path"]) for p in packages if p["name"] == CRATE)
    with open(os.path.join(folder, "src", "schema.json")) as file:
        return json.load(file)


def examples(folder):
    """Write the bad blocks of the pages to files."""
    count = 0
    for page in sorted(glob.glob(os.path.join(TOP, "docs", "rules", "*.md"))):
        name, file = os.path.splitext(os.path.basename(page))[0], None
        for line in open(page, encoding="utf-8"):
            if line.startswith("```"):
                kind, _, verdict = line[3:].strip().partition(",")
                if file:
                    file.close()
                file = None
                if verdict == "bad" and kind in ("urdf", "xacro"):
                    count += 1
                    file = open(os.path.join(folder, f"{name}_{count}.{kind}"), "w", encoding="utf-8")
            elif file and line.startswith("//- "):
                path = os.path.join(folder, f"{name}_{count}", line[4:].strip())
                os.makedirs(os.path.dirname(path), exist_ok=True)
                file.close()
                file = open(path, "w", encoding="utf-8")
            elif file and not ("^" in line and set(line.strip()) <= {" ", "^"}):
                file.write(line)
    return count


def spoilt(document):
    """Documents that the schema forbids."""
    for path, value in [(("runs", 0, "results", 0, "level"), "bad"), (("version",), "2.0.0"), (("runs",), None),
                        (("runs", 0, "results", 0, "locations", 0, "physicalLocation", "region", "startLine"), 0)]:
        broken = copy.deepcopy(document)
        place = broken
        for key in path[:-1]:
            place = place[key]
        place[path[-1]] = value
        yield ".".join(map(str, path)), broken


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--bin", required=True)
    parser.add_argument("--work", default=os.path.join(TOP, "target", "tmp", "sarif"))
    parser.add_argument("--installed", action="store_true")
    args = parser.parse_args()
    os.makedirs(args.work, exist_ok=True)
    if not args.installed:
        with_jsonschema(args.work)
    from jsonschema.validators import validator_for

    official = schema(args.work)
    validator = validator_for(official)(official)
    folder = os.path.join(args.work, "examples")
    subprocess.run(["rm", "-rf", folder], check=True)
    os.makedirs(folder)
    blocks = examples(folder)
    command = [os.path.abspath(args.bin), "check", "--format", "sarif", "--select", "ALL", "--exit-zero", "."]
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    if ran.returncode != 0:
        sys.exit(f"exit code {ran.returncode}: {ran.stderr}")
    document = json.loads(ran.stdout)
    failed = 0
    for error in validator.iter_errors(document):
        failed += 1
        print(f"refused: {'.'.join(map(str, error.absolute_path))}: {error.message[:200]}")
    for place, broken in spoilt(document):
        if not list(validator.iter_errors(broken)):
            failed += 1
            print(f"the schema does not see a mistake in {place}")
    results = document["runs"][0]["results"]
    rules = {result["ruleId"] for result in results}
    if len(rules) < 100:
        failed += 1
        print(f"only {len(rules)} rules have results: the examples are not checked as they should be")
    print(f"{blocks} examples, {len(results)} results of {len(rules)} rules, {failed} problems")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
