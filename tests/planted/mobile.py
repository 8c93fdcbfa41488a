"""Mobile bases and grippers: property scope, blocks, conditional includes, macros of another package."""
from parts import HEAD, INERTIALS, MATERIALS, XACRO, box_mesh, fill, launch, package


def base(name, wheels, radius, simulation):
    """A base with a wheel macro; the scanner is a macro of another package; Gazebo tags in a file of their own."""
    pkg, parts = name + '_description', name + '_parts'
    scanner = HEAD + fill('''<robot @xacro@>
  <xacro:macro name="scanner" params="parent name:=scanner rate:=10 *origin">
    <joint name="${name}_joint" type="fixed">
      <xacro:insert_block name="origin"/>
      <parent link="${parent}"/>
      <child link="${name}_link"/>
    </joint>
    <link name="${name}_link">
      <visual>
        <geometry>
          <mesh filename="package://@parts@/meshes/scanner.stl"/>
        </geometry>
      </visual>
      <collision>
        <geometry>
          <cylinder radius="0.03" length="0.05"/>
        </geometry>
      </collision>
      <inertial>
        <mass value="0.2"/>
        <inertia ixx="0.000087" ixy="0" ixz="0" iyy="0.000087" iyz="0" izz="0.00009"/>
      </inertial>
    </link>
    <gazebo reference="${name}_link">
      <sensor name="${name}" type="gpu_ray">
        <update_rate>${rate}</update_rate>
      </sensor>
    </gazebo>
  </xacro:macro>

  <!-- Nobody in this workspace calls it -->
  <xacro:macro name="beacon" params="parent height">
    <link name="${parent}_beacon">
      <visual>
        <geometry>
          <sphere radius="${height / 4}"/>
        </geometry>
        <material name="${beacon_color}"/>
      </visual>
    </link>
    <joint name="${parent}_beacon_joint" type="fixed">
      <origin xyz="0 0 ${height}" rpy="0 0 0"/>
      <parent link="${parent}"/>
      <child link="${parent}_beacon"/>
    </joint>
  </xacro:macro>
</robot>
''', xacro=XACRO, parts=parts).replace(' name="${beacon_color}"', ' name="beacon_red"')
    wheel = HEAD + fill('''<robot @xacro@>
  <xacro:include filename="inertials.xacro"/>
  <xacro:property name="wheel_radius" value="@radius@"/>
  <xacro:property name="wheel_width" value="0.04"/>
  <xacro:property name="wheel_mass" value="0.6"/>

  <!-- reflect is 1 (left) or -1 (right) -->
  <xacro:macro name="wheel" params="prefix reflect x">
    <xacro:property name="gap" value="0.01"/>
    <link name="${prefix}_wheel">
      <visual>
        <origin xyz="0 0 0" rpy="${pi / 2} 0 0"/>
        <geometry>
          <cylinder radius="${wheel_radius}" length="${wheel_width}"/>
        </geometry>
        <material name="slate"/>
      </visual>
      <collision>
        <origin xyz="0 0 0" rpy="${pi / 2} 0 0"/>
        <geometry>
          <cylinder radius="${wheel_radius}" length="${wheel_width}"/>
        </geometry>
      </collision>
      <xacro:cylinder_inertial mass="${wheel_mass}" radius="${wheel_radius}" length="${wheel_width}">
        <origin xyz="0 0 0" rpy="${pi / 2} 0 0"/>
      </xacro:cylinder_inertial>
    </link>
    <joint name="${prefix}_wheel_joint" type="continuous">
      <origin xyz="${x} ${reflect * (body_width / 2 + wheel_width / 2 + gap)} 0" rpy="0 0 0"/>
      <parent link="base_link"/>
      <child link="${prefix}_wheel"/>
      <axis xyz="0 1 0"/>
      <limit effort="12" velocity="25"/>
    </joint>
  </xacro:macro>
</robot>
''', xacro=XACRO, radius=radius)
    places = [('front_left', 1, '${body_length / 3}'), ('front_right', -1, '${body_length / 3}'),
              ('rear_left', 1, '${-body_length / 3}'), ('rear_right', -1, '${-body_length / 3}')]
    places = places if wheels == 4 else [('left', 1, '0.0'), ('right', -1, '0.0')]
    calls = ''.join('  <xacro:wheel prefix="%s" reflect="%d" x="%s"/>\n' % place for place in places)
    gazebo = HEAD + fill('''<robot @xacro@>
  <gazebo reference="base_link">
    <material>Gazebo/Orange</material>
  </gazebo>
@frictions@
  <gazebo>
    <plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">
      <left_joint>@left@_wheel_joint</left_joint>
      <right_joint>@right@_wheel_joint</right_joint>
      <wheel_radius>${wheel_radius}</wheel_radius>
    </plugin>
  </gazebo>
</robot>
''', xacro=XACRO, left=places[0][0], right=places[1][0],
                       frictions=''.join('  <gazebo reference="%s_wheel">\n    <mu1>0.9</mu1>\n    <mu2>0.9</mu2>\n  </gazebo>\n'
                                         % place[0] for place in places))
    root = HEAD + fill('''<robot name="@name@" @xacro@>
  <xacro:arg name="simulated" default="@simulated@"/>
  <xacro:arg name="scanner" default="true"/>
  <xacro:property name="body_length" value="0.6"/>
  <xacro:property name="body_width" value="0.4"/>
  <xacro:property name="body_height" value="0.18"/>
  <xacro:include filename="$(find @pkg@)/urdf/materials.xacro"/>
  <xacro:include filename="$(find @pkg@)/urdf/wheel.xacro"/>

  <link name="base_footprint"/>
  <joint name="base_joint" type="fixed">
    <origin xyz="0 0 ${wheel_radius}" rpy="0 0 0"/>
    <parent link="base_footprint"/>
    <child link="base_link"/>
  </joint>
  <link name="base_link">
    <visual>
      <geometry>
        <box size="${body_length} ${body_width} ${body_height}"/>
      </geometry>
      <material name="amber"/>
    </visual>
    <collision>
      <geometry>
        <box size="${body_length} ${body_width} ${body_height}"/>
      </geometry>
    </collision>
    <xacro:box_inertial mass="14.5" x="${body_length}" y="${body_width}" z="${body_height}">
      <origin xyz="0 0 0" rpy="0 0 0"/>
    </xacro:box_inertial>
  </link>

@calls@
  <xacro:if value="$(arg scanner)">
    <xacro:include filename="$(find @parts@)/urdf/scanner.xacro"/>
    <xacro:scanner parent="base_link" rate="15">
      <origin xyz="${body_length / 2 - 0.05} 0 ${body_height / 2 + 0.025}" rpy="0 0 0"/>
    </xacro:scanner>
  </xacro:if>

  <xacro:if value="$(arg simulated)">
    <xacro:include filename="@name@.gazebo.xacro"/>
  </xacro:if>
</robot>
''', xacro=XACRO, name=name, pkg=pkg, parts=parts, calls=calls, simulated=simulation)
    files = package(pkg, depends=(parts,), folders=('launch', 'urdf'))
    files.update(package(parts, folders=('meshes', 'urdf')))
    files.update({pkg + '/urdf/%s.urdf.xacro' % name: root, pkg + '/urdf/wheel.xacro': wheel,
                  pkg + '/urdf/inertials.xacro': INERTIALS, pkg + '/urdf/materials.xacro': MATERIALS,
                  pkg + '/urdf/%s.gazebo.xacro' % name: gazebo, parts + '/urdf/scanner.xacro': scanner,
                  parts + '/meshes/scanner.stl': box_mesh(0.05, 0.05, 0.05),
                  pkg + '/launch/spawn.launch.py': launch(pkg, name + '.urdf.xacro', simulated='true')})
    return files


def gripper(name, opening, blocks):
    """Fingers from blocks, the second follows the first; the limits come from a property dictionary."""
    pkg = name + '_description'
    macro = HEAD + fill('''<robot @xacro@>
  <xacro:include filename="inertials.xacro"/>
  <xacro:property name="jaw" value="${dict(lower=0.0, upper=@opening@, effort=40.0, velocity=0.15)}"/>
  <xacro:property name="pad">
    <geometry>
      <box size="0.02 0.012 0.06"/>
    </geometry>
  </xacro:property>

  <xacro:macro name="finger" params="name palm *origin **rest">
    <link name="${name}">
      <visual>
        <origin xyz="0 0 0.03" rpy="0 0 0"/>
        <xacro:insert_block name="pad"/>
        <material name="chalk"/>
      </visual>
      <collision>
        <origin xyz="0 0 0.03" rpy="0 0 0"/>
        <xacro:insert_block name="pad"/>
      </collision>
      <xacro:box_inertial mass="0.05" x="0.02" y="0.012" z="0.06">
        <origin xyz="0 0 0.03" rpy="0 0 0"/>
      </xacro:box_inertial>
    </link>
    <joint name="${name}_joint" type="prismatic">
      <xacro:insert_block name="origin"/>
      <parent link="${palm}"/>
      <child link="${name}"/>
      <axis xyz="0 1 0"/>
      <limit lower="${jaw['lower']}" upper="${jaw['upper']}" effort="${jaw['effort']}" velocity="${jaw['velocity']}"/>
      <xacro:insert_block name="rest"/>
    </joint>
  </xacro:macro>

  <xacro:macro name="@name@" params="prefix:='' parent:=^|world *origin">
    <joint name="${prefix}palm_joint" type="fixed">
      <xacro:insert_block name="origin"/>
      <parent link="${parent}"/>
      <child link="${prefix}palm"/>
    </joint>
    <link name="${prefix}palm">
      <visual>
        <origin xyz="0 0 0.02" rpy="0 0 0"/>
        <geometry>
          <mesh filename="package://@pkg@/meshes/palm.stl"/>
        </geometry>
        <material name="slate"/>
      </visual>
      <collision>
        <origin xyz="0 0 0.02" rpy="0 0 0"/>
        <geometry>
          <box size="0.05 0.11 0.04"/>
        </geometry>
      </collision>
      <xacro:box_inertial mass="0.45" x="0.05" y="0.11" z="0.04">
        <origin xyz="0 0 0.02" rpy="0 0 0"/>
      </xacro:box_inertial>
    </link>
    <xacro:finger name="${prefix}left_finger" palm="${prefix}palm">
      <origin xyz="0 0.006 0.04" rpy="0 0 0"/>
      <rest>
        <dynamics damping="2.0" friction="0.5"/>
      </rest>
    </xacro:finger>
    <xacro:finger name="${prefix}right_finger" palm="${prefix}palm">
      <origin xyz="0 -0.006 0.04" rpy="0 0 ${pi}"/>
      <rest>
        <dynamics damping="2.0" friction="0.5"/>
        <mimic joint="${prefix}left_finger_joint" multiplier="1" offset="0"/>
      </rest>
    </xacro:finger>
  </xacro:macro>
</robot>
''', xacro=XACRO, name=name, pkg=pkg, opening=opening)
    root = HEAD + fill('''<robot name="@name@" @xacro@>
  <xacro:include filename="$(find @pkg@)/urdf/materials.xacro"/>
  <xacro:include filename="$(find @pkg@)/urdf/@name@_macro.xacro"/>

  <link name="world"/>
  <link name="stand"/>
  <joint name="stand_joint" type="fixed">
    <origin xyz="0 0 0.5" rpy="0 0 0"/>
    <parent link="world"/>
    <child link="stand"/>
  </joint>
@calls@
  <ros2_control name="@name@" type="actuator">
    <hardware>
      <plugin>mock_components/GenericSystem</plugin>
      <param name="calculate_dynamics">true</param>
    </hardware>
    <joint name="@prefix@left_finger_joint">
      <command_interface name="position">
        <param name="min">0.0</param>
        <param name="max">@opening@</param>
      </command_interface>
      <state_interface name="position"/>
      <state_interface name="velocity"/>
    </joint>
  </ros2_control>
</robot>
''', xacro=XACRO, name=name, pkg=pkg, opening=opening, prefix='a_' if blocks else '', calls=''.join(
        '  <xacro:%s prefix="%s" parent="stand">\n    <origin xyz="%s 0 0" rpy="0 ${pi / 2} 0"/>\n  </xacro:%s>\n'
        % (name, prefix, x, name) for prefix, x in ((('a_', '0.1'), ('b_', '-0.1')) if blocks else (('', '0.0'),))))
    files = package(pkg, folders=('meshes', 'urdf'))
    files.update({pkg + '/urdf/%s.urdf.xacro' % name: root, pkg + '/urdf/%s_macro.xacro' % name: macro,
                  pkg + '/urdf/inertials.xacro': INERTIALS, pkg + '/urdf/materials.xacro': MATERIALS,
                  pkg + '/meshes/palm.stl': box_mesh(0.05, 0.11, 0.04)})
    return files
