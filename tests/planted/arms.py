"""Arms: a macro file and a thin top-level file, limits in YAML, a plain URDF, a cell of three packages."""
from parts import HEAD, INERTIALS, MATERIALS, XACRO, box_mesh, fill, inertial, launch, package


def arm(name, joints, reach, control, computed=False):
    """A support package: macro with prefix and block, a thin top-level file, perhaps ros2_control or a computed include."""
    pkg = name + '_support'
    length = round(reach / joints, 3)
    links = ''.join(fill('''
    <link name="${prefix}link_@i@">
      <xacro:segment file="link" length="${segment_length}" color="@color@"/>
      <xacro:box_inertial mass="@mass@" x="0.06" y="0.06" z="${segment_length}">
        <origin xyz="0 0 ${segment_length / 2}" rpy="0 0 0"/>
      </xacro:box_inertial>
    </link>
    <joint name="${prefix}joint_@i@" type="revolute">
      <origin xyz="0 0 @z@" rpy="0 0 0"/>
      <parent link="${prefix}@parent@"/>
      <child link="${prefix}link_@i@"/>
      <axis xyz="@axis@"/>
      <limit lower="${-@range@}" upper="${@range@}" effort="@effort@" velocity="${radians(@speed@)}"/>
      <dynamics damping="0.4" friction="0.1"/>
    </joint>''', i=i, color=('slate', 'amber')[i % 2], mass=round(2.4 - 0.2 * i, 2), axis=('0 0 1', '0 1 0')[i % 2 == 0],
                         parent='base_link' if i == 1 else 'link_%d' % (i - 1), range=('pi / 2', '2.4', 'radians(110)')[i % 3],
                         z='${base_height}' if i == 1 else '${segment_length}', effort=120 - 15 * i, speed=150 + 5 * i)
                    for i in range(1, joints + 1))
    macro = HEAD + fill('''<robot @xacro@>
  <xacro:include filename="$(find @pkg@)/urdf/@name@_common.xacro"/>

  <!-- One segment of the arm: a visual and a collision of the same length -->
  <xacro:macro name="segment" params="file length color:=slate">
    <visual>
      <origin xyz="0 0 ${length / 2}" rpy="0 0 0"/>
      <geometry>
        <mesh filename="package://@pkg@/meshes/${file}.stl"/>
      </geometry>
      <material name="${color}"/>
    </visual>
    <collision>
      <origin xyz="0 0 ${length / 2}" rpy="0 0 0"/>
      <geometry>
        <box size="0.06 0.06 ${length}"/>
      </geometry>
    </collision>
  </xacro:macro>

  <!-- The arm; the block is its place on `parent` -->
  <xacro:macro name="@name@" params="prefix parent *origin base_height:=0.12">
    <xacro:property name="segment_length" value="@length@"/>
    <joint name="${prefix}base_joint" type="fixed">
      <xacro:insert_block name="origin"/>
      <parent link="${parent}"/>
      <child link="${prefix}base_link"/>
    </joint>
    <link name="${prefix}base_link">
      <visual>
        <origin xyz="0 0 ${base_height / 2}" rpy="0 0 0"/>
        <geometry>
          <cylinder radius="0.08" length="${base_height}"/>
        </geometry>
        <material name="chalk"/>
      </visual>
      <collision>
        <origin xyz="0 0 ${base_height / 2}" rpy="0 0 0"/>
        <geometry>
          <cylinder radius="0.08" length="${base_height}"/>
        </geometry>
      </collision>
      <xacro:cylinder_inertial mass="5.5" radius="0.08" length="${base_height}">
        <origin xyz="0 0 ${base_height / 2}" rpy="0 0 0"/>
      </xacro:cylinder_inertial>
    </link>@links@
    <link name="${prefix}tool0"/>
    <joint name="${prefix}tool0_joint" type="fixed">
      <origin xyz="0 0 ${segment_length}" rpy="0 0 0"/>
      <parent link="${prefix}link_@last@"/>
      <child link="${prefix}tool0"/>
    </joint>
  </xacro:macro>
</robot>
''', xacro=XACRO, pkg=pkg, name=name, links=links, length=length, last=joints)
    common = INERTIALS.replace('</robot>', MATERIALS[MATERIALS.index('  <material'):])
    drive = HEAD + fill('''<robot @xacro@>
  <xacro:macro name="driven_joint" params="name start:=0.0">
    <joint name="${name}">
      <command_interface name="position"/>
      <state_interface name="position">
        <param name="initial_value">${start}</param>
      </state_interface>
      <state_interface name="velocity"/>
    </joint>
  </xacro:macro>

  <xacro:macro name="@name@_control" params="prefix simulated">
    <ros2_control name="${prefix}@name@" type="system">
      <hardware>
        <xacro:if value="${simulated}">
          <plugin>gz_ros2_control/GazeboSimSystem</plugin>
        </xacro:if>
        <xacro:unless value="${simulated}">
          <plugin>mock_components/GenericSystem</plugin>
        </xacro:unless>
      </hardware>
@driven@    </ros2_control>
  </xacro:macro>
</robot>
''', xacro=XACRO, name=name, driven=''.join('      <xacro:driven_joint name="${prefix}joint_%d"/>\n' % i
                                            for i in range(1, joints + 1)))
    root = HEAD + fill('''<robot name="@name@" @xacro@>
  <xacro:arg name="prefix" default=""/>
  <xacro:arg name="simulated" default="false"/>
  <xacro:arg name="mount_height" default="0.0"/>
  <xacro:include filename="$(find @pkg@)/urdf/@name@_macro.xacro"/>
@include@
  <link name="world"/>
  <xacro:@name@ prefix="$(arg prefix)" parent="world">
    <origin xyz="0 0 $(arg mount_height)" rpy="0 0 0"/>
  </xacro:@name@>
@call@</robot>
''', xacro=XACRO, name=name, pkg=pkg,
                       include='  <xacro:include filename="%s_control.xacro"/>\n' % name if control else '',
                       call='  <xacro:%s_control prefix="$(arg prefix)" simulated="$(arg simulated)"/>\n' % name
                       if control else '')
    if computed:
        root = root.replace('  <xacro:include', '  <xacro:arg name="model" default="%s"/>\n  <xacro:include' % name, 1)
        root = root.replace('/urdf/%s_macro.xacro' % name, '/urdf/$(arg model)_macro.xacro')
    if not control:
        root = root.replace('  <xacro:arg name="simulated" default="false"/>\n', '')
    files = package(pkg, folders=('launch', 'meshes', 'urdf'))
    files.update({pkg + '/urdf/%s_macro.xacro' % name: macro, pkg + '/urdf/%s_common.xacro' % name: common,
                  pkg + '/urdf/%s.urdf.xacro' % name: root, pkg + '/meshes/link.stl': box_mesh(0.06, 0.06, length),
                  pkg + '/launch/view.launch.py': launch(pkg, name + '.urdf.xacro', prefix='left_')})
    if control:
        files[pkg + '/urdf/%s_control.xacro' % name] = drive
    return files


def yaml_arm(name, parts, package_path):
    """Links and joints from YAML tables, made by recursion; the file names start with an argument."""
    pkg = name + '_description'
    rows = ''.join('  - name: %s\n    parent: %s\n    length: %s\n    mass: %s\n    lower: %s\n    upper: %s\n    effort: %s\n'
                   '    velocity: %s\n' % (part, 'base_link' if i == 0 else parts[i - 1], round(0.3 - 0.03 * i, 3),
                                           round(3.0 - 0.4 * i, 2), -2.2 + 0.1 * i, 2.0 - 0.1 * i, 90 - 10 * i, 2.5)
                   for i, part in enumerate(parts))
    table = 'thickness: 0.05\nparts:\n' + rows
    macros = HEAD + fill('''<robot @xacro@>
  <xacro:include filename="inertials.xacro"/>

  <xacro:macro name="part" params="row parent_length">
    <xacro:property name="thickness" value="${table['thickness']}"/>
    <link name="${row['name']}">
      <visual>
        <origin xyz="0 0 ${row['length'] / 2}" rpy="0 0 0"/>
        <geometry>
          <box size="${thickness} ${thickness} ${row['length']}"/>
        </geometry>
        <material name="amber"/>
      </visual>
      <collision>
        <origin xyz="0 0 ${row['length'] / 2}" rpy="0 0 0"/>
        <geometry>
          <box size="${thickness} ${thickness} ${row['length']}"/>
        </geometry>
      </collision>
      <xacro:box_inertial mass="${row['mass']}" x="${thickness}" y="${thickness}" z="${row['length']}">
        <origin xyz="0 0 ${row['length'] / 2}" rpy="0 0 0"/>
      </xacro:box_inertial>
    </link>
    <joint name="${row['name']}_joint" type="revolute">
      <origin xyz="0 0 ${parent_length}" rpy="0 0 0"/>
      <parent link="${row['parent']}"/>
      <child link="${row['name']}"/>
      <axis xyz="0 1 0"/>
      <limit lower="${row['lower']}" upper="${row['upper']}" effort="${row['effort']}" velocity="${row['velocity']}"/>
    </joint>
  </xacro:macro>

  <xacro:macro name="chain" params="rows parent_length">
    <xacro:if value="${len(rows) > 0}">
      <xacro:part row="${rows[0]}" parent_length="${parent_length}"/>
      <xacro:chain rows="${rows[1:]}" parent_length="${rows[0]['length']}"/>
    </xacro:if>
  </xacro:macro>
</robot>
''', xacro=XACRO)
    root = HEAD + fill('''<robot name="@name@" @xacro@>
  <xacro:arg name="table" default="$(find @pkg@)/config/parts.yaml"/>
  <xacro:property name="table" value="${xacro.load_yaml('$(arg table)')}"/>
  <xacro:include filename="@path@materials.xacro"/>
  <xacro:include filename="@path@chain.xacro"/>

  <link name="base_link">
    <visual>
      <geometry>
        <cylinder radius="0.1" length="0.04"/>
      </geometry>
      <material name="slate"/>
    </visual>
    <collision>
      <geometry>
        <cylinder radius="0.1" length="0.04"/>
      </geometry>
    </collision>
  </link>
  <xacro:chain rows="${table['parts']}" parent_length="0.02"/>

  <link name="tool_frame"/>
  <joint name="tool_joint" type="fixed">
    <origin xyz="0 0 0.2" rpy="0 0 ${pi / 4}"/>
    <parent link="@last@"/>
    <child link="tool_frame"/>
  </joint>

  <transmission name="@first@_transmission">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="@first@_joint">
      <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>
    </joint>
    <actuator name="@first@_motor">
      <mechanicalReduction>50</mechanicalReduction>
    </actuator>
  </transmission>
</robot>
''', xacro=XACRO, name=name, pkg=pkg, path='$(find %s)/urdf/' % pkg if package_path else '', first=parts[0], last=parts[-1])
    files = package(pkg, folders=('config', 'urdf'))
    files.update({pkg + '/urdf/%s.urdf.xacro' % name: root, pkg + '/urdf/chain.xacro': macros,
                  pkg + '/urdf/inertials.xacro': INERTIALS, pkg + '/urdf/materials.xacro': MATERIALS,
                  pkg + '/config/parts.yaml': table})
    return files


def plain_arm(name, joints, types):
    """A URDF without xacro, as an exporter writes it, with a gripper that mimics."""
    pkg = name + '_description'
    text = HEAD + '<robot name="%s">\n  <material name="grey">\n    <color rgba="0.6 0.6 0.6 1"/>\n  </material>\n' % name
    size, previous = (0.08, 0.08, 0.2), None
    for i, link in enumerate(['base_link'] + ['%s_%d' % (name, i) for i in range(1, joints)] + ['left_jaw', 'right_jaw']):
        jaw = link.endswith('jaw')
        x, y, z = (0.02, 0.01, 0.06) if jaw else size
        text += fill('''  <link name="@link@">
@inertial@    <visual>
      <origin xyz="0 0 0" rpy="0 0 0"/>
      <geometry>
        @shape@
      </geometry>
      <material name="grey"/>
    </visual>
    <collision>
      <origin xyz="0 0 0" rpy="0 0 0"/>
      <geometry>
        <box size="@x@ @y@ @z@"/>
      </geometry>
    </collision>
  </link>
''', link=link, inertial='' if i == 0 else inertial(0.08 if jaw else round(3.2 - 0.3 * i, 2), x, y, z), x=x, y=y, z=z,
                     shape='<mesh filename="package://%s/meshes/%s.stl"/>' % (pkg, 'jaw' if jaw else 'body'))
        if previous:
            kind = 'prismatic' if jaw else types[i % len(types)]
            limit = {'prismatic': '    <axis xyz="0 1 0"/>\n    <limit lower="0" upper="0.04" effort="20" velocity="0.1"/>\n',
                     'revolute': '    <axis xyz="0 0 1"/>\n    <limit lower="-1.5708" upper="2.1" effort="80" velocity="2.2"/>\n',
                     'continuous': '    <axis xyz="0 1 0"/>\n    <limit effort="60" velocity="3"/>\n', 'fixed': ''}[kind]
            if link == 'right_jaw':
                limit += '    <mimic joint="left_jaw_joint" multiplier="1" offset="0"/>\n'
            text += ('  <joint name="%s_joint" type="%s">\n    <origin xyz="0 0 0.2" rpy="0 0 0"/>\n'
                     '    <parent link="%s"/>\n    <child link="%s"/>\n%s  </joint>\n' % (link, kind, previous, link, limit))
        previous = previous if jaw else link
    files = package(pkg, folders=('meshes', 'urdf'))
    files.update({pkg + '/urdf/%s.urdf' % name: text + '</robot>\n', pkg + '/meshes/body.stl': box_mesh(*size),
                  pkg + '/meshes/jaw.stl': box_mesh(0.02, 0.01, 0.06)})
    return files


def cell(name, joints, count):
    """An arm package, a tool package and a package that joins them, with included names in namespaces."""
    tool, arm_name = name + '_tool', name + '_arm'
    files = arm(arm_name, joints, 1.1, False)
    files.update(package(tool + '_description', folders=('meshes', 'urdf')))
    files[tool + '_description/meshes/body.stl'] = box_mesh(0.05, 0.05, 0.1)
    files[tool + '_description/urdf/%s_macro.xacro' % tool] = HEAD + fill('''<robot @xacro@>
  <xacro:property name="tool_length" value="0.1"/>
  <xacro:property name="tool_mass" value="0.7"/>
  <xacro:macro name="tool" params="prefix parent">
    <link name="${prefix}tool_body">
      <visual>
        <origin xyz="0 0 ${tool_length / 2}" rpy="0 0 0"/>
        <geometry>
          <mesh filename="package://@tool@_description/meshes/body.stl"/>
        </geometry>
      </visual>
      <collision>
        <origin xyz="0 0 ${tool_length / 2}" rpy="0 0 0"/>
        <geometry>
          <box size="0.05 0.05 ${tool_length}"/>
        </geometry>
      </collision>
      <inertial>
        <origin xyz="0 0 ${tool_length / 2}" rpy="0 0 0"/>
        <mass value="${tool_mass}"/>
        <inertia ixx="${tool_mass * (0.0025 + tool_length ** 2) / 12}" ixy="0" ixz="0"
                 iyy="${tool_mass * (0.0025 + tool_length ** 2) / 12}" iyz="0" izz="${tool_mass * 0.005 / 12}"/>
      </inertial>
    </link>
    <joint name="${prefix}tool_joint" type="fixed">
      <origin xyz="0 0 0" rpy="0 0 0"/>
      <parent link="${parent}"/>
      <child link="${prefix}tool_body"/>
    </joint>
    <link name="${prefix}tcp"/>
    <joint name="${prefix}tcp_joint" type="fixed">
      <origin xyz="0 0 ${tool_length}" rpy="0 0 0"/>
      <parent link="${prefix}tool_body"/>
      <child link="${prefix}tcp"/>
    </joint>
  </xacro:macro>
</robot>
''', xacro=XACRO, tool=tool)
    arms = ''.join(fill('''
  <xacro:@arm@ prefix="@side@_" parent="table">
    <origin xyz="@x@ 0 0.36" rpy="0 0 @yaw@"/>
  </xacro:@arm@>
  <xacro:tools.tool prefix="@side@_" parent="@side@_tool0"/>
''', arm=arm_name, side=side, x=x, yaw=yaw) for side, x, yaw in (('left', -0.4, 0), ('right', 0.4, '${pi}'))[:count])
    root = HEAD + fill('''<robot name="@name@" @xacro@>
  <xacro:include filename="$(find @arm@_support)/urdf/@arm@_macro.xacro"/>
  <xacro:include filename="$(find @tool@_description)/urdf/@tool@_macro.xacro" ns="tools"/>

  <xacro:property name="table_size" value="1.6 0.8 0.72"/>
  <link name="world"/>
  <link name="table">
    <visual>
      <geometry>
        <box size="${table_size}"/>
      </geometry>
      <material name="slate"/>
    </visual>
    <collision>
      <geometry>
        <box size="${table_size}"/>
      </geometry>
    </collision>
  </link>
  <joint name="table_joint" type="fixed">
    <origin xyz="0 0 0.36" rpy="0 0 0"/>
    <parent link="world"/>
    <child link="table"/>
  </joint>
@arms@</robot>
''', xacro=XACRO, name=name, arm=arm_name, tool=tool, arms=arms)
    files.update(package(name, depends=(arm_name + '_support', tool + '_description'), folders=('urdf',)))
    files[name + '/urdf/%s.urdf.xacro' % name] = root
    return files
