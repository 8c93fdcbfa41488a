"""The packages for ROS, built and tested with the real ament and colcon, by a robot package that uses them."""

import os
import shutil

from common import EXAMPLES, RELEASE, ROOT, WORK, demand, fresh, run, tool, with_tools

PACKAGES = ROOT / "docs/packaging/ros"
# of Debian trixie, where the system's Debian has none
AMENT = ["ament-cmake", "ament-cmake-core", "ament-cmake-python", "ament-lint", "python3-ament-cmake-test", "python3-ament-package"]

DEPENDS = """  <test_depend>ament_lint_auto</test_depend>
  <test_depend>ament_cmake_xacro_lint</test_depend>
"""
TESTS = """if(BUILD_TESTING)
  find_package(ament_lint_auto REQUIRED)
  ament_lint_auto_find_test_dependencies()
endif()
"""

# a joint to a link that does not exist
RIGHT, WRONG = 'parallel_gripper parent="forearm"', 'parallel_gripper parent="forarm"'
DEFECT = "joint `palm_joint` has undefined parent link `forarm`"


def packages():
    """`colcon test` fails on a seeded defect and where the program is missing, and passes without."""
    ament = ament_root()
    folder = fresh("ros")
    for name in ("ament_xacro_lint", "ament_cmake_xacro_lint"):
        shutil.copytree(PACKAGES / name, folder / "src" / name, ignore=shutil.ignore_patterns("__pycache__"))
    package = folder / "src/two_joint_gripper_description"
    shutil.copytree(EXAMPLES / "two_joint_gripper/src/two_joint_gripper_description", package)
    insert(package / "package.xml", "  <export>", DEPENDS)
    insert(package / "CMakeLists.txt", "ament_package()", TESTS)
    robot = Robot(folder, package, ament)
    robot.build("--packages-up-to", package.name)
    robot.expect(None)

    description = package / "urdf/two_joint_gripper.urdf.xacro"
    right = description.read_text()
    demand(RIGHT in right, f"{description.name} has {RIGHT}")
    description.write_text(right.replace(RIGHT, WRONG))
    robot.expect(DEFECT)
    # the variable that all linters of ament read
    insert(package / "CMakeLists.txt", "if(BUILD_TESTING)", "set(AMENT_LINT_AUTO_FILE_EXCLUDE urdf)\n")
    robot.build("--packages-select", package.name)
    robot.expect(None)

    description.write_text(right)
    robot.path = os.pathsep.join([str(WORK / "tools/bin"), "/usr/bin", "/bin"])
    robot.expect("the program `xacro-lint` is not on the PATH; type: pip install xacro-lint")
    python_tests(folder)


def insert(file, before, text):
    """Text before a line of a file."""
    old = file.read_text()
    demand(old.count(f"\n{before}") == 1, f"{file.name} has {before}")
    file.write_text(old.replace(f"\n{before}", f"\n{text}{before}"))


def ament_root():
    """The folder with ament, and everything that it wants to be told."""
    installed = WORK / "ament"
    run([ROOT / "tests/editors/install.sh", "scripts", "trixie", installed, *AMENT])
    return installed / "root/usr"


class Robot:
    """A workspace in which one package is tested again and again."""

    def __init__(self, folder, package, ament):
        self.folder, self.package = folder, package
        self.path = with_tools(RELEASE)
        self.variables = {
            "CMAKE_PREFIX_PATH": ament, "AMENT_PREFIX_PATH": ament, "PYTHONPATH": ament / "lib/python3/dist-packages",
            "VIRTUAL_ENV": WORK / "tools", "COLCON_LOG_PATH": folder / "log", "COLCON_DEFAULTS_FILE": folder / "none",
            "PYTHONDONTWRITEBYTECODE": "1", "PYTHONWARNINGS": "ignore",
        }

    def colcon(self, *arguments, code=0):
        return run([tool("colcon"), *arguments], cwd=self.folder, code=code, PATH=self.path, **self.variables)

    def build(self, *selection):
        self.colcon("build", *selection, "--event-handlers", "console_cohesion+")

    def expect(self, finding):
        """The result of `colcon test`: it passes, or fails with this finding."""
        code = 0 if finding is None else 1
        shutil.rmtree(self.folder / "build" / self.package.name / "test_results", ignore_errors=True)
        self.colcon("test", "--packages-select", self.package.name, "--return-code-on-test-failure", code=code)
        printed = self.colcon("test-result", "--verbose", "--test-result-base", f"build/{self.package.name}", code=code)
        demand(finding is None or finding in printed, printed)
        results = list(self.folder.glob(f"build/{self.package.name}/test_results/*/xacro_lint.xunit.xml"))
        demand(len(results) == 1, f"one result: {results}")


def python_tests(folder):
    """The tests of the Python package itself."""
    package = folder / "src/ament_xacro_lint"
    command = [tool("python"), "-m", "pytest", "-q", "-p", "no:cacheprovider", "test"]
    run(command, cwd=package, PATH=with_tools(RELEASE), PYTHONPATH=package)
