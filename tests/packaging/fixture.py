"""A repository with two robots over one macro file, and its defects."""

from common import fresh, run

HEAD = '<?xml version="1.0"?>\n<robot{} xmlns:xacro="http://www.ros.org/wiki/xacro">\n'

PACKAGE = """<?xml version="1.0"?>
<package format="3">
  <name>lifter_description</name>
  <version>1.0.0</version>
  <description>Robots with a mast</description>
  <maintainer email="nobody@example.org">Nobody</maintainer>
  <license>MIT</license>
  <buildtool_depend>cmake</buildtool_depend>
  <export>
    <build_type>cmake</build_type>
  </export>
</package>
"""

MAST = (
    HEAD.format("")
    + """  <xacro:macro name="mast" params="parent height">
    <link name="mast"/>
    <joint name="mast_joint" type="fixed">
      <parent link="${parent}"/>
      <child link="mast"/>
      <origin xyz="0 0 ${height}"/>
    </joint>
  </xacro:macro>
</robot>
"""
)

LIFTER = (
    HEAD.format(' name="lifter"')
    + """  <xacro:include filename="$(find lifter_description)/urdf/mast.xacro"/>
  <link name="base_link"/>
  <xacro:mast parent="base_link" height="0.5"/>
</robot>
"""
)

# a defect that has nothing to do with the mast
CART = HEAD.format(' name="cart"') + '  <link name="base_link"/>\n  <link name="tray"/>\n</robot>\n'

# the parameter is misspelled where it is used
BROKEN_MAST = MAST.replace("${height}", "${hight}")
# a comment that hides nothing, which a safe fix deletes
FIXABLE = LIFTER.replace("  <link", "  <!-- xacro-lint: disable-next-line orphan-link: joined below -->\n  <link")
CROOKED = LIFTER.replace("  <link", "     <link")


class Repository:
    """A git repository in a folder of its own."""

    def __init__(self, name, files):
        self.folder = fresh(name)
        self.git("init", "--quiet", "--initial-branch=main")
        self.write("package.xml", PACKAGE)
        self.write("urdf/mast.xacro", MAST)
        self.write("urdf/lifter.urdf.xacro", LIFTER)
        self.write("urdf/cart.urdf.xacro", CART)
        for path, text in files.items():
            self.write(path, text)
        self.git("add", ".")
        self.commit("Robots", "--no-verify")

    def write(self, path, text):
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def read(self, path):
        return (self.folder / path).read_text()

    def git(self, *arguments, code=0, **variables):
        return run(["git", *arguments], cwd=self.folder, code=code, **variables)

    def commit(self, message, *options, code=0, **variables):
        """Commit what is staged, by nobody in particular."""
        person = [f"GIT_{role}_{part}" for role in ("AUTHOR", "COMMITTER") for part in ("NAME", "EMAIL")]
        named = dict.fromkeys(person, "nobody@example.org")
        return self.git("commit", "--quiet", "--message", message, *options, code=code, **named, **variables)
