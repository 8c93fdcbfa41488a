"""What the invented robots of this test have in common: packages, meshes, inertias and materials."""
import struct

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
HEAD = '<?xml version="1.0"?>\n'


def fill(text, **values):
    """`text` with every `@key@` replaced by its value."""
    for key, value in values.items():
        text = text.replace('@%s@' % key, str(value))
    return text


def package(name, depends=(), folders=('urdf',)):
    """`package.xml` and `CMakeLists.txt` of a description package."""
    lines = ''.join('  <exec_depend>%s</exec_depend>\n' % other for other in ('xacro', *depends))
    manifest = (HEAD + '<package format="3">\n  <name>%s</name>\n  <version>1.0.0</version>\n'
                '  <description>Description of an invented robot</description>\n'
                '  <maintainer email="nobody@example.org">nobody</maintainer>\n  <license>MIT</license>\n'
                '  <buildtool_depend>ament_cmake</buildtool_depend>\n%s'
                '  <export>\n    <build_type>ament_cmake</build_type>\n  </export>\n</package>\n' % (name, lines))
    cmake = ('cmake_minimum_required(VERSION 3.16)\nproject(%s)\nfind_package(ament_cmake REQUIRED)\n'
             'install(DIRECTORY %s DESTINATION share/${PROJECT_NAME})\nament_package()\n' % (name, ' '.join(folders)))
    return {name + '/package.xml': manifest, name + '/CMakeLists.txt': cmake}


def launch(package_name, file, **arguments):
    """A launch file that expands `file` of a package, with values for arguments."""
    given = ''.join("        ' %s:=%s',\n" % pair for pair in sorted(arguments.items()))
    return ("from launch import LaunchDescription\nfrom launch.substitutions import Command, PathJoinSubstitution\n"
            "from launch_ros.actions import Node\nfrom launch_ros.substitutions import FindPackageShare\n\n\n"
            "def generate_launch_description():\n    description = Command([\n        'xacro ',\n"
            "        PathJoinSubstitution([FindPackageShare('%s'), 'urdf', '%s']),\n%s    ])\n"
            "    return LaunchDescription([Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
            "                                   parameters=[{'robot_description': description}])])\n"
            % (package_name, file, given))


def box_mesh(x, y, z):
    """Binary STL of a closed box around the origin, its faces looking outward."""
    corners = [(i * x / 2, j * y / 2, k * z / 2) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [t for a, b, c, d in sides for t in ((a, b, c), (a, c, d))]
    out = b'box'.ljust(80, b' ') + struct.pack('<I', len(triangles))
    for triangle in triangles:
        p, q, r = (corners[i] for i in triangle)
        u, v = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(p, r)]
        normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        length = sum(n * n for n in normal) ** 0.5
        out += struct.pack('<12fH', *(n / length for n in normal), *p, *q, *r, 0)
    return out


def inertial(mass, x, y, z, indent=4):
    """The `inertial` element of a box."""
    space = ' ' * indent
    ixx, iyy, izz = (mass * (a * a + b * b) / 12 for a, b in ((y, z), (x, z), (x, y)))
    return (space + '<inertial>\n%s  <origin xyz="0 0 0" rpy="0 0 0"/>\n%s  <mass value="%s"/>\n'
            '%s  <inertia ixx="%.6g" ixy="0" ixz="0" iyy="%.6g" iyz="0" izz="%.6g"/>\n%s</inertial>\n'
            % (space, space, mass, space, ixx, iyy, izz, space))


# macros that every robot with xacro includes in one form or another
INERTIALS = HEAD + '''<robot @xacro@>
  <!-- Solid bodies; the block is the place of the center of mass -->
  <xacro:macro name="box_inertial" params="mass x y z *origin">
    <inertial>
      <xacro:insert_block name="origin"/>
      <mass value="${mass}"/>
      <inertia ixx="${mass * (y * y + z * z) / 12}" ixy="0.0" ixz="0.0"
               iyy="${mass * (x * x + z * z) / 12}" iyz="0.0"
               izz="${mass * (x * x + y * y) / 12}"/>
    </inertial>
  </xacro:macro>

  <xacro:macro name="cylinder_inertial" params="mass radius length *origin">
    <inertial>
      <xacro:insert_block name="origin"/>
      <mass value="${mass}"/>
      <inertia ixx="${mass * (3 * radius * radius + length * length) / 12}" ixy="0.0" ixz="0.0"
               iyy="${mass * (3 * radius * radius + length * length) / 12}" iyz="0.0"
               izz="${mass * radius * radius / 2}"/>
    </inertial>
  </xacro:macro>

  <xacro:macro name="sphere_inertial" params="mass radius">
    <inertial>
      <mass value="${mass}"/>
      <inertia ixx="${2 * mass * radius * radius / 5}" ixy="0.0" ixz="0.0"
               iyy="${2 * mass * radius * radius / 5}" iyz="0.0" izz="${2 * mass * radius * radius / 5}"/>
    </inertial>
  </xacro:macro>
</robot>
'''.replace('@xacro@', XACRO)

MATERIALS = HEAD + '''<robot @xacro@>
  <material name="slate">
    <color rgba="0.25 0.27 0.30 1.0"/>
  </material>
  <material name="amber">
    <color rgba="0.95 0.62 0.10 1.0"/>
  </material>
  <material name="chalk">
    <color rgba="0.92 0.92 0.90 1.0"/>
  </material>
</robot>
'''.replace('@xacro@', XACRO)
