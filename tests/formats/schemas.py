"""What a report of each format must look like: a list of what is wrong with it."""
import json
import os
import subprocess
import xml.etree.ElementTree as ElementTree

CRATE, VERSION = "serde-sarif", "0.8.0"

# Code quality reports, as the documentation of GitLab CI asks for them.
LINE = {"type": "integer", "minimum": 1}
PLACE = {"type": "object", "required": ["line"], "properties": {"line": LINE, "column": LINE}}
GITLAB = {
    "type": "array",
    "items": {
        "type": "object",
        "required": ["description", "check_name", "fingerprint", "severity", "location"],
        "properties": {
            "description": {"type": "string", "minLength": 1},
            "check_name": {"type": "string", "pattern": "^[a-z0-9-]+$"},
            "fingerprint": {"type": "string", "minLength": 8},
            "severity": {"enum": ["info", "minor", "major", "critical", "blocker"]},
            "location": {
                "type": "object",
                "required": ["path"],
                "properties": {
                    "path": {"type": "string", "not": {"pattern": "^(/|\\./)"}},
                    "lines": {"type": "object", "required": ["begin"], "properties": {"begin": LINE}},
                    "positions": {"type": "object", "required": ["begin"], "properties": {"begin": PLACE, "end": PLACE}},
                },
                "oneOf": [{"required": ["lines"]}, {"required": ["positions"]}],
            },
        },
    },
}

# JUnit reports, as Jenkins reads them: of each element the attributes it must and may have, and its children.
JUNIT = {
    "testsuites": ((), {"name", "tests", "failures", "errors", "time"}, {"testsuite"}),
    "testsuite": (("name",), {"tests", "failures", "errors", "skipped", "time", "timestamp", "file"}, {"testcase", "system-out"}),
    "testcase": (("name", "classname"), {"file", "line", "time"}, {"failure", "error", "skipped", "system-out", "system-err"}),
    "failure": ((), {"message", "type"}, set()),
    "system-out": ((), set(), set()),
}


def sarif_schema(work):
    """The official schema, from the registry's copy of a crate."""
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


def validator(schema):
    """What is wrong with a JSON document, place by place."""
    from jsonschema.validators import validator_for

    checker = validator_for(schema)(schema)
    return lambda document: [
        f"{'.'.join(map(str, error.absolute_path))}: {error.message[:200]}" for error in checker.iter_errors(document)
    ]


def gitlab(document):
    """What is wrong with a code quality report: its form, or fingerprints that are not unique."""
    prints = [entry.get("fingerprint") for entry in document if isinstance(entry, dict)]
    again = sorted({str(one) for one in prints if prints.count(one) > 1})
    return validator(GITLAB)(document) + [f"the fingerprint {one} stands more than once" for one in again]


def junit(text):
    """What is wrong with a JUnit report: its form, or sums that do not hold."""
    root = ElementTree.fromstring(text)
    wrong = [] if root.tag == "testsuites" else [f"the root is {root.tag}"]
    for element in root.iter():
        if element.tag not in JUNIT:
            wrong.append(f"unknown element {element.tag}")
            continue
        must, may, children = JUNIT[element.tag]
        wrong += [f"{element.tag} lacks {name}" for name in must if name not in element.attrib]
        wrong += [f"{element.tag} has {name}" for name in element.attrib if name not in {*must, *may}]
        wrong += [f"{child.tag} in {element.tag}" for child in element if child.tag not in children]
    for suite in [root, *root.iter("testsuite")]:
        for name, path in (("tests", ".//testcase"), ("failures", ".//failure")):
            if suite.get(name) != str(len(suite.findall(path))):
                wrong.append(f"{suite.tag} {suite.get('name')}: {name} is {suite.get(name)}")
    return wrong
