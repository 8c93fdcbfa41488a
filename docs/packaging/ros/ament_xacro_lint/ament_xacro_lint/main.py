"""Run `xacro-lint check` and write its result as ament expects it.

In a test of a Python package: `assert main(argv=[]) == 0`.
"""

import argparse
import fnmatch
import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

MISSING = "the program `xacro-lint` is not on the PATH; type: pip install xacro-lint"
# with errors but without findings: a wrong option, a file or configuration that cannot be read
UNUSABLE = 2


def main(argv=None):
    """Check paths; the exit code is that of xacro-lint."""
    options = parser().parse_args(sys.argv[1:] if argv is None else argv)
    program = find_program()
    if program is None:
        report, code = error(MISSING), 1
    else:
        report, code = check(program, options)
    if options.xunit_file:
        write(report, options)
    print_report(report)
    return code


def parser():
    """The options that linters of ament have."""
    made = argparse.ArgumentParser(
        prog="ament_xacro_lint", description="Check robot descriptions (xacro and URDF) with xacro-lint."
    )
    made.add_argument("paths", nargs="*", default=["."], help="files and folders to check (default: the current folder)")
    made.add_argument("--exclude", metavar="PATTERN", nargs="*", default=[], help="report nothing of these files or folders")
    made.add_argument("--args", metavar="OPTION", nargs=argparse.REMAINDER, default=[], help="options of xacro-lint check")
    made.add_argument("--xunit-file", help="write the result to this file")
    made.add_argument("--testname", default="xacro_lint", help="name of the test in the result")
    return made


def find_program():
    """The program on the PATH, or of the wheel where only Python finds it."""
    found = shutil.which("xacro-lint")
    if found is None:
        try:
            import xacro_lint
        except ImportError:
            return None
        try:
            found = xacro_lint.find_program()
        except FileNotFoundError:
            return None
    return found


def check(program, options):
    """The report of xacro-lint without the excluded files, and the exit code."""
    command = [program, "check", "--format", "junit", *options.args, *options.paths]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", check=False)
    if done.returncode == UNUSABLE:
        return error(done.stderr.strip()), UNUSABLE
    report = ElementTree.fromstring(done.stdout)
    for suite in report.findall("testsuite"):
        if excluded(suite.get("name"), options.exclude):
            report.remove(suite)
    return report, 1 if report.find(".//failure") is not None else 0


def excluded(name, patterns):
    """Whether a file is what a pattern says, or is in a folder that it names."""
    name = os.path.abspath(name)
    for pattern in patterns:
        whole = os.path.abspath(pattern)
        if fnmatch.fnmatch(name, whole) or name.startswith(whole + os.sep) or fnmatch.fnmatch(os.path.basename(name), pattern):
            return True
    return False


def error(message):
    """A report that says why nothing was checked."""
    report = ElementTree.Element("testsuites")
    suite = ElementTree.SubElement(report, "testsuite", name="xacro-lint")
    case = ElementTree.SubElement(suite, "testcase", name="check", classname="xacro-lint")
    ElementTree.SubElement(case, "failure", message=message).text = message
    return report


def write(report, options):
    """One suite of this name, as the other linters write it: readers of ament know no nested suites."""
    whole = ElementTree.Element("testsuite", name=options.testname)
    for case in report.iter("testcase"):
        case.set("classname", f"{options.testname}.{case.get('classname')}")
        whole.append(case)
    if len(whole) == 0:
        ElementTree.SubElement(whole, "testcase", name="no robot descriptions", classname=options.testname)
    failures = len(whole.findall("testcase/failure"))
    for name, value in [("tests", len(whole)), ("failures", failures), ("errors", 0), ("skipped", 0), ("time", 0)]:
        whole.set(name, str(value))
    folder = os.path.dirname(os.path.abspath(options.xunit_file))
    os.makedirs(folder, exist_ok=True)
    ElementTree.ElementTree(whole).write(options.xunit_file, encoding="utf-8", xml_declaration=True)


def print_report(report):
    """The findings, one per line, or that there are none."""
    failures = report.findall(".//failure")
    for failure in failures:
        print(failure.text, file=sys.stderr)
    if not failures:
        print("no findings")


if __name__ == "__main__":
    sys.exit(main())
