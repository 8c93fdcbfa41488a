"""The recipe of docs/ci.md, with colcon and pytest themselves."""

import xml.etree.ElementTree

from common import RELEASE, demand, fresh, run, snippet, tool, with_tools
from fixture import BROKEN_MAST, LIFTER, MAST, PACKAGE


def workspace():
    """`colcon test` fails on a broken robot, and passes when it is fixed."""
    recipe = snippet("ci.md", "colcon")
    folder = fresh("workspace")
    package = folder / "src/lifter_description"
    (package / "urdf").mkdir(parents=True)
    (package / "package.xml").write_text(PACKAGE)
    (package / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.16)\nproject(lifter_description NONE)\n{recipe}"
    )
    (package / "urdf/lifter.urdf.xacro").write_text(LIFTER)
    variables = {"PATH": with_tools(RELEASE), "COLCON_LOG_PATH": folder / "log", "COLCON_DEFAULTS_FILE": folder / "none"}
    colcon = tool("colcon")
    for mast, code, failures in [(BROKEN_MAST, 1, "1 failure"), (MAST, 0, "0 failures")]:
        (package / "urdf/mast.xacro").write_text(mast)
        run([colcon, "build"], cwd=folder, **variables)
        run([colcon, "test", "--return-code-on-test-failure"], cwd=folder, code=code, **variables)
        printed = run([colcon, "test-result", "--all"], cwd=folder, code=code, **variables)
        demand(f"Summary: 1 test, 0 errors, {failures}, 0 skipped" in printed, printed)


def pytest():
    """The test for Python packages: it fails, passes, and is skipped where the program is missing."""
    recipe = snippet("ci.md", "pytest")
    package = fresh("pytest")
    for name in ("urdf", "test"):
        (package / name).mkdir()
    (package / "package.xml").write_text(PACKAGE)
    (package / "test/test_robot_descriptions.py").write_text(recipe)
    (package / "urdf/lifter.urdf.xacro").write_text(LIFTER)
    for mast, path, code, expected in [
        (BROKEN_MAST, with_tools(RELEASE), 1, {"failures": "1", "skipped": "0"}),
        (MAST, with_tools(RELEASE), 0, {"failures": "0", "skipped": "0"}),
        (BROKEN_MAST, "/usr/bin:/bin", 0, {"failures": "0", "skipped": "1"}),
    ]:
        (package / "urdf/mast.xacro").write_text(mast)
        command = [tool("python"), "-m", "pytest", "-q", "-p", "no:cacheprovider", "--junitxml", package / "result.xml"]
        printed = run(command, cwd=package, code=code, PATH=path)
        suite = xml.etree.ElementTree.parse(package / "result.xml").getroot()[0]
        demand({name: suite.get(name) for name in expected} == expected, printed)
